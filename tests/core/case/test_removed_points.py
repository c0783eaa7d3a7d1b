"""Points that a person took out: kept compactly, found again by what they were measured as, and none of the others moves."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.__main__ import main
from scanner_core.case.edits import PROCESSING
from scanner_core.case.processing import Gates, Processing, chosen_processing, process_case
from scanner_core.case.removed_points import RemovedPoints
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig
from scanner_core.errors import CaseError, CaseFormatError
from scanner_core.geometry.point_cloud import PointCloud
from tests.core.case.test_processing import RIG, same, small_case

Pairs = set[tuple[int, int]]
PAIRS = st.sets(st.tuples(st.integers(0, 2**53), st.integers(0, 2**20 - 1)), max_size=40)


@pytest.fixture
def store(tmp_path: Path) -> Iterator[CaseStore]:
    (tmp_path / "a.impronta").write_bytes(small_case())
    with CaseStore.open(tmp_path / "a.impronta") as store:
        yield store


def _of(pairs: Pairs) -> RemovedPoints:
    ids, places = (np.array([pair[i] for pair in pairs], np.int64) for i in (0, 1))
    return RemovedPoints.of(ids, places)


@settings(max_examples=60, deadline=None)
@given(PAIRS, PAIRS)
def test_a_set_of_points_is_that_set_again_after_json(held: Pairs, asked: Pairs) -> None:
    removed = _of(held)
    again = RemovedPoints.from_dict(json.loads(json.dumps(removed.as_dict())))
    assert again == removed
    assert {(int(a), int(b)) for a, b in again.pairs()} == held
    everything = sorted(held | asked)
    ids, places = (np.array([pair[i] for pair in everything], np.int64) for i in (0, 1))
    assert again.among(ids, places).tolist() == [pair in held for pair in everything]


def test_half_of_a_large_scan_fits_into_a_case() -> None:
    out = np.flatnonzero(np.random.default_rng(3).random(500_000) < 0.4)
    removed = RemovedPoints.of(out)
    assert len(removed.packed) < 200_000
    assert np.array_equal(np.flatnonzero(removed.among(np.arange(500_000))), out)


@pytest.mark.parametrize(
    "value",
    [[], {"count": 1}, {"count": -1, "points": ""}, {"count": 1, "points": "eJw="}, {"count": 1, "points": "*"}, {"count": 3, "points": 7}],
)
def test_what_cannot_be_such_a_set_is_refused(store: CaseStore, value: object) -> None:
    store.edit(PROCESSING, {"removed": value}, "by hand")
    with pytest.raises(CaseFormatError, match="E-CASE-01"):
        chosen_processing(store)


def test_more_than_the_count_says_is_refused() -> None:
    told = RemovedPoints.of(np.arange(1000)).as_dict()
    with pytest.raises(ValueError, match="other than 999"):
        RemovedPoints.from_dict(told | {"count": 999})


def test_the_other_points_stay_to_the_last_bit(store: CaseStore) -> None:
    whole = process_case(store, Processing())
    out = np.random.default_rng(1).random(len(whole.cloud)) < 0.3
    done = process_case(store, Processing(removed=RemovedPoints.of_cloud(whole.cloud.select(out))))
    assert same(done.cloud, whole.cloud.select(~out))
    assert done.taken_out is not None
    assert same(done.taken_out, whole.cloud.select(out))
    assert not done.registered
    counts = done.counts
    assert counts.rejected["removed"] == out.sum() == whole.counts.measured - counts.measured
    assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
    assert whole.taken_out is None


def test_they_stay_out_with_another_calibration_and_other_gates(store: CaseStore) -> None:
    assert RIG.calibration is not None
    right = RIG.calibration.right
    other = replace(RIG.calibration, right=replace(right, translation=right.translation * 1.01), date="2026-02-02")
    store.put_calibration(other.identity(), dump_rig(RIG.with_calibration(other)))
    whole = process_case(store, Processing()).cloud
    removed = RemovedPoints.of_cloud(whole.select(whole.points[:, 2] < 20.0))
    for choice in (Processing(other.identity(), removed=removed), Processing(gates=Gates(least_peak_dn=100), removed=removed)):
        cloud = process_case(store, choice).cloud
        assert cloud.trigger_ids is not None
        assert not removed.among(cloud.trigger_ids).any()
        assert len(cloud) > 100


def test_all_taken_out_is_told_and_an_edit_is_undone(store: CaseStore) -> None:
    whole = process_case(store, Processing()).cloud
    with pytest.raises(CaseError, match="bring back"):
        process_case(store, Processing(removed=RemovedPoints.of_cloud(whole)))
    store.edit(PROCESSING, Processing(removed=RemovedPoints.of_cloud(whole.select(np.arange(7)))).as_dict(), "Points taken out")
    assert len(process_case(store, chosen_processing(store)).cloud) == len(whole) - 7
    store.undo()
    assert chosen_processing(store) == Processing()


def test_the_command_line_tells_and_keeps_them(store: CaseStore, capsys: pytest.CaptureFixture[str]) -> None:
    whole = process_case(store, Processing()).cloud
    removed = RemovedPoints.of_cloud(whole.select(np.arange(12)))
    store.edit(PROCESSING, Processing(removed=removed).as_dict(), "Points taken out")
    store.close()
    assert main(["info", str(store.path)]) == 0
    assert "Points: as scanned, 12 taken out by hand" in capsys.readouterr().out
    assert main(["info", str(store.path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["processing"]["removed"] == removed.told()


def test_a_provenance_tells_how_many(store: CaseStore) -> None:
    whole = process_case(store, Processing()).cloud
    removed = RemovedPoints.of_cloud(whole.select(np.arange(12)))
    told = process_case(store, Processing(removed=removed)).provenance()["processing"]
    assert isinstance(told, dict)
    assert told["removed"] == {"count": 12, "digest": removed.told()["digest"]}


def test_points_without_a_name_are_never_among_them() -> None:
    assert not RemovedPoints.of(np.arange(3)).of_points(PointCloud(np.zeros((3, 3)))).any()
    with pytest.raises(ValueError, match="trigger ids"):
        RemovedPoints.of_cloud(PointCloud(np.zeros((3, 3))))
