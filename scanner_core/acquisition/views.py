"""From the observations of a scan to one registered cloud.

"Classical registration": the turntable's pose brings every view into the object frame, then a robust point-to-plane
refinement over all views takes out what the axis' calibration left; its residuals before and after are stated.
"""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.case.closure import CLOSURE
from scanner_core.case.line_points import measured_cloud, scan_table
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import RegistrationResult, register_views
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import NoiseModel


@dataclass(frozen=True, slots=True, eq=False)
class RegisteredViews:
    """The cloud of all views in the object frame, how the views were brought together, and the noise of the points."""

    cloud: PointCloud
    registration: RegistrationResult
    noise: NoiseModel


def register_case(
    store: CaseStore, scan_id: int, rig: RigConfig, calibration: StereoCalibration, turn_closure_um: float | None = None
) -> RegisteredViews:
    """Register the views of a scan, keep the corrections and the report in the case, and return the merged cloud.

    Parameters
    ----------
    turn_closure_um : by how much the turn did not close; kept with the report (:func:`~scanner_core.case.closure.closure_um`)
    """
    table = scan_table(store, scan_id)
    registration = register_views(measured_cloud(table, rig, calibration).cloud)
    store.put_corrections(scan_id, registration.corrections)
    report = registration.as_dict()
    if turn_closure_um is not None:
        report[CLOSURE] = round(turn_closure_um, 1)
    store.put_registration(scan_id, calibration.identity(), report)
    measured = measured_cloud(table, rig, calibration, store.corrections(scan_id))
    return RegisteredViews(measured.cloud, registration, measured.noise)
