"""What a scan asks of its worker process: an answer, an error that is a value, or the end of the waiting."""

from __future__ import annotations

import numpy as np
import psutil
import pytest

from scanner_core.acquisition.assessing import AssessmentRequest, Assessor
from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.observation import ObservationTable
from scanner_core.devices.rig import load_preset
from scanner_core.errors import ReconstructionError, WorkerLostError
from scanner_core.jobs.progress import Cancelled
from scanner_core.jobs.worker import begun_watchers

BENCH = load_preset("bench")


def few_points() -> AssessmentRequest:
    assert BENCH.calibration is not None
    pixel = np.full((3, 2), 200.0)
    table = ObservationTable(
        trigger_id=np.arange(3, dtype=np.int64),
        view=np.zeros(3, np.int32),
        table_deg=np.zeros(3),
        left_px=pixel,
        right_px=pixel,
        left_uncertainty_px=np.full(3, 0.02),
        right_uncertainty_px=np.full(3, 0.02),
        left_sigma_px=np.ones((3, 2)),
        right_sigma_px=np.ones((3, 2)),
    )
    exposed = table.trigger_id, table.table_deg, np.array(["measured"] * 3, np.object_)
    return AssessmentRequest(table, ScanPlan((), 1.0), exposed, BENCH, BENCH.calibration, 60.0, 40.0, 30.0, 100, 0, 0)


def test_a_process_that_is_killed_is_a_value_and_the_next_answers() -> None:
    def kill(pid: int) -> None:
        psutil.Process(pid).kill()

    with Assessor() as assessor:
        begun_watchers.append(kill)
        try:
            lost = assessor(few_points(), lambda: False)
        finally:
            begun_watchers.remove(kill)
        assert isinstance(lost, WorkerLostError)
        assert lost.code == "E-JOB-01"
        assert isinstance(assessor(few_points(), lambda: False), ReconstructionError)


def test_who_waits_ends_it() -> None:
    def broken() -> bool:
        raise OSError("the cable came off")

    with Assessor() as assessor, pytest.raises(Cancelled):
        assessor(few_points(), lambda: True)
    with Assessor() as assessor, pytest.raises(OSError, match="cable"):
        assessor(few_points(), broken)
