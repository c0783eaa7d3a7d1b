"""How uncertain a measured point is because the calibration is: the part of the error that repeats.

The calibration's parameters have a joint covariance (cameras, relative pose, axis, scale), kept as modes: rows whose outer
products add up to it.  Each mode moves the cameras and the axis by one standard deviation; how far it moves a point in
the table frame is found by triangulating the same pixels with the moved calibration, and the outer products of these
displacements, summed over the modes, are the point's covariance (law of propagation, JCGM 102:2011, 6.2).  Points that
are close to each other share nearly all of this error, which is why it must not be averaged away.

Of the parameters' thirty directions some eight matter; a calibration is truncated to these when it is made.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.bundle_adjustment import STEREO, moved_cameras
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.triangulation import Triangulator

Array = NDArray[np.float64]

PARAMETERS = STEREO + 6
"""The stereo parameters, then origin (mm) and direction of the axis."""

KEPT = 0.999
"""Part of the points' variance that the truncated modes keep."""
_NODES = (9, 9, 7)
_SIDE, _TOP, _BELOW = 0.25, 0.35, 0.05
"""Half width, height and depth below the table of the box in which the covariance is tabulated, as parts of the distance."""


def volume_nodes(calibration: StereoCalibration, nodes: tuple[int, int, int] = _NODES) -> tuple[Array, Array, Array]:
    """Three axes (mm, table frame) of a grid over the volume that the cameras look at."""
    distance = float(np.linalg.norm(calibration.turntable.origin - calibration.left.centre_mm()))
    side = _SIDE * distance
    return np.linspace(-side, side, nodes[0]), np.linspace(-side, side, nodes[1]), np.linspace(-_BELOW * distance, _TOP * distance, nodes[2])


def seen_nodes(calibration: StereoCalibration, nodes: tuple[int, int, int]) -> Array:
    """The nodes (n, 3) mm, table frame, of such a grid that both cameras see: nothing is asked of images beyond their borders."""
    grid = np.stack(np.meshgrid(*volume_nodes(calibration, nodes), indexing="ij"), axis=-1).reshape(-1, 3)
    in_rig = calibration.rig_to_table().inverse().apply(grid)
    seen = np.ones(len(grid), bool)
    for camera in (calibration.left, calibration.right):
        pixels = camera.project(in_rig)
        seen &= ((pixels >= 0) & (pixels <= np.array(camera.size_px) - 1)).all(axis=1)
    return np.asarray(grid[seen], np.float64)


def moved_calibration(calibration: StereoCalibration, step: Array) -> StereoCalibration:
    """The calibration with its thirty parameters changed by `step`."""
    left, right = moved_cameras(calibration.left, calibration.right, step[:STEREO])
    axis = calibration.turntable
    direction = axis.direction + step[STEREO + 3 :]
    turntable = replace(axis, origin=axis.origin + step[STEREO : STEREO + 3], direction=direction / np.linalg.norm(direction))
    return replace(calibration, left=left, right=right, turntable=turntable)


def displacements(calibration: StereoCalibration, steps: Array, points: Array) -> Array:
    """How the same images of points would be measured with other calibrations.

    Parameters
    ----------
    steps : (k, 30) changes of the parameters
    points : (n, 3) mm, table frame

    Returns
    -------
    (k, n, 3) mm, table frame
    """
    in_rig = calibration.rig_to_table().inverse().apply(points)
    seen = calibration.left.project(in_rig), calibration.right.project(in_rig)
    ones = np.ones(len(points))

    def measured(with_it: StereoCalibration) -> Array:
        return with_it.rig_to_table().apply(Triangulator(with_it).triangulate(*seen, ones, ones).points)

    nominal = measured(calibration)  # cancels what the pixels' undistortion leaves at the far corners
    return np.stack([measured(moved_calibration(calibration, step)) - nominal for step in steps]) if len(steps) else np.zeros((0, len(points), 3))


def truncated_modes(calibration: StereoCalibration, modes: Array) -> Array:
    """Fewer modes (j, 30) with the same effect on the points of the volume, to :data:`KEPT` of their variance."""
    effect = displacements(calibration, modes, seen_nodes(calibration, (7, 7, 5))).reshape(len(modes), -1)
    turn, size, _ = np.linalg.svd(effect, full_matrices=False)
    share = np.cumsum(size**2) / (size**2).sum()
    return np.asarray(turn[:, : int(np.searchsorted(share, KEPT)) + 1].T @ modes, np.float64)


class CalibrationUncertainty:
    """The covariance that the calibration gives to points, from a table over the volume; immutable.

    Raises
    ------
    ValueError
        For a calibration without modes.
    """

    def __init__(self, calibration: StereoCalibration) -> None:
        if calibration.modes is None:
            raise ValueError("the calibration does not say how uncertain it is")
        from scipy.interpolate import RegularGridInterpolator

        self._to_table = calibration.rig_to_table()
        axes = volume_nodes(calibration)
        grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
        moved = displacements(calibration, calibration.modes, grid.reshape(-1, 3))
        table = np.einsum("kni,knj->nij", moved, moved)[:, _UPPER[0], _UPPER[1]]
        self._low, self._high = np.array([axis[0] for axis in axes]), np.array([axis[-1] for axis in axes])
        self._at = RegularGridInterpolator(axes, table.reshape(*_NODES, 6))

    def covariances(self, points_rig: Array) -> Array:
        """(n, 3, 3) mm^2 in the table frame, for points (n, 3) mm of the rig frame.

        Beyond the volume the nearest of its places is taken.  For the object frame turn them by the table's angle
        (:meth:`RigidTransform.rotate_covariances` of ``RigidTransform.about_z(-table_deg)``).  The height of the table's surface, a
        datum that moves all points alike, has no part in it.
        """
        inside = np.clip(self._to_table.apply(points_rig), self._low, self._high)
        upper = self._at(inside)
        whole = np.empty((len(inside), 3, 3))
        whole[:, _UPPER[0], _UPPER[1]] = upper
        whole[:, _UPPER[1], _UPPER[0]] = upper
        return whole


_UPPER = (np.array([0, 0, 0, 1, 1, 2]), np.array([0, 1, 2, 1, 2, 2]))


def systematic_covariance(calibration: StereoCalibration, points_rig: Array) -> Array:
    """:meth:`CalibrationUncertainty.covariances` for a single use."""
    return CalibrationUncertainty(calibration).covariances(points_rig)
