"""Every state of the laser with everything that can happen in it, at speed 1, witnessed by the firmware's own process."""

from __future__ import annotations

import time
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.status import FinishReason, ScanState
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.boards import RemoteBoard, remote_board
from tests.core.devices.laser_states import BOARD_EVENTS, DARK_WITHIN_S, SIGNALS, happen
from tests.core.devices.victim import ENDS, STATES

pytestmark = [pytest.mark.long, pytest.mark.skipif("SIGHUP" not in SIGNALS, reason="signals")]

EVENTS = (*SIGNALS, *BOARD_EVENTS, *ENDS, "guardian")
CODES = {"open_door": "E-MOT-16", "trip_limit": "E-MOT-05", "power_cycle": "E-MOT-09", "guardian": "E-MOT-10"}


def test_the_program_in_every_state_and_every_event() -> None:
    latest: dict[str, float] = defaultdict(float)
    with remote_board() as remote:
        for state in STATES:
            for event in EVENTS if state != "turning" else [event for event in EVENTS if event not in ENDS]:
                seen = happen(remote, state, event)
                assert seen.dark_after_s < DARK_WITHIN_S[event], (state, event)
                assert not seen.lit_again, (state, event)
                if event in CODES and state not in ("idle", "turning"):
                    assert CODES[event] in seen.said, (state, event)
                latest[event] = max(latest[event], seen.dark_after_s)
        for state in ("sweep", "standing"):
            latest["hang"] = max(latest["hang"], happen(remote, state, "hang").dark_after_s)
    print(", ".join(f"{event} {after_s:.3f} s" for event, after_s in latest.items()))
    assert latest["hang"] < DARK_WITHIN_S["hang"]


PHASES = {"locating": ScanState.PREPARING, "sweeping": ScanState.SCANNING, "paused": ScanState.PAUSED}


def lit(remote: RemoteBoard) -> bool:
    log = remote.witness.laser_log()
    return bool(log) and log[-1][1] > 0.0


def scan_and(remote: RemoteBoard, phase: str, event: str, folder: Path) -> tuple[float, str | None]:
    """Dark so long after the event, and the code of the scan's error."""
    config = replace(load_preset("bench"), controller=remote.config)
    specimen = load_specimen("sphere")
    path = folder / f"{phase}-{event}.impronta"
    with open_rig(config, specimen, 1) as rig, CaseStore.create(path) as store:
        request = PlanRequest(views=2, points=20_000, object_radius_mm=specimen.radius_mm, object_height_mm=specimen.height_mm)
        runner = ScanRunner(rig, request, store)
        runner.start()
        end_s = time.monotonic() + 120.0
        while not (runner.status().state is PHASES[phase] and (phase == "paused" or lit(remote))):
            assert time.monotonic() < end_s, phase
            assert runner.status().finish_reason is None, runner.result
            if phase == "paused" and lit(remote):
                runner.pause()
            time.sleep(0.005)
        at_s = time.monotonic()
        if event == "cancel":
            runner.cancel()
        elif event == "camera":
            rig.left.close()
        else:
            remote.witness.happen(event)
        time.sleep(0.8)
        log = remote.witness.laser_log()
        if phase == "paused" and event != "cancel":
            remote.witness.happen("close_door")
            runner.resume()
        assert runner.join(30.0)
        if event == "open_door":
            remote.witness.happen("close_door")
        result = runner.result
        assert result is not None
        counts = result.counts
        assert counts.planned == counts.measured + sum(counts.rejected.values()) + counts.skipped
        assert result.finish_reason is (FinishReason.CANCELLED if event == "cancel" else FinishReason.FAILED), result
        changed_s, power = log[-1]
        assert power == 0.0, (phase, event)
        return max(0.0, changed_s - at_s), None if result.error is None else result.error.code


@pytest.mark.parametrize("phase", list(PHASES))
def test_a_scan_in_every_phase_and_every_event(phase: str, tmp_path: Path) -> None:
    expected = {"cancel": None, "trip_limit": "E-MOT-05", "power_cycle": "E-MOT-09", "open_door": "E-MOT-16", "camera": None}
    with remote_board() as remote:
        for event, code in expected.items():
            if phase == "paused" and event in ("open_door", "camera"):
                continue  # nothing is lit, and nothing has to end: it is asked for again when the scan goes on
            after_s, told = scan_and(remote, phase, event, tmp_path)
            print(f"{phase} {event}: dark after {after_s:.3f} s, {told}")
            assert after_s < (0.7 if event == "camera" else 0.2), (phase, event)
            if code is not None:
                assert told == code, (phase, event)
