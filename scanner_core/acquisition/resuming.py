"""Whether, and with what, an interrupted scan can go on."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from scanner_core.acquisition.known_points import KnownPoints
from scanner_core.acquisition.remaining import Remaining, remaining_plan
from scanner_core.case.recovery import Interruption
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig, parse_rig
from scanner_core.errors import AcquisitionError, CalibrationError
from scanner_core.optics.calibration import StereoCalibration


@dataclass(frozen=True, slots=True)
class Resumption:
    """What is left to do of a scan, and how many observations there are of each verdict."""

    remaining: Remaining
    verdicts: dict[str, int]


def resumption(store: CaseStore, interruption: Interruption, known: KnownPoints, again: Collection[int] = ()) -> Resumption | None:
    """The rest of an interrupted scan; None when it was locating, or holds too few points to tell whether it may go on.

    Parameters
    ----------
    again : views that are going to be measured once more
    """
    record, plan = interruption.record, interruption.plan
    if record.kind != "scan" or not known.views_to_check(len(plan.views)):
        return None
    measured = np.bincount(known.views, minlength=len(plan.views))
    begins = [one.first_view for one in interruption.passes]
    return Resumption(remaining_plan(plan, store.exposed_ids(record.id), measured, begins, again), store.verdict_counts(record.id))


def expect_same_rig(store: CaseStore, interruption: Interruption, config: RigConfig, calibration: StereoCalibration) -> None:
    """Refuse a rig that measures otherwise than the one with which the scan was begun; ports and speeds may differ.

    Raises
    ------
    CalibrationError
        E-CAL-06.
    AcquisitionError
        E-SCAN-05.
    """
    if interruption.record.calibration_id != calibration.identity():
        raise CalibrationError("E-CAL-06", path=store.path)
    begun = parse_rig(store.rig_toml(interruption.record.id), str(store.path))
    for part in ("volume", "spot", "laser"):
        if getattr(begun, part) != getattr(config, part):
            raise AcquisitionError("E-SCAN-05", part=part, path=store.path)
