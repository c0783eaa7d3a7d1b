"""Points from what the case kept: 2D centroids, table angles and the calibration.

A case that is opened again gives the same cloud to the last bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.observation import ObservationTable
from scanner_core.case.records import ScanRecord
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig, parse_rig
from scanner_core.errors import CaseFormatError, UsageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.geometry.surface_scatter import excess_scatter_mm
from scanner_core.one_line import one_line
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_uncertainty import systematic_covariance
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel, along_axes, fit_centroid_noise
from scanner_core.optics.triangulation import Triangulator


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredCloud:
    """The cloud of a scan, and the noise that its covariances are made of."""

    cloud: PointCloud
    noise: NoiseModel


def triangulate_observations(
    table: ObservationTable, rig: RigConfig, calibration: StereoCalibration, corrections: Mapping[int, RigidTransform] | None = None
) -> MeasuredCloud:
    """The cloud in the object frame, with covariances in mm^2 by the scan's own residuals (see :mod:`~scanner_core.optics.noise_model`).

    Parameters
    ----------
    rig : says what a few points do not: the detector's floor and the diameter of the laser spot
    corrections : what else moves each view, after the table's turn was undone: the registration's correction (object frame to
        object frame), for another mount's frame followed by the mount's pose; or None
    """
    triangulator = Triangulator(calibration)
    pixels = CentroidNoise(along_axes(table.left_uncertainty_px, table.left_sigma_px), along_axes(table.right_uncertainty_px, table.right_sigma_px))
    prior = NoiseModel.prior(calibration, rig.spot.floor_px)
    noise = fit_centroid_noise(triangulator, calibration, table.left_px, table.right_px, pixels, prior)
    sigmas = noise.centroid_sigmas(calibration, pixels)
    seen = triangulator.triangulate(table.left_px, table.right_px, *sigmas)
    expected_px = triangulator.epipolar_sigma(table.left_px, table.right_px, *sigmas)
    in_sigmas = seen.epipolar_residual_px / expected_px
    points = TablePoints(seen.points, seen.covariances, table.view, table.table_deg, table.trigger_id, epipolar_sigmas=in_sigmas)
    cloud, surface_mm = placed_cloud(points, rig, calibration, corrections)
    return MeasuredCloud(cloud, replace(noise, surface_um=1e3 * surface_mm))


@dataclass(frozen=True, slots=True, eq=False)
class TablePoints:
    """n points in the rig frame, mm.

    Attributes
    ----------
    points, covariances : (n, 3) mm and (n, 3, 3) mm^2
    view, table_deg, trigger_id : (n,) that they are of
    place : (n,) of a laser line, the numbers of the peaks in their frames
    epipolar_sigmas : (n,) epipolar residuals over their standard deviations, where there are any
    """

    points: NDArray[np.float64]
    covariances: NDArray[np.float64]
    view: NDArray[np.int32]
    table_deg: NDArray[np.float64]
    trigger_id: NDArray[np.int64]
    place: NDArray[np.int32] | None = None
    epipolar_sigmas: NDArray[np.float64] | None = None


def placed_cloud(
    seen: TablePoints, rig: RigConfig, calibration: StereoCalibration, corrections: Mapping[int, RigidTransform] | None
) -> tuple[PointCloud, float]:
    """Points with the table's turn undone, their covariances with what surface and calibration add; and the surface's standard deviation, mm."""
    points = np.empty_like(seen.points)
    covariances = np.empty_like(seen.covariances)
    systematic = None if calibration.modes is None else systematic_covariance(calibration, seen.points)
    from_table = calibration.rig_to_table().inverse()
    # One transform per table position: a view stands at one angle, which the controller may have read back differently.
    # Not np.unique(axis=1): it sorts records, 0.7 s for half a million points, and other threads hardly run meanwhile.
    for view, table_deg in [(one, deg) for one in np.unique(seen.view) for deg in np.unique(seen.table_deg[seen.view == one])]:
        here = (seen.view == view) & (seen.table_deg == table_deg)
        transform = calibration.rig_to_object(float(table_deg))
        if corrections and int(view) in corrections:
            transform = corrections[int(view)] @ transform
        points[here] = transform.apply(seen.points[here])
        covariances[here] = transform.rotate_covariances(seen.covariances[here])
        if systematic is not None:
            systematic[here] = (transform @ from_table).rotate_covariances(systematic[here])
    surface_mm = excess_scatter_mm(points, covariances, rig.laser.spot_diameter_mm)
    covariances += surface_mm**2 * np.eye(3)
    if systematic is not None:  # common to neighbouring points: it is no scatter, and no registration takes it out
        covariances += systematic
    places = None if seen.place is None else seen.place.copy()
    cloud = PointCloud(points, covariances, seen.view.copy(), seen.trigger_id.copy(), seen.table_deg.copy(), places, seen.epipolar_sigmas)
    return cloud, surface_mm


def finite(measured: MeasuredCloud, store: CaseStore) -> MeasuredCloud:
    """The cloud as it is; E-CASE-01 when centroids and calibration do not belong together, so that a point is nowhere."""
    cloud = measured.cloud
    if not np.isfinite(cloud.points).all() or (cloud.covariances is not None and not np.isfinite(cloud.covariances).all()):
        raise CaseFormatError("E-CASE-01", path=store.path, reason="its centroids and its calibration do not give points")
    return measured


def case_rig(store: CaseStore, scan: ScanRecord) -> tuple[RigConfig, StereoCalibration]:
    """The rig and the calibration with which a scan of the case was measured; the rig holds that calibration."""
    rig = _rig_of(store, store.rig_toml(scan.id), f"rig of scan {scan.id}")
    calibration = case_calibration(store, scan.calibration_id)
    return rig.with_calibration(calibration), calibration


def case_calibration(store: CaseStore, calibration_id: str) -> StereoCalibration:
    """A calibration that the case holds; the rig beside it is that of the first scan with it, maybe of no other."""
    calibration = _rig_of(store, store.calibration_toml(calibration_id), "calibration").calibration
    if calibration is None or calibration.identity() != calibration_id:
        raise CaseFormatError("E-CASE-01", path=store.path, reason=f"its calibration {one_line(calibration_id)} is empty, or another")
    return calibration


def _rig_of(store: CaseStore, toml: str, what: str) -> RigConfig:
    try:
        return parse_rig(toml, what)
    except UsageError as fault:
        reason = f"its {what} is damaged ({one_line(fault.fields.get('reason', ''))})"
        raise CaseFormatError("E-CASE-01", path=store.path, reason=reason, details=str(fault)) from fault
