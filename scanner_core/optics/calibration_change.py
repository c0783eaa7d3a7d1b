"""What has moved since the previous calibration, and what that does to measured points.

Both calibrations triangulate the same pixels of places all over the volume that both cameras see, at four angles of the table, and the points
are compared in the object frame.  As a whole the object may be displaced without harm (the datum of a rig is set anew by
every calibration), so the difference after one rigid alignment of all four views together is what a user would see as a
changed shape, or as views that no longer fit; it is compared with what both calibrations say of their own uncertainty.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_uncertainty import displacements, seen_nodes
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

SIGNIFICANT = 3.0
"""Standard uncertainties above which a change is believed."""
_ANGLES_DEG = (0.0, 90.0, 180.0, 270.0)
_NODES = (7, 7, 5)


@dataclass(frozen=True, slots=True)
class CalibrationChange:
    """The new calibration against the previous one.

    Attributes
    ----------
    previous : its id
    focal_px, principal_px : change of fx, fy and of cx, cy; left, right camera
    baseline_um, turned_deg : change of the distance between the cameras, and turn of the right against the left one
    axis_turned_deg : of the axis against the left camera
    rms_um, largest_um : displacement of measured points in the object frame
    shape_rms_um, shape_largest_um : the same after rigid alignment
    uncertainty_um : standard uncertainty of `shape_rms_um`, or None when neither calibration states its own
    significant : whether `shape_rms_um` is more than three of these
    """

    previous: str
    focal_px: tuple[tuple[float, float], tuple[float, float]]
    principal_px: tuple[tuple[float, float], tuple[float, float]]
    baseline_um: float
    turned_deg: float
    axis_turned_deg: float
    rms_um: float
    largest_um: float
    shape_rms_um: float
    shape_largest_um: float
    uncertainty_um: float | None
    significant: bool

    def words(self) -> str:
        """What moved, and what it means."""
        parts = []
        for side, focal, principal in zip(("left", "right"), self.focal_px, self.principal_px, strict=True):
            parts.append(
                f"{side} camera: focal lengths {focal[0]:+.2f} and {focal[1]:+.2f} px, principal point {principal[0]:+.2f} and {principal[1]:+.2f} px"
            )
        parts.append(f"right against left camera: {self.baseline_um:+.0f} um apart and {self.turned_deg:.4f} degrees turned")
        parts.append(f"axis: {self.axis_turned_deg:.4f} degrees turned")
        effect = f"Measured shapes change by {self.shape_rms_um:.1f} um rms and {self.shape_largest_um:.1f} um at most"
        if self.uncertainty_um is None:
            verdict = "the previous calibration does not state its uncertainty"
        else:
            where = "more than" if self.significant else "within"
            verdict = f"{where} three standard uncertainties of the calibrations ({self.uncertainty_um:.1f} um each)"
        return f"Since the previous calibration: {'; '.join(parts)}. {effect}, {verdict}."


def compare_calibrations(previous: StereoCalibration, new: StereoCalibration) -> CalibrationChange:
    """What has moved from `previous` to `new`."""
    grid = seen_nodes(new, _NODES)
    in_rig = new.rig_to_table().inverse().apply(grid)
    seen = new.left.project(in_rig), new.right.project(in_rig)
    ones = np.ones(len(grid))
    now, then = (c.rig_to_table().apply(Triangulator(c).triangulate(*seen, ones, ones).points) for c in (new, previous))
    shift = np.nan_to_num(now - then)  # a place that the previous cameras could not have seen
    views, places = _in_views(shift), _in_views(grid)
    shape = _without_rigid(views, places)
    known = [c for c in (new, previous) if c.modes is not None]
    uncertainty_um = None
    if known:
        squares = [
            float(np.mean([(_without_rigid(_in_views(moved), places) ** 2).sum(axis=1) for moved in displacements(new, c.modes, grid)], axis=1).sum())
            for c in known
            if c.modes is not None
        ]
        # One that does not say is taken to be as uncertain as the other.
        uncertainty_um = 1e3 * float(np.sqrt(2 * np.mean(squares)))
    cameras = ((previous.left, new.left), (previous.right, new.right))
    axes = [c.turntable.direction / np.linalg.norm(c.turntable.direction) for c in (previous, new)]
    baselines = [float(np.linalg.norm(c.right.centre_mm() - c.left.centre_mm())) for c in (previous, new)]
    shape_rms_um = _rms_um(shape)
    return CalibrationChange(
        previous=previous.identity(),
        focal_px=_pairs([np.diag(b.matrix)[:2] - np.diag(a.matrix)[:2] for a, b in cameras]),
        principal_px=_pairs([b.matrix[:2, 2] - a.matrix[:2, 2] for a, b in cameras]),
        baseline_um=1e3 * (baselines[1] - baselines[0]),
        turned_deg=RigidTransform(_relative(new) @ _relative(previous).T, np.zeros(3)).angle_deg(),
        axis_turned_deg=float(np.degrees(np.arcsin(min(1.0, float(np.linalg.norm(np.cross(axes[0], axes[1]))))))),
        rms_um=_rms_um(shift),
        largest_um=1e3 * float(np.linalg.norm(shift, axis=1).max()),
        shape_rms_um=shape_rms_um,
        shape_largest_um=1e3 * float(np.linalg.norm(shape, axis=1).max()),
        uncertainty_um=uncertainty_um,
        significant=uncertainty_um is not None and shape_rms_um > SIGNIFICANT * uncertainty_um,
    )


def _relative(calibration: StereoCalibration) -> Array:
    return calibration.right.rotation @ calibration.left.rotation.T


def _pairs(values: list[Array]) -> tuple[tuple[float, float], tuple[float, float]]:
    (a, b), (c, d) = ([float(v) for v in value] for value in values)
    return (a, b), (c, d)


def _in_views(vectors: Array) -> Array:
    """Vectors (n, 3) of the table frame in the object frame of four views, (4 n, 3)."""
    return np.concatenate([RigidTransform.about_z(-angle).rotate(vectors) for angle in _ANGLES_DEG])


def _without_rigid(shift: Array, places: Array) -> Array:
    """Small displacements (n, 3) at places (n, 3) less their best rigid motion."""
    about = places - places.mean(axis=0)
    moved = shift - shift.mean(axis=0)
    normal = (about**2).sum() * np.eye(3) - about.T @ about
    turn = np.linalg.solve(normal, np.cross(about, moved).sum(axis=0))
    return np.asarray(moved - np.cross(turn, about), np.float64)


def _rms_um(shift: Array) -> float:
    return 1e3 * float(np.sqrt((shift**2).sum(axis=1).mean()))
