"""What a reconstruction with more or fewer triangles is expected to give, told before it is done.

What the facets add to the expected error was measured on four clouds with a fourth to twice the triangles that they carry: 0.54
times the sag that 95 of 100 facets keep, and the sag goes with the area of a facet.  Before a first surface is there the error is a
rule of thumb, good for the order of magnitude: of n points with a noise of s, 26 s / sqrt(n).  On a body with the detail of an impression
that was 26 um where a surface was expected to be 27 um off (2,500 points, 50 um), and 6.1 for 7.1 um (8,000 points, 20 um); on a plain
ball, where much more is averaged, it is five times too much (3,000 points, 50 um: 24 for 4.7 um).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from scanner_core.geometry.point_cloud import PointCloud

_SAG_SHARE = 0.54
_AVERAGED = 26.0
_BEND = 9.0
"""Sag, times triangles, over the rms distance of the points from their centre: of a ball it is 3.6."""
_POINTS_EACH, _LEAST_CARRIED = 1.04, 24_000


@dataclass(frozen=True, slots=True)
class Carried:
    """What a case's points give with as many triangles as they carry.

    Attributes
    ----------
    triangles : so many
    smooth_um : expected error without that of the facets, or None when nothing is known of the points' noise
    sag_um : what 95 of 100 facets depart from the rounded surface at most
    measured : of a surface that was made, not by a rule of thumb
    """

    triangles: int
    smooth_um: float | None
    sag_um: float
    measured: bool

    def error_um(self, triangles: int) -> float | None:
        """Expected error with so many triangles."""
        if self.smooth_um is None:
            return None
        return sqrt(self.smooth_um**2 + (_SAG_SHARE * self.sag_um * self.triangles / max(triangles, 1)) ** 2)


def carried_by(cloud: PointCloud) -> Carried:
    """By a rule of thumb, from the points alone."""
    count = max(len(cloud), 1)
    triangles = max(int(_POINTS_EACH * count), _LEAST_CARRIED)
    size_mm = float(np.sqrt(cloud.points.var(axis=0).sum())) if len(cloud) else 0.0
    variance = None if cloud.covariances is None or not len(cloud) else float(np.median(np.trace(cloud.covariances, axis1=1, axis2=2))) / 3
    smooth_um = None if variance is None else _AVERAGED * 1e3 * sqrt(max(variance, 0.0)) / sqrt(count)
    return Carried(triangles, smooth_um, 1e3 * _BEND * size_mm / triangles, measured=False)


def carried_after(report: dict[str, object], parameters: dict[str, object]) -> Carried | None:
    """From what a reconstruction of the same points told; None when it was stopped early or did not tell enough."""
    triangles, error_um, sag_um = (_number(report, key) for key in ("triangles", "expected_error_rms_um", "facet_sag_um"))
    detail = _number(parameters, "detail")
    counted = parameters.get("triangles") is not None or parameters.get("tolerance_um") is not None
    if report.get("stopped_early") or counted or not (triangles and error_um and sag_um and detail):
        return None
    smooth_um = sqrt(max(error_um**2 - (_SAG_SHARE * sag_um) ** 2, (0.3 * error_um) ** 2))
    return Carried(round(triangles / detail), smooth_um, sag_um * detail, measured=True)


def _number(values: dict[str, object], key: str) -> float | None:
    value = values.get(key)
    return float(value) if isinstance(value, int | float) else None
