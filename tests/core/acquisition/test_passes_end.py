"""Error-driven scans that cannot go on as they were: no light, no surface, no room, no disk."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from scanner_core.acquisition.assessing import Assessment, AssessmentRequest
from scanner_core.acquisition.control import ScanControl
from scanner_core.acquisition.error_driven import ErrorDriven
from scanner_core.acquisition.following import Pass
from scanner_core.acquisition.passes import PassesEnd
from scanner_core.acquisition.plan import ViewPlan
from scanner_core.acquisition.planning import renumbered
from scanner_core.case.store import CaseStore
from scanner_core.errors import StorageError
from tests.core.acquisition.test_error_driven import BENCH, REQUEST, Bench, Script, passes, refuses


@pytest.fixture
def store(tmp_path: Path) -> Iterator[CaseStore]:
    with CaseStore.create(tmp_path / "a.impronta") as opened:
        yield opened


def test_shares_are_those_of_the_coverage_and_the_plan_tells_the_gain(store: CaseStore) -> None:
    def answer(request: AssessmentRequest) -> Assessment:
        found = passes(0.5, 0.7, 33.0)(request)
        return replace(found, coverage=replace(found.coverage, reachable_within_fraction=0.6))

    told = Bench(store, Script(answer, passes(1.0, 1.0))).run()
    (coarse, steered) = told.passes
    assert (coarse.within_after, steered.within_before, steered.within_after) == (0.6, 0.6, 1.0)
    assert steered.within_predicted == pytest.approx(0.8)


def test_where_no_light_is_found_any_more_it_ends(store: CaseStore) -> None:
    told = Bench(store, Script(*[passes(0.1, 0.9, 33.0)] * 3), least=0).run()
    assert (told.end, [one.points for one in told.passes]) == (PassesEnd.NO_GAIN, [0, 0, 0])


@pytest.mark.parametrize(("before", "kinds", "end"), [(354, 3, PassesEnd.UNIFORM), (356, 2, PassesEnd.VIEWS_SPENT)])
def test_what_is_spread_evenly_is_no_more_than_a_case_holds(
    store: CaseStore, monkeypatch: pytest.MonkeyPatch, before: int, kinds: int, end: PassesEnd
) -> None:
    bench = Bench(store, Script(passes(0.5, 0.9, *np.linspace(0, 300, before), quota=0), refuses, refuses))

    def evenly(whole: Pass, rest: int) -> tuple[ViewPlan, ...]:
        return renumbered(whole.plan.views[:4], len(whole.plan.views))

    monkeypatch.setattr(bench.steering, "_evenly", evenly)
    told = bench.run()
    assert (told.end, len(told.passes)) == (end, kinds)
    assert bench.steering.views == min(before + 8, 360)
    assert any("spread evenly" in line for line in told.summary()) == (kinds == 3)
    assert any("E-REC-02" in line for line in told.summary())


def test_a_pass_that_the_case_could_not_take_is_none(store: CaseStore, monkeypatch: pytest.MonkeyPatch) -> None:
    bench = Bench(store, Script(passes(0.5, 0.9, 33.0)))

    def full(scan_id: int, plan: dict[str, object]) -> None:
        raise StorageError("E-DISK-01", path=store.path, reason="no space left")

    monkeypatch.setattr(store, "extend_plan", full)
    with pytest.raises(StorageError):
        bench.run()
    assert bench.steering.views == 4


def test_one_that_goes_on_tells_the_pass_that_it_is_in(store: CaseStore) -> None:
    bench = Bench(store, Script(passes(0.5, 0.9, 33.0), passes(1.0, 1.0)))
    told = bench.run()
    assert BENCH.calibration is not None
    again = ErrorDriven(bench.rig, BENCH.calibration, store, REQUEST, ScanControl(), cast(Any, bench.follower), Script(), told.passes)
    assert (again.status().number, again.status().within) == (2, 1.0)
