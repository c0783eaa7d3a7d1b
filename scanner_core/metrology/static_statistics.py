"""The statistics of standing spots.

Definitions
-----------
standard deviation
    Of the points about the mean of their stay (the beam rests in one place), pooled over the stays with n - 1 each.
    ``without_drift`` is the same about a straight line in time.
drift
    The slope in time that all places share, by direction: the weighted median of the slopes between means of one place at
    different times (Theil 1950, Sen 1968), over the run and per hour; ``drift_um`` is the length of that vector over the
    run.  Its uncertainty comes from the scatter of those means about the common line, so it holds how exactly the mover
    comes back to a place.
resolution
    The random standard deviation of the centroid times the size of a pixel in object space at the spot, root mean square
    over both coordinates and both cameras: the smallest shift that rises out of a single frame's noise.  The published
    system states it as 1/30000 of the image's diagonal, which is 1/45 of a pixel, and as 9.33 um.
repeatability
    Four times the mean of the three standard deviations: the width of the interval that holds 95 % of repeated
    measurements (+- 2 s), as the published system states it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

AXES = ("x", "y", "z")
LEAST_PER_STAY = 3
_PARTS = 8
"""Into which a single stay is divided to see the drift; of several stays in a place each gives one mean, because the parts
of a stay share what the mover missed the place by."""


@dataclass(frozen=True, slots=True, eq=False)
class StaticResult:
    """The scatter of static spots; vectors are (3,) in the order x depth, y vertical, z lateral.

    Attributes
    ----------
    repeats : measured pairs; `planned` were exposed
    sd_um, sd_without_drift_um, sd_uncertainty_um : pooled standard deviation, and its own standard uncertainty from the
        spread between the places
    place_sd_um : (places, 3) of every place
    centroid_sd_px : (4,) pooled, left x, y, right x, y
    pixel_mm : (4,) size of a pixel in object space at the spot, in the same order
    drift_um, drift_per_hour_um, drift_uncertainty_um : over the run, by direction
    duration_s : of the run on the rig's clock
    spot_sigma_px : (4,) and peak_dn (2,): means
    deviations_um : (n, 3) of every point from the mean of its stay; place (n,) and time_s (n,) go with it
    place_means_um : (m, 3) means of a place at different times, from the place's own mean; mean_time_s (m,) goes with it
    """

    repeats: int
    planned: int
    places: int
    rejected: dict[str, int]
    sd_um: Array
    sd_without_drift_um: Array
    sd_uncertainty_um: Array
    place_sd_um: Array
    centroid_sd_px: Array
    pixel_mm: Array
    diagonal_px: float
    drift_um: Array
    drift_per_hour_um: Array
    drift_uncertainty_um: Array
    duration_s: float
    spot_sigma_px: Array
    peak_dn: Array
    deviations_um: Array
    place: NDArray[np.int64]
    time_s: Array
    place_means_um: Array
    mean_time_s: Array

    @property
    def resolution_um(self) -> float:
        return 1e3 * float(np.sqrt(np.mean((self.centroid_sd_px * self.pixel_mm) ** 2)))

    @property
    def repeatability_um(self) -> float:
        return 4 * float(self.sd_um.mean())

    @property
    def drift_length_um(self) -> float:
        return float(np.linalg.norm(self.drift_um))

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        sd_px = float(np.sqrt(np.mean(self.centroid_sd_px**2)))
        quartiles = np.percentile(self.place_sd_um, (0, 25, 50, 75, 100), axis=0)
        return {
            "repeats": self.repeats,
            "planned": self.planned,
            "places": self.places,
            "rejected": self.rejected,
            "sd_um": _by_axis(self.sd_um),
            "sd_without_drift_um": _by_axis(self.sd_without_drift_um),
            "sd_uncertainty_um": _by_axis(self.sd_uncertainty_um),
            "place_sd_quartiles_um": {axis: np.round(quartiles[:, i], 2).tolist() for i, axis in enumerate(AXES)},
            "resolution_um": round(self.resolution_um, 3),
            "repeatability_um": round(self.repeatability_um, 3),
            "drift_um": round(self.drift_length_um, 3),
            "drift_axes_um": _by_axis(self.drift_um),
            "drift_per_hour_um": _by_axis(self.drift_per_hour_um),
            "drift_uncertainty_um": _by_axis(self.drift_uncertainty_um),
            "centroid_sd_px": dict(zip(("left_x", "left_y", "right_x", "right_y"), np.round(self.centroid_sd_px, 5).tolist(), strict=True)),
            "centroid_sd_rms_px": round(sd_px, 5),
            "diagonal_fraction": round(self.diagonal_px / sd_px, 1) if sd_px > 0 else None,
            "pixel_mm": np.round(self.pixel_mm, 4).tolist(),
            "spot_sigma_px": np.round(self.spot_sigma_px, 3).tolist(),
            "peak_dn": np.round(self.peak_dn, 1).tolist(),
            "duration_s": round(self.duration_s, 2),
        }


def evaluate_static(
    points_um: Array,
    place: NDArray[np.int64],
    stay: NDArray[np.int64],
    time_s: Array,
    spots: Array,
    pixel_mm: Array,
    diagonal_px: float,
    planned: int,
    rejected: dict[str, int],
) -> StaticResult:
    """The statistics, see the module.

    Parameters
    ----------
    points_um : (n, 3) along x, y, z
    place, stay, time_s : (n,)
    spots : (n, 10), see :class:`~scanner_core.metrology.standing_spot.SpotRecord`
    pixel_mm : (4,)
    """
    stays = [members for members in (np.flatnonzero(stay == s) for s in np.unique(stay)) if len(members) >= LEAST_PER_STAY]
    kept = np.concatenate(stays)
    duration = float(np.ptp(time_s[kept]))
    means, mean_time, slopes, slope_uncertainty = _drift(points_um, place, time_s, stays)
    deviations = _about_means(points_um, stays)
    straight = deviations - _about_means(time_s[:, None], stays) * slopes
    lost = len(stays)
    sd = _pooled(deviations[kept], lost)
    places = [np.concatenate(own) for own in _by_place(place, stays)]
    shares = [len(own) for own in _by_place(place, stays)]
    by_place = np.array([_pooled(deviations[members], share) for members, share in zip(places, shares, strict=True)])
    return StaticResult(
        repeats=len(kept),
        planned=planned,
        places=len(places),
        rejected=rejected,
        sd_um=sd,
        sd_without_drift_um=_pooled(straight[kept], lost + 1),
        sd_uncertainty_um=_pooled_uncertainty(by_place, sd, len(kept)),
        place_sd_um=by_place,
        centroid_sd_px=_pooled(_about_means(spots[:, :4], stays)[kept], lost),
        pixel_mm=pixel_mm,
        diagonal_px=diagonal_px,
        drift_um=slopes * duration,
        drift_per_hour_um=slopes * 3600,
        drift_uncertainty_um=slope_uncertainty * duration,
        duration_s=duration,
        spot_sigma_px=spots[kept, 4:8].mean(axis=0),
        peak_dn=spots[kept, 8:10].mean(axis=0),
        deviations_um=deviations[kept],
        place=place[kept],
        time_s=time_s[kept],
        place_means_um=means,
        mean_time_s=mean_time,
    )


def _about_means(values: Array, groups: list[NDArray[np.int64]]) -> Array:
    about = np.zeros_like(values)
    for members in groups:
        about[members] = values[members] - values[members].mean(axis=0)
    return about


def _pooled(deviations: Array, lost: int) -> Array:
    """Standard deviation (columns) of deviations from `lost` means."""
    return np.asarray(np.sqrt((deviations**2).sum(axis=0) / max(len(deviations) - lost, 1)), np.float64)


def _by_place(place: NDArray[np.int64], stays: list[NDArray[np.int64]]) -> list[list[NDArray[np.int64]]]:
    """The stays of every place."""
    own: dict[int, list[NDArray[np.int64]]] = {}
    for members in stays:
        own.setdefault(int(place[members[0]]), []).append(members)
    return list(own.values())


def _drift(points: Array, place: NDArray[np.int64], time_s: Array, stays: list[NDArray[np.int64]]) -> tuple[Array, Array, Array, Array]:
    """Means (m, 3) from their place's own, their times (m,), the shared slopes (3,) a second and their uncertainty."""
    means, whens, times, slopes, weights = [], [], [], [], []
    for own in _by_place(place, stays):
        blocks = own if len(own) > 1 else np.array_split(own[0], min(_PARTS, len(own[0])))
        t = np.array([time_s[block].mean() for block in blocks])
        v = np.array([points[block].mean(axis=0) for block in blocks])
        i, j = np.triu_indices(len(blocks), 1)
        later = t[j] > t[i]
        apart = (t[j] - t[i])[later]
        slopes.append((v[j] - v[i])[later] / apart[:, None])
        weights.append(apart)
        means.append(v - v.mean(axis=0))
        whens.append(t)
        times.append(t - t.mean())
    mean, about = np.concatenate(means), np.concatenate(times)
    slope, weight = np.concatenate(slopes), np.concatenate(weights)
    shared = np.array([_weighted_median(slope[:, axis], weight) for axis in range(3)])
    scatter = np.sqrt(((mean - about[:, None] * shared) ** 2).sum(axis=0) / max(len(mean) - len(means) - 1, 1))
    lever = float(np.sqrt((about**2).sum()))
    # The median of slopes is 0.95 as efficient as least squares on normal noise.
    uncertainty = scatter / (np.sqrt(0.95) * lever) if lever > 0 else np.zeros(3)
    return mean, np.concatenate(whens), shared, uncertainty


def _weighted_median(values: Array, weights: Array) -> float:
    if not len(values):
        return 0.0
    order = np.argsort(values)
    below = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(below, 0.5 * below[-1])])


def _pooled_uncertainty(by_place: Array, sd: Array, count: int) -> Array:
    """Standard uncertainty of the pooled standard deviation: that of the mean of the places' variances, over 2 s."""
    if len(by_place) < 2:
        return np.asarray(sd / np.sqrt(2 * max(count - 1, 1)), np.float64)
    spread = np.std(by_place**2, axis=0, ddof=1) / np.sqrt(len(by_place))
    return np.asarray(spread / (2 * np.maximum(sd, 1e-12)), np.float64)


def _by_axis(values: Array) -> dict[str, float]:
    return {axis: round(float(value), 3) for axis, value in zip(AXES, values, strict=True)}
