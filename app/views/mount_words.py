"""What is told of a mount: its colour, and in one line how it lies on the others."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QCoreApplication

from app.views import format as fmt
from scanner_core.sentences import SENTENCES

if TYPE_CHECKING:
    from scanner_core.case.mount_registration import MountOutcome

_COLOURS: Final = ("#d8d2c4", "#56b4e9", "#e69f00", "#00a67a", "#cc79a7", "#f0e442")


def mount_colour(mount: int) -> str:
    """Of its points."""
    return _COLOURS[mount % len(_COLOURS)]


def mount_title(mount: int) -> str:
    """Counted from one, as people do."""
    return QCoreApplication.translate("mounts", "Mount {n}").format(n=mount + 1)


def mount_line(outcome: MountOutcome, first_mount: int) -> str:
    """Overlap, residual, margin to the second-best pose, uniqueness."""
    translate = QCoreApplication.translate
    if outcome.mount == first_mount:
        return translate("mounts", "{points} points; the others lie on it").format(points=fmt.count(outcome.points))
    if outcome.pose is None:
        return translate("mounts", "{points} points, kept apart").format(points=fmt.count(outcome.points))
    values: dict[str, Any] = outcome.as_dict(first_mount)
    parts = []
    if values["overlap_fraction"] is not None:
        parts.append(translate("mounts", "{share} % overlap").format(share=fmt.percent(values["overlap_fraction"])))
        parts.append(translate("mounts", "{um} µm residual").format(um=fmt.micrometres(values["residual_um"])))
    if outcome.start == "picked":
        parts.append(translate("mounts", "from your points"))
    elif values["margin"] is not None:
        parts.append(translate("mounts", "margin to the second-best pose {margin}").format(margin=fmt.decimal(values["margin"], 2)))
        if values["unique"]:
            parts.append(translate("mounts", "unique"))
    return ", ".join(parts)


def refusal(outcome: MountOutcome) -> str:
    """Why it was not joined, in the window's language."""
    return QCoreApplication.translate("sentences", SENTENCES[outcome.code].what).format(**fmt.own_mark(outcome.fields))
