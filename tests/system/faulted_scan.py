"""A tiny scan on the virtual rig while something goes wrong, and everything that must hold afterwards."""

from __future__ import annotations

import faulthandler
import os
import sqlite3
import sys
import threading
import time
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from multiprocessing import resource_tracker
from pathlib import Path

import numpy as np
import psutil

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.observation import StereoObservation
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.virtual import firmware_registry
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.specimens import load_specimen

LONGEST_S = 60.0
"""Real seconds after which a run counts as hung; the longest deadline of a scan is 30 s."""
WHOLE_RUN_S = 26.0
"""Of the rig's clock: locating, two views, closing the turn."""

GOES_ON = frozenset({None})
ENDS: dict[str, frozenset[str | None]] = {
    "camera_unplugged": frozenset({"E-CAM-02"}),
    "camera_stalled": frozenset({"E-CAM-01"}),
    "frames_dropped": GOES_ON,
    "frames_late": GOES_ON,
    "frames_torn": GOES_ON,
    "camera_bumped": GOES_ON,
    "camera_skew": GOES_ON,
    "trigger_lost": GOES_ON,
    "lost_steps": GOES_ON,
    "lenses_warm": GOES_ON,
    "mark_knocked_off": GOES_ON,
    "lamp_on": frozenset({None, "E-SCAN-06"}),  # a lamp from the beginning: no surface is found
    "shiny_patch": GOES_ON,
    "lid_opened": frozenset({"E-MOT-16"}),
    "controller_reset": frozenset({"E-MOT-09"}),
    "alarm_1": frozenset({"E-MOT-05"}),
    "alarm_2": frozenset({"E-MOT-05"}),
    "alarm_3": frozenset({"E-MOT-05"}),
    "port_gone": frozenset({"E-MOT-02"}),
    "port_back": frozenset({"E-MOT-02"}),
    # a garbled report is asked for again; a garbled ok, error or state is not
    "serial_noise": frozenset({None, "E-MOT-01", "E-MOT-06", "E-MOT-18"}),
    "partial_lines": GOES_ON,
    "lost_ok": frozenset({"E-MOT-01"}),
    "disk_full": frozenset({"E-DISK-01"}),
    "case_locked": GOES_ON,
    "clock_jump": GOES_ON,
}
"""How a scan may end, by fault: the code of its error, or None when it goes on to its end."""


@dataclass(frozen=True)
class Ended:
    """How a run ended, and what is wrong with that."""

    result: ScanResult
    seconds: float
    reached: bool
    """Whether the rig's clock came to the last fault's time."""
    problems: list[str]

    @property
    def code(self) -> str | None:
        return None if self.result.error is None else self.result.error.code


class Acknowledging(CaseStore):
    """Remembers what was acknowledged."""

    acknowledged: set[int]

    def append(self, scan_id: int, observations: Sequence[StereoObservation]) -> None:
        super().append(scan_id, observations)
        self.acknowledged |= {observation.trigger_id for observation in observations}


def scan_with(faults: Sequence[Fault], folder: Path, seed: int = 5, points: int = 120) -> Ended:
    """Scan the sphere, two views; `folder` must be new."""
    folder.mkdir()
    path, body = folder / "a.impronta", load_specimen("sphere")
    if sys.platform != "win32":
        resource_tracker.ensure_running()  # multiprocessing keeps one, with a handle of its own, from its first use on
    before, handles = set(threading.enumerate()), _handles()
    begin_s = time.monotonic()
    faulthandler.dump_traceback_later(LONGEST_S + 5.0, exit=True)
    try:
        with Acknowledging.create(path) as store, open_rig(load_preset("bench"), body, "max", seed, faults) as rig:
            assert isinstance(store, Acknowledging)
            assert rig.faults is not None
            store.acknowledged = set()
            rig.concern(store)
            runner = ScanRunner(rig, PlanRequest(2, points, object_radius_mm=body.radius_mm, object_height_mm=body.height_mm), store)
            runner.start()
            assert runner.join(LONGEST_S), "the scan hangs"
            result = runner.result
            assert result is not None
            board = rig.faults.board
            assert isinstance(board, Firmware)
            reached = rig.clock.now_s() >= max((fault.at_s for fault in faults), default=0.0) + 1.0
            problems = _at_rest(rig, board)
    finally:
        faulthandler.cancel_dump_traceback_later()
    seconds = time.monotonic() - begin_s
    problems += _counts(result) + _case(path, store.acknowledged, board) + _nothing_left(before, handles)
    return Ended(result, seconds, reached, problems)


