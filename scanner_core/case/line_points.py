"""Points of a laser line from what the case kept of it; and of any scan, by whatever light it was measured."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from scanner_core.acquisition.line_engine import FLOOR_PX, PRIOR_MM, nominal_pan_axis
from scanner_core.case.observation import ObservationTable
from scanner_core.case.points import MeasuredCloud, TablePoints, placed_cloud, triangulate_observations
from scanner_core.case.store import CaseStore
from scanner_core.case.stripes import StripeTable
from scanner_core.case.superseded import counting_spots
from scanner_core.devices.rig import RigConfig
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.laser_plane import swept_planes
from scanner_core.optics.noise_model import NoiseModel
from scanner_core.optics.stripe_detection import SAMPLES_PER_PX
from scanner_core.optics.stripe_matching import StripeMatcher

ScanTable = ObservationTable | StripeTable


def scan_table(store: CaseStore, scan_id: int) -> ScanTable:
    """What counts of a scan: spots (:func:`~scanner_core.case.superseded.counting_spots`), or places of a line."""
    return store.stripe_points(scan_id) if store.by_line(scan_id) else counting_spots(store, scan_id)


def measured_cloud(
    table: ScanTable, rig: RigConfig, calibration: StereoCalibration, corrections: Mapping[int, RigidTransform] | None = None
) -> MeasuredCloud:
    """The cloud in the object frame; see :func:`~scanner_core.case.points.triangulate_observations` for `corrections`."""
    if isinstance(table, StripeTable):
        return line_cloud(table, rig, calibration, corrections)
    return triangulate_observations(table, rig, calibration, corrections)


def line_cloud(
    table: StripeTable, rig: RigConfig, calibration: StereoCalibration, corrections: Mapping[int, RigidTransform] | None = None
) -> MeasuredCloud:
    """The cloud of a laser line in the object frame, with covariances in mm^2.

    A peak's uncertainty by its pixels' noise is raised, view by view, to what the points scatter about the laser's planes; what they
    scatter about the local surface beyond that is added, as for spots.
    """
    points, covariances = StripeMatcher(calibration, FLOOR_PX).located(table.pairs)
    nominal = nominal_pan_axis(rig, calibration)
    factors = np.ones(len(table))
    for view in np.unique(table.view):
        here = table.view == view
        frame = table.trigger_id[here] - table.trigger_id[here].min()
        planes = swept_planes(points[here], np.full(int(here.sum()), PRIOR_MM), frame, int(frame.max()) + 1, nominal)
        if planes is not None:
            factors[here] = planes.noise_factor(points[here], covariances[here], frame)
    covariances *= (SAMPLES_PER_PX * factors)[:, None, None]
    seen = TablePoints(points, covariances, table.view, table.table_deg, table.trigger_id, table.place)
    cloud, surface_mm = placed_cloud(seen, rig, calibration, corrections)
    noise = NoiseModel(float(np.median(factors)) if len(table) else 1.0, 0.0, 1e3 * surface_mm, len(table))
    return MeasuredCloud(cloud, noise)
