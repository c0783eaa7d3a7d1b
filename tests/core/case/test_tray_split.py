"""A run of a pair tray becomes a case for each ear, and nothing that was measured is lost."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.processing import case_cloud
from scanner_core.case.store import CaseStore, Order
from scanner_core.case.tray_split import seats_of, split_pair
from scanner_core.devices.pair_tray import PAIR_TRAY, PairTray, Seat, Side
from scanner_core.errors import CaseError, StorageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.virtual.specimens import load_specimen
from tests.core.case.test_processing import small_case

# The case of the tests holds one body: seats left and right of its middle cut it in two.
TRAY = PairTray((Seat("left", -10.0, 0.0), Seat("right", 14.0, 0.0)), clear_mm=0.0)


@pytest.fixture
def run(tmp_path: Path) -> CaseStore:
    (tmp_path / "run.impronta").write_bytes(small_case())
    store = CaseStore.open(tmp_path / "run.impronta")
    store.put_order(Order(number="2026-7", patient_code="P-7", type="ear"))
    return store


def _paths(folder: Path) -> dict[Side, Path]:
    return {"left": folder / "left.impronta", "right": folder / "right.impronta"}


def test_each_ear_gets_its_points_and_everything_that_was_measured(run: CaseStore, tmp_path: Path) -> None:
    with run:
        whole = case_cloud(run).points
        paths = _paths(tmp_path)
        counts = split_pair(run, paths, TRAY)
        assert np.array_equal(case_cloud(run).points, whole)  # the run itself stays as it was
        parts = {}
        for side, path in paths.items():
            with CaseStore.open(path) as part:
                assert (part.order().number, part.order().side, part.order().patient_code) == ("2026-7", side, "P-7")
                assert len(part.scans()) == len(run.scans())
                parts[side] = case_cloud(part).points
                part.undo()  # the split
                assert np.array_equal(case_cloud(part).points, whole)
    assert counts == {side: len(points) for side, points in parts.items()}
    assert parts["left"][:, 0].max() < 2.0 < parts["right"][:, 0].min()
    both = np.concatenate([parts["left"], parts["right"]])
    np.testing.assert_array_equal(both[np.lexsort(both.T)], whole[np.lexsort(whole.T)])


def test_the_run_may_be_the_case_of_one_ear_and_an_order_that_waits_gives_way(run: CaseStore, tmp_path: Path) -> None:
    paths: dict[Side, Path] = {"left": tmp_path / "run.impronta", "right": tmp_path / "right.impronta"}
    with CaseStore.create(paths["right"]) as waiting:
        waiting.put_order(Order(number="2026-7", side="right", type="ear"))
    with run:
        counts = split_pair(run, paths, TRAY)
        assert run.order().side == "left"
        assert len(case_cloud(run)) == counts["left"]
        with CaseStore.open(paths["right"]) as right:
            assert len(case_cloud(right)) == counts["right"]
        with pytest.raises(StorageError, match="E-DISK-03"):
            split_pair(run, paths, PairTray((Seat("left", -30.0, 0.0), Seat("right", 6.0, 0.0)), clear_mm=0.0))  # it holds a scan now
        assert len(case_cloud(run)) == counts["left"]


def test_what_lies_between_the_seats_is_told_and_nothing_is_split(run: CaseStore, tmp_path: Path) -> None:
    with run:
        for tray, code in (
            (PairTray(TRAY.seats, clear_mm=4.0), "E-TRAY-01"),
            (PairTray((Seat("left", 60.0, 0), Seat("right", -10.0, 0))), "E-TRAY-02"),
        ):
            with pytest.raises(CaseError, match=code):
                split_pair(run, _paths(tmp_path), tray)
    assert [path.name for path in tmp_path.iterdir()] == ["run.impronta"]


def test_the_virtual_pair_stands_on_the_tray() -> None:
    pair = load_specimen("ear-pair")
    seats = seats_of(PointCloud(pair.mesh.vertices), PAIR_TRAY, Path("pair"))
    left, right = (pair.mesh.vertices[seats[side]] for side in ("left", "right"))
    assert pair.radius_mm <= PAIR_TRAY.radius_mm
    for seat, part in zip(PAIR_TRAY.seats, (left, right), strict=True):
        assert np.hypot(*(part[:, :2] - [seat.x_mm, seat.y_mm]).T).max() < 13.0
    # mirrored, and not the same: no more than a few per cent of an ear's size
    mirrored = np.array([PAIR_TRAY.seats[1].x_mm - left[:, 0] + PAIR_TRAY.seats[0].x_mm, left[:, 1], left[:, 2]]).T
    apart = np.linalg.norm(mirrored - right, axis=1)
    assert 0.1 < apart.mean() < 1.0
