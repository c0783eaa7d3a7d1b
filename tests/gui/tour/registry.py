"""Which function brings which scenes about, in the order of the tour."""

from __future__ import annotations

from collections.abc import Callable

from tests.gui.tour.tour import Bring

SCENES: dict[str, Bring] = {}


def scenes(*names: str) -> Callable[[Bring], Bring]:
    """The decorated function yields these names, in this order."""

    def add(bring: Bring) -> Bring:
        SCENES.update(dict.fromkeys(names, bring))
        return bring

    return add


def names_of(bring: Bring) -> list[str]:
    """Of the scenes that the function brings about."""
    return [name for name, one in SCENES.items() if one is bring]