def ball(count: int = 4000) -> PointCloud:
    """Points that make a mesh in some seconds: a sphere of 11 mm, 20 um of noise."""
    draw = np.random.default_rng(5)
    directions = draw.normal(size=(count, 3))
    return PointCloud(directions / np.linalg.norm(directions, axis=1)[:, None] * draw.normal(11.0, 0.02, (count, 1)))


def unexpected(ended: Ended, name: str) -> list[str]:
    """What is wrong with the end of a run in which one fault happened, or was to happen later."""
    allowed = ENDS[name] if ended.reached else ENDS[name] | {None}
    problems = list(ended.problems)
    if ended.code not in allowed:
        problems.append(f"ended with {ended.result.error}, not with {sorted(map(str, allowed))}")
    return problems


def _at_rest(rig: OpenRig, board: Firmware) -> list[str]:
    rig.clock.sleep(30.0)  # what the controller has still to do by itself, when nobody can tell it to stop
    place = board.instant(rig.clock.now_s())
    rig.clock.sleep(1.0)
    later = board.instant(rig.clock.now_s())
    problems = [] if later == place else ["the controller still moves"]
    log = board.laser_log
    return problems + (["the laser is lit"] if later.laser_power or (log and log[-1][1] > 0.0) else [])


def _counts(result: ScanResult) -> list[str]:
    counts, problems = result.counts, []
    if counts.skipped < 0 or counts.planned != counts.measured + sum(counts.rejected.values()) + counts.skipped:
        problems.append(f"the counts do not balance: {counts}")
    if (result.finish_reason is FinishReason.FAILED) != (result.error is not None):
        problems.append(f"{result.finish_reason} with the error {result.error}")
    if result.error is not None and (len(str(result.error).splitlines()) != 1 or not result.error.hint):
        problems.append(f"no sentence with a remedy: {result.error}")
    return problems


def _case(path: Path, acknowledged: set[int], board: Firmware) -> list[str]:
    problems = []
    with closing(sqlite3.connect(path)) as connection:
        (verdict,) = connection.execute("PRAGMA integrity_check").fetchone()
        kept = {number for (number,) in connection.execute("SELECT trigger_id FROM observation")}
        intruders = connection.execute("SELECT count(*) FROM audit WHERE event = 'intruder'").fetchone()[0]
    if verdict != "ok":
        problems.append(f"the case is damaged: {verdict}")
    if acknowledged - kept:
        problems.append(f"{len(acknowledged - kept)} acknowledged observations are lost")
    if intruders:
        problems.append("another program wrote into the open case")
    if [beside.name for beside in path.parent.iterdir()] != [path.name]:
        problems.append(f"beside the case: {sorted(beside.name for beside in path.parent.iterdir())}")
    with CaseStore.open(path) as store:
        store.scans()
    if any(claimed is board for claimed in firmware_registry._claimed):
        problems.append("the port was not released")
    return problems


def _nothing_left(before: set[threading.Thread], handles: int) -> list[str]:
    end_s = time.monotonic() + 2.0
    threads = [thread for thread in threading.enumerate() if thread not in before]
    for thread in threads:
        thread.join(max(0.0, end_s - time.monotonic()))
    problems = [f"thread {thread.name} is left" for thread in threads if thread.is_alive()]
    if _handles() > handles:
        problems.append(f"{_handles() - handles} file handles are left")
    return problems


def _handles() -> int:
    """Open files and sockets; 0 where the system does not tell."""
    if sys.platform != "linux":
        return psutil.Process().num_handles() if sys.platform == "win32" else 0
    return len(os.listdir("/proc/self/fd"))
