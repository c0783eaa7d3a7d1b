"""Case files of a size that nobody scans in a test: their observations are computed, not seen."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np

from scanner_core.acquisition.plan import Row, ScanPlan, ViewPlan
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.optics.spot import Spot
from tests.core.geometry.solids import sphere
from tests.core.optics.rigs import known_rig

VIEWS = 8
_BATCH = 20_000


def write_case(path: Path, points: int, *, number: str = "2026-0500", seed: int = 1) -> None:
    """A bumpy ellipsoid of 40 x 28 x 34 mm in 8 views, with 0.02 px of noise; every observation is measured."""
    bench = load_preset("bench").with_calibration(known_rig())
    rig = replace(bench, volume=replace(bench.volume, radius_mm=40.0, height_mm=60.0))
    calibration = rig.calibration
    assert calibration is not None
    rng = np.random.default_rng(seed)
    row = points // VIEWS
    angles = [360.0 * view / VIEWS for view in range(VIEWS)]
    plan = ScanPlan(tuple(ViewPlan(angle, (Row(view, view * row, row, 0.0, -1.0, 1.0),)) for view, angle in enumerate(angles)), 3.0)
    with CaseStore.create(path) as store:
        store.put_order(Order(number, "", "left", "ear"))
        scan = store.begin_scan("scan", dump_rig(rig.with_calibration(None)), calibration.identity(), dump_rig(rig), plan.as_dict())
        for view, angle in enumerate(angles):
            directions = rng.normal(size=(row, 3))
            directions /= np.linalg.norm(directions, axis=1)[:, None]
            bumps = 1.0 + 0.05 * np.sin(7.0 * directions[:, :1]) * np.cos(6.0 * directions[:, 1:2])
            in_rig = calibration.rig_to_object(angle).inverse().apply(directions * bumps * (20, 14, 17) + (2, 0, 25))
            left, right = (camera.project(in_rig) + rng.normal(0, 0.02, (row, 2)) for camera in (calibration.left, calibration.right))
            seen = [
                StereoObservation(view * row + i, view, MEASURED, 0.001 * i, angle, _spot(a), _spot(b))
                for i, (a, b) in enumerate(zip(left.tolist(), right.tolist(), strict=True))
            ]
            for begin in range(0, row, _BATCH):
                store.append(scan, seen[begin : begin + _BATCH])
            store.put_view(scan, view, angle)
        store.end_scan(scan, FinishReason.COMPLETED, ScanCounts(VIEWS * row, VIEWS * row))


def write_orders(folder: Path, count: int) -> None:
    """So many case files with a number each, of which every second has a surface."""
    kinds = []
    for i, (side, kind) in enumerate((("left", "ear"), ("right", "ear"), ("upper", "arch"), ("left", "ear"))):
        path = folder / f"kind{i}.impronta"
        with CaseStore.create(path) as store:
            store.put_order(Order(f"2026-{i:04d}", "", side, kind))
            if i % 2:
                store.put_mesh(sphere(10.0, 60, 30), {})
        kinds.append(path)
    for i in range(count):
        shutil.copyfile(kinds[i % len(kinds)], folder / f"2025-{i:04d}_left_ear.impronta")
    for path in kinds:
        path.unlink()


def _spot(at: list[float]) -> Spot:
    return Spot(at[0], at[1], 1.1, 0.9, 120.0, 3000.0, 20, 0.02)
