"""Industrial cameras through their maker's SDK, on its emulation.

``basler``: a scan of a sphere on the virtual rig is recorded; its stereo pairs are then measured from arrays in memory and through
two emulated cameras, by the same threads and engine: largest difference of the points, frames a second, and time of the processor.
The whole scan is repeated too, the virtual controller with the two emulated cameras: its case must hold the same observations.
``live_rig``: the whole job in real time on a board behind a socket and two network cameras (:mod:`tests.bench.cameras.live_rig`).
``pace``: what two cameras in real time cost, by rate, trigger and size, and the frames that they lose.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from collections.abc import Iterator
from dataclasses import fields, replace
from itertools import accumulate
from pathlib import Path

import numpy as np
import psutil

from scanner_core.acquisition.plan import PlanRequest, Row
from scanner_core.case.store import CaseStore
from scanner_core.clock import ScaledClock, SteppedClock
from scanner_core.devices.basler_camera import open_basler
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.virtual.specimens import load_specimen
from tests.bench.cameras import live_rig
from tests.bench.cameras.pairs import Measured, MemoryCamera, TimedCamera, difference_um, measure
from tests.core.devices.basler_emulation import basler_config, open_emulated
from tests.core.devices.recorded_runs import SIDES, RecordedRuns, ShowingCamera, record, scan_again

PRESETS = ("bench", "workshop")
"""604 x 294 and 1440 x 1080 pixels."""
SPHERE = load_specimen("sphere")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["basler", "live_rig", "pace"])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--frames", type=int, default=500, help="stereo pairs")
    parser.add_argument("--preset", nargs="+", choices=PRESETS, default=list(PRESETS))
    parser.add_argument("--rates", type=float, nargs="+", default=[30.0, 60.0, 85.0], help="of `pace`, frames a second")
    parser.add_argument("--seconds", type=float, default=10.0, help="of `pace`, each")
    parser.add_argument("--views", type=int, default=4, help="of `live_rig`")
    parser.add_argument("--points", type=int, default=600, help="of `live_rig`, wanted")
    parser.add_argument("--rate", type=float, default=20.0, help="of `live_rig`, frames a second")
    given = parser.parse_args()
    if given.what == "live_rig":
        with tempfile.TemporaryDirectory(prefix="impronta-live-") as folder:
            for line in live_rig.run(Path(folder), views=given.views, points=given.points, rate_hz=given.rate, seed=given.seed):
                print(json.dumps(line), flush=True)
        return
    os.environ["PYLON_CAMEMU"] = "2"  # read by the SDK whenever it looks for cameras
    for name in given.preset:
        with tempfile.TemporaryDirectory(prefix="impronta-cameras-") as folder:
            told = _basler(name, given, Path(folder)) if given.what == "basler" else _pace(name, given, Path(folder))
            for line in told:
                print(json.dumps(line), flush=True)


def _basler(name: str, given: argparse.Namespace, folder: Path) -> Iterator[dict[str, object]]:
    config, runs = load_preset(name), RecordedRuns(folder / "frames")
    request = PlanRequest(1, given.frames, SPHERE.radius_mm, SPHERE.height_mm)
    live = record(config, SPHERE, given.seed, runs, folder / "live.impronta", request)
    rows = _first(runs.rows(), given.frames)
    direct = _from_memory(config, runs, rows)
    through = _through_sdk(config, runs, rows)
    pairs = sum(row.count for row in rows)
    yield {
        "size_px": size_of(config),
        "seed": given.seed,
        "pairs": pairs,
        "points": len(direct.points),
        "points_through_sdk": len(through.points),
        "greatest_difference_um": difference_um(direct, through),
        "pairs_per_s": round(pairs / direct.wall_s, 1),
        "pairs_per_s_through_sdk": round(pairs / through.wall_s, 1),
        "pace_ratio": round(direct.wall_s / through.wall_s, 3),
        "thread_ms_per_frame": round(500 * direct.thread_s / pairs, 3),
        "thread_ms_per_frame_through_sdk": round(500 * through.thread_s / pairs, 3),
    }
    begin_s = time.perf_counter()
    again = scan_again(config, SPHERE, runs, folder / "again.impronta", request)
    assert live.scan_id is not None
    tables = []
    for case in ("live", "again"):
        with CaseStore.open(folder / f"{case}.impronta") as store:
            tables.append(store.observations(live.scan_id))
    same = all(np.array_equal(getattr(tables[0], column.name), getattr(tables[1], column.name)) for column in fields(tables[0]))
    assert live.views is not None
    assert again.views is not None
    yield {
        "size_px": size_of(config),
        "whole_scan": again.finish_reason.value,
        "exposures": again.exposures,
        "measured": again.counts.measured,
        "same_counts": (again.counts, again.located) == (live.counts, live.located),
        "same_observations": same,
        "same_cloud": bool(np.array_equal(live.views.cloud.points, again.views.cloud.points)),
        "exposures_per_s": round(again.exposures / (time.perf_counter() - begin_s), 1),
    }


def _from_memory(config: RigConfig, runs: RecordedRuns, rows: list[Row]) -> Measured:
    memory = [MemoryCamera(side, size_of(config), 60.0, runs) for side in SIDES]

    def prepared() -> Iterator[Row]:
        for row in rows:
            for camera in memory:
                camera.prepare(row)
            yield row

    left, right = (TimedCamera(camera) for camera in memory)
    return measure(config, ScaledClock(), (left, right), prepared())


def _through_sdk(config: RigConfig, runs: RecordedRuns, rows: list[Row]) -> Measured:
    clock = SteppedClock()
    cameras = [ShowingCamera(open_basler(_wanted(config, side, 60.0, TriggerSource.SOFTWARE), clock), runs) for side in SIDES]
    try:
        return measure(config, clock, (TimedCamera(cameras[0]), TimedCamera(cameras[1])), iter(rows))
    finally:
        for camera in cameras:
            camera.close()


def _pace(name: str, given: argparse.Namespace, folder: Path) -> Iterator[dict[str, object]]:
    config, runs = load_preset(name), RecordedRuns(folder / "frames")
    record(config, SPHERE, given.seed, runs, folder / "live.impronta", PlanRequest(1, 100, SPHERE.radius_mm, SPHERE.height_mm))
    shown = max(runs.rows(), key=lambda row: (row.count, row.first_id))
    for trigger in (TriggerSource.FREE, TriggerSource.SOFTWARE):
        for rate_hz in given.rates:
            clock, count = ScaledClock(), round(given.seconds * rate_hz)
            cameras = [open_emulated(_wanted(config, side, rate_hz, trigger), clock, runs.folder_of(side, shown.first_id)) for side in SIDES]
            used = psutil.Process().cpu_times()
            try:
                row = replace(shown, first_id=0, count=count)
                found = measure(config, clock, (TimedCamera(cameras[0]), TimedCamera(cameras[1])), iter([row]))
                dropped = [camera.report().dropped for camera in cameras]
            finally:
                for camera in cameras:
                    camera.close()
            after = psutil.Process().cpu_times()
            yield {
                "size_px": size_of(config),
                "trigger": trigger.value,
                "rate_hz": rate_hz,
                "planned": count,
                "pairs": found.exposed,
                "dropped": dropped,
                "driver_ms_per_frame": round(500 * found.camera_s / max(found.exposed, 1), 3),
                "thread_ms_per_frame": round(500 * found.thread_s / max(found.exposed, 1), 3),
                "cores": round((after.user + after.system - used.user - used.system) / found.wall_s, 3),
                "load_of_machine": os.getloadavg()[0],
            }


def size_of(config: RigConfig) -> tuple[int, int]:
    """Of the images."""
    assert config.calibration is not None
    return config.calibration.left.size_px


def _wanted(config: RigConfig, side: str, rate_hz: float, trigger: TriggerSource) -> CameraConfig:
    return basler_config(side, size_of(config), rate_hz, trigger, 3.0)


def _first(rows: list[Row], pairs: int) -> list[Row]:
    """Rows until there are so many pairs; the last is cut."""
    chosen = []
    for row, before in zip(rows, accumulate((row.count for row in rows), initial=0), strict=False):
        if before >= pairs:
            break
        chosen.append(replace(row, count=min(row.count, pairs - before)))
    return chosen


if __name__ == "__main__":
    main()
