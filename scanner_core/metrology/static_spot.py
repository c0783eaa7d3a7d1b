"""The static spot: what the instrument's random error is when nothing moves.

The laser stands on a flat, matt white plate that faces the rig at the middle of the volume; both cameras are triggered
over and over, every pair is triangulated, and the scatter of the points is stated along three directions: x = depth
(the mean viewing direction of the two cameras), y = vertical, z = lateral (the baseline's direction).

A spot smaller than a pixel is located with an error that depends on where in the pixel it stands: on the preset
``paper-2003`` the standard deviation in depth lies between 5 and 47 um from place to place, on ``bench``, whose spot is
wider, between 6 and 10 um (64 places).  One place is therefore not representative.  The repeats are spread over 256
places within some pixels, and the variances within the stays are pooled; that brings the pooled value's own uncertainty
to some 3 % (it is stated).  The beam comes back to every place once, late in the run, so that a drift shows.

The definitions stand in :mod:`scanner_core.metrology.static_statistics`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.errors import AcquisitionError
from scanner_core.metrology.placing import ArtefactOperator, operator_for
from scanner_core.metrology.standing_spot import OnPairs, SpotRecord, StandingSpot
from scanner_core.metrology.static_statistics import LEAST_PER_STAY, StaticResult, evaluate_static
from scanner_core.optics.calibration import StereoCalibration

Array = NDArray[np.float64]

REPEATS, PLACES, ROUNDS = 32_000, 256, 2
PATCH_MM = 10.0
"""The places lie in a square of so many mm about the middle: some pixels wide, so narrow that nothing else changes."""
_PLASTIC = 1.324717957244746
"""Its powers give the places: the additive sequence of lowest discrepancy in two dimensions (Roberts 2018)."""


class StaticTest:
    """The test on an open rig; after an interrupt :attr:`record` holds what was measured."""

    def __init__(self, rig: OpenRig, repeats: int = REPEATS, places: int = PLACES, operator: ArtefactOperator | None = None) -> None:
        self._rig, self._repeats, self._places = rig, repeats, min(places, max(1, repeats // (ROUNDS * LEAST_PER_STAY)))
        self._operator = operator_for(rig, operator)
        self.record = SpotRecord()
        self._table_deg = 0.0

    def run(self, told: OnPairs) -> StaticResult:
        """Measure; the laser is off on every way out.

        Raises
        ------
        AcquisitionError
            E-MET-02 when the spot was seen too rarely.
        """
        with StandingSpot(self._rig) as spot:
            calibration = self._rig.calibration
            if calibration is None:
                raise RuntimeError("a standing spot without a calibration")
            self._rig.motion.rotate_to(0.0)
            self._table_deg = spot.table_deg = self._rig.motion.status().table_deg
            target = np.array(self._rig.config.laser.target_mm)
            depth, _, _ = measuring_directions(calibration, target)
            self._operator.put_plate(target, depth)
            for place, x_deg, y_deg, count in self._stays():
                spot.observe(self.record, place, x_deg, y_deg, count, told)
        return self.result()

    def result(self) -> StaticResult:
        """Of what has been measured so far."""
        calibration, record = self._rig.calibration, self.record
        if calibration is None or len(record) < max(LEAST_PER_STAY, record.rejected.total()):
            reasons = ", ".join(f"{name} {count}" for name, count in sorted(record.rejected.items())) or "nothing was exposed"
            raise AcquisitionError("E-MET-02", seen=len(record), exposed=record.exposed, reasons=reasons)
        rows = np.array(record.rows)
        points = rows[:, 3:6]
        middle = points.mean(axis=0)
        directions = measuring_directions(calibration, middle, self._table_deg)
        in_rig = calibration.rig_to_object(self._table_deg).inverse().apply(middle)
        cameras = (calibration.left, calibration.right)
        depths = [float((camera.rotation @ in_rig + camera.translation)[2]) for camera in cameras]
        return evaluate_static(
            1e3 * (points - middle) @ directions.T,
            rows[:, 0].astype(np.int64),
            rows[:, 1].astype(np.int64),
            rows[:, 2],
            rows[:, 6:],
            np.array([depth / f for depth, camera in zip(depths, cameras, strict=True) for f in np.diag(camera.matrix)[:2]]),
            float(np.hypot(*calibration.left.size_px)),
            record.exposed,
            dict(sorted(record.rejected.items())),
        )

    def _stays(self) -> list[tuple[int, float, float, int]]:
        """Place, X, Y and number of repeats of every stay of the beam."""
        laser = self._rig.config.laser
        distance = float(np.linalg.norm(np.subtract(laser.position_mm, laser.target_mm)))
        k = np.arange(1, self._places + 1)
        unit = np.c_[(0.5 + k / _PLASTIC) % 1.0, (0.5 + k / _PLASTIC**2) % 1.0] - 0.5
        angles = np.degrees(PATCH_MM * unit / distance) if self._places > 1 else np.zeros((1, 2))
        rounds = min(ROUNDS, max(1, self._repeats // (LEAST_PER_STAY * self._places))) if self._places > 1 else 1
        counts = np.diff(np.rint(np.linspace(0, self._repeats, rounds * self._places + 1)).astype(int))
        places = np.tile(np.arange(self._places), rounds)
        return [(int(p), float(angles[p, 0]), float(angles[p, 1]), int(n)) for p, n in zip(places, counts, strict=True)]


def measuring_directions(calibration: StereoCalibration, at: Array, table_deg: float = 0.0) -> Array:
    """Unit vectors depth (towards the cameras), vertical (up) and lateral as the rows of (3, 3), object frame.

    `at` is the spot, (3,) mm, in the same frame.  Depth halves the angle between the two lines of sight; lateral is the
    baseline's direction, square to it; vertical is square to both.
    """
    to_object = calibration.rig_to_object(table_deg)
    eyes = to_object.apply(np.array([calibration.left.centre_mm(), calibration.right.centre_mm()]))
    sight = eyes - at
    sight /= np.linalg.norm(sight, axis=1)[:, None]
    depth = sight.sum(axis=0)
    depth /= np.linalg.norm(depth)
    lateral = eyes[1] - eyes[0]
    lateral = lateral - (lateral @ depth) * depth
    lateral /= np.linalg.norm(lateral)
    return np.stack([depth, np.cross(lateral, depth), lateral])
