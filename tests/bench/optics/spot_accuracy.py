"""Centroid errors over the Cramer-Rao bound, and what the detector says of its own error, for all three centroids.

Per row: rms error over the Cramer-Rao bound of the six-parameter problem (x / y), stated over actual standard uncertainty
(both axes together, then x and y with the stated one split in proportion to the spot's sigmas), and stated over true sigma.
The sigmas hold the pixel's own box, the peak is over a black level of 8 DN.  The actual error is the rms divided by that of an
efficient estimator on the same noise, times the bound, which is the latter's standard deviation: chance cancels.
The last rows are spots brighter than the sensor: there the plain rms stands over the bound of the censored problem.
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters
from tests.bench.optics.spot_images import BENCH, WORKSHOP, Array, Sensor, SpotShape, bound, draw, efficient_errors, framed

SIZE, MARGIN = (40, 40), 64
SIGMAS = (0.85, 1.0, 1.4, 2.0)
PEAKS = (50.0, 90.0, 140.0, 190.0, 250.0)
SATURATED = tuple(SpotShape(x, y, peak) for x, y in ((0.85, 0.85), (1.0, 0.8), (1.4, 1.4), (2.0, 1.2), (2.0, 2.0)) for peak in (300.0, 450.0, 600.0))
METHODS = ("weighted", "gaussian", "border")


@dataclass(frozen=True, slots=True, eq=False)
class Row:
    """Figures of one spot and one centroid; pairs are x and y."""

    shape: SpotShape
    found: float
    over_bound: Array
    stated_over_actual: float
    split_over_actual: Array
    sigma_over_true: Array

    def __str__(self) -> str:
        s, pair = self.shape, "{:.3f} / {:.3f}".format
        return (
            f"{s.sigma_x:4.2f} x {s.sigma_y:4.2f} px {s.peak_dn:4.0f} DN  found {self.found:6.1%}  over bound {pair(*self.over_bound)}"
            f"  stated/actual {self.stated_over_actual:.3f} ({pair(*self.split_over_actual)})  sigma {pair(*self.sigma_over_true)}"
        )


def measure(shape: SpotShape, sensor: Sensor, centroid: str, count: int, seed: int) -> Row:
    """Draw frames and compare what the detector finds with the truth."""
    parameters = SpotDetectorParameters(centroid=centroid, read_noise_dn=sensor.read_dn, shot_dn=sensor.shot_dn, floor_px=0.0)
    detector = SpotDetector(parameters)
    rng = np.random.default_rng(seed)
    places, windows = draw(shape, sensor, count, rng, SIZE)
    frames = framed(windows, sensor, rng, MARGIN)
    seen = [(place + MARGIN, spot) for place, frame in zip(places, frames, strict=True) if isinstance(spot := detector.detect(frame), Spot)]
    if not seen:
        return Row(shape, 0.0, np.full(2, np.nan), np.nan, np.full(2, np.nan), np.full(2, np.nan))
    errors = np.array([(spot.x_px - x, spot.y_px - y) for (x, y), spot in seen])
    stated = np.array([spot.standard_uncertainty_px for _, spot in seen])
    sigmas = np.array([(spot.sigma_x_px, spot.sigma_y_px) for _, spot in seen])
    least = bound(shape, sensor, SIZE)
    rms = np.sqrt((errors**2).mean(axis=0))
    if shape.peak_dn + sensor.black_dn < sensor.ceiling_dn + 10:
        rms *= least / np.sqrt((efficient_errors(shape, sensor, places, windows) ** 2).mean(axis=0))
    split = stated[:, None] * sigmas / np.sqrt(0.5 * (sigmas**2).sum(axis=1, keepdims=True))
    return Row(
        shape,
        len(seen) / count,
        rms / least,
        float(np.sqrt((stated**2).mean() / (0.5 * (rms**2).sum()))),
        np.sqrt((split**2).mean(axis=0)) / rms,
        sigmas.mean(axis=0) / (shape.sigma_x, shape.sigma_y),
    )


def shapes() -> Iterator[SpotShape]:
    for x, y, peak in itertools.product(SIGMAS, SIGMAS, PEAKS):
        yield SpotShape(x, y, peak)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spots", type=int, default=2000, help="frames per row")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS))
    parser.add_argument("--all", action="store_true", help="print every row, not the extremes alone")
    given = parser.parse_args()
    for (name, sensor), method in itertools.product((("bench", BENCH), ("workshop", WORKSHOP)), given.methods):
        for title, group in (("", tuple(shapes())), (" saturated", SATURATED)):
            rows = [measure(shape, sensor, method, given.spots, given.seed + i) for i, shape in enumerate(group)]
            rows = [row for row in rows if row.found > 0]
            print(f"{name}{title}, {method}, {given.spots} spots a row, seeds {given.seed} to {given.seed + len(group) - 1}")
            if given.all:
                print("\n".join(f"  {row}" for row in rows))
            for label, values in (
                ("over bound", [v for row in rows for v in row.over_bound]),
                ("stated over actual", [row.stated_over_actual for row in rows]),
                ("  split over the axes", [v for row in rows for v in row.split_over_actual]),
                ("sigma over true", [v for row in rows for v in row.sigma_over_true]),
                ("found", [row.found for row in rows]),
            ):
                print(f"  {label:22s} {min(values):.3f} to {max(values):.3f}, median {np.median(values):.3f}" if values else f"  {label}: none")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
