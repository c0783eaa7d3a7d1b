"""Two surfaces that do not belong together are told apart before anything is aligned."""

from __future__ import annotations

from dataclasses import replace

import pytest

from scanner_core.comparison.pair_doubts import pair_doubts
from scanner_core.comparison.surface import ComparedSurface
from tests.core.comparison.compared import named
from tests.core.comparison.shapes import cut, egg, scaled


def codes(before: ComparedSurface, after: ComparedSurface) -> list[tuple[str, bool]]:
    return [(doubt.code, doubt.serious) for doubt in pair_doubts(before, after)]


def test_two_good_surfaces_give_no_doubt() -> None:
    before = named(egg(), "a", side="left", type="arch", date="2026-01-01T10:00:00+00:00", patient_code="x")
    after = named(cut(egg(), 15.0), "b", side="", type="Arch ", date="2026-03-01T10:00:00+00:00", patient_code="x")
    assert codes(before, after) == []


def test_identical_files_are_named() -> None:
    before = named(egg(), "a")
    assert codes(before, before) == [("identical-files", True)]
    assert codes(before, named(egg(), "b")) == [("identical-surfaces", True)]
    assert codes(before, named(egg(60.001), "b")) == []


@pytest.mark.parametrize(
    ("key", "first", "second", "code"),
    [
        ("type", "upper arch", "lower arch", "types-differ"),
        ("side", "left", "right", "sides-differ"),
        ("type", "arch", "ear", "types-differ"),
        ("patient_code", "a1", "b2", "patients-differ"),
    ],
)
def test_orders_that_contradict_each_other(key: str, first: str, second: str, code: str) -> None:
    before, after = named(egg(), "a"), named(egg(61.0), "b")
    assert codes(replace(before, origin={key: first}), replace(after, origin={key: second})) == [(code, True)]


def test_orders_that_say_more_or_less_agree() -> None:
    before = named(egg(), "a", type="arch", side="left")
    assert codes(before, named(egg(61.0), "b", type="Arch-treated", side="left ear")) == []


@pytest.mark.parametrize(("factor", "unit"), [(25.4, "inches"), (0.1, "centimetres"), (1 / 2.54, "inches"), (4.0, "")])
def test_another_size_is_named_with_its_likely_unit(factor: float, unit: str) -> None:
    (doubt,) = pair_doubts(named(egg(), "a"), named(scaled(egg(), factor), "b"))
    assert (doubt.code, doubt.serious) == ("sizes-differ", True)
    assert (unit or "check the units,") in doubt.words


def test_exchanged_dates_are_asked_about() -> None:
    before = named(egg(60.0), "a", date="2026-03-01T10:00:00+01:00")
    after = named(egg(61.0), "b", date="2026-03-01T09:30:00+01:00")
    assert codes(before, after) == [("dates-exchanged", False)]
    assert codes(after, before) == []
    assert codes(before, replace(after, origin={"date": "yesterday"})) == []
