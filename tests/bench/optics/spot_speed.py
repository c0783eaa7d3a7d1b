"""Rates of detect + pair + triangulate against a plain loop of OpenCV calls, on the same frames in turns.

The plain loop knows the threshold beforehand, takes the largest contour and gates nothing: threshold, findContours and
moments of the pixels in its box frame by frame, then undistortPoints and triangulatePoints once per batch.  Ours estimates
background and noise, gates, states uncertainties, and triangulates with covariances and epipolar residuals.  Both have the same
batches of 16 pairs, so neither pays more calls per point than the other; a plain loop that triangulates pair by pair is
measured beside them.  Batches alternate; what counts is the median of the paired ratios of their processor times, one thread
each.  On a machine with other work the ratio of the fastest tenths tells more: caches that others empty slow the interpreter
more than they slow OpenCV.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.rig import load_preset
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.spot import Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_tracking import SpotTracker
from scanner_core.optics.triangulation import Triangulator
from tests.bench.optics.spot_images import BENCH, WORKSHOP, Sensor, expose, signals

Image = NDArray[np.uint8]
Pairs = list[tuple[Image, Image]]
BATCH = 16
Centroid = Literal["weighted", "gaussian", "border"]
CENTROIDS: tuple[Centroid, ...] = ("weighted", "gaussian", "border")


def frames(calibration: StereoCalibration, sensor: Sensor, distance_mm: float, count: int, seed: int) -> tuple[Pairs, NDArray[np.float64]]:
    """Frame pairs of a spot that sweeps 0.5 mm from frame to frame, and its points in the rig frame, (count, 3) mm."""
    rng = np.random.default_rng(seed)
    place = 0.5 * np.arange(count)
    left_centre = np.array([0.0, 0.0, distance_mm])
    points = left_centre + np.stack([20 * np.sin(place / 20), 10 * np.cos(place / 31), 10 * np.sin(place / 17)], axis=1)
    pairs: list[list[Image]] = [[] for _ in range(count)]
    for camera in (calibration.left, calibration.right):
        width, height = camera.size_px
        dark = [expose(np.zeros((height, width)), sensor, rng) for _ in range(BATCH)]
        for i, (x, y) in enumerate(camera.project(points)):
            frame = dark[i % BATCH].copy()
            left, top = round(float(x)) - 12, round(float(y)) - 12
            light = signals(np.array([x - left]), np.array([y - top]), (0.95, 0.8), 200.0, (25, 25))[0]
            frame[top : top + 25, left : left + 25] = expose(light, sensor, rng)
            pairs[i].append(frame)
    return [(left, right) for left, right in pairs], points


class PlainLoop:
    """What one writes on an afternoon; `together` points are triangulated at a time."""

    def __init__(self, calibration: StereoCalibration, threshold_dn: int, together: int) -> None:
        self._cameras = calibration.left, calibration.right
        self._projections = calibration.left.projection(), calibration.right.projection()
        self._threshold_dn = threshold_dn
        self._together = together

    def batch(self, pairs: Pairs) -> NDArray[np.float64]:
        return np.concatenate([self._points(pairs[i : i + self._together]) for i in range(0, len(pairs), self._together)])

    def _points(self, pairs: Pairs) -> NDArray[np.float64]:
        seen = []
        for images, camera in zip(zip(*pairs, strict=True), self._cameras, strict=True):
            centroids = np.array([self._centroid(image) for image in images])
            seen.append(cv2.undistortPoints(centroids, camera.matrix, camera.distortion).reshape(-1, 2).T)
        points = cv2.triangulatePoints(*self._projections, *seen)
        return np.asarray((points[:3] / points[3]).T, np.float64)

    def _centroid(self, image: Image) -> tuple[float, float]:
        above = cv2.threshold(image, self._threshold_dn, 255, cv2.THRESH_BINARY)[1]
        contours = cv2.findContours(above, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]
        x, y, w, h = cv2.boundingRect(max(contours, key=cv2.contourArea))
        m = cv2.moments(image[y : y + h, x : x + w])
        return x + m["m10"] / m["m00"], y + m["m01"] / m["m00"]


class Measured:
    """Ours; `left` and `right` are detectors or trackers."""

    def __init__(self, calibration: StereoCalibration, left: Callable[[Image], Spot | SpotMiss], right: Callable[[Image], Spot | SpotMiss]) -> None:
        self._triangulator = Triangulator(calibration)
        self._left, self._right = left, right

    def batch(self, pairs: Pairs) -> NDArray[np.float64]:
        seen = []
        for images in pairs:
            a, b = self._left(images[0]), self._right(images[1])
            if isinstance(a, Spot) and isinstance(b, Spot):
                seen.append((a.x_px, a.y_px, a.standard_uncertainty_px, b.x_px, b.y_px, b.standard_uncertainty_px))
        if not seen:
            return np.empty((0, 3))
        px = np.array(seen)
        return self._triangulator.triangulate(px[:, :2], px[:, 3:5], px[:, 2], px[:, 5]).points


def compare(preset: str, sensor: Sensor, distance_mm: float, pairs: int, rounds: int, seed: int, centroids: Sequence[Centroid]) -> None:
    config = load_preset(preset)
    calibration = config.calibration
    assert calibration is not None
    given, truth = frames(calibration, sensor, distance_mm, pairs, seed)
    threshold_dn = round(sensor.black_dn + 10)
    plain = PlainLoop(calibration, threshold_dn, BATCH)
    runs: dict[str, Callable[[Pairs], NDArray[np.float64]]] = {"plain loop": plain.batch}
    runs["plain, pair by pair"] = PlainLoop(calibration, threshold_dn, 1).batch
    for centroid in centroids:
        detector = SpotDetector(replace(config.spot, centroid=centroid))
        runs[f"{centroid}, whole frame"] = Measured(calibration, detector.detect, detector.detect).batch
        runs[f"{centroid}, tracked"] = Measured(calibration, SpotTracker(detector).detect, SpotTracker(detector).detect).batch
    width, height = calibration.left.size_px
    print(f"{preset}, {width} x {height}, {pairs} pairs x {rounds} rounds, seed {seed}")
    buffers = [(np.empty((height, width), np.uint8), np.empty((height, width), np.uint8)) for _ in range(BATCH)]
    for name, run in runs.items():
        spent: list[tuple[float, float]] = []
        errors: list[NDArray[np.float64]] = []
        for start in [*range(0, pairs - BATCH + 1, BATCH)] * rounds:
            batch = given[start : start + BATCH]
            plain_s, _ = delivered(plain.batch, batch, buffers)
            ours_s, points = delivered(run, batch, buffers)
            spent.append((plain_s, ours_s))
            errors.append(points - truth[start : start + BATCH] if len(points) == BATCH else np.full((BATCH, 3), np.nan))
        plain_each, each = np.array(spent).T
        ratios, rms = plain_each / each, np.sqrt(np.nanmean(np.square(errors)))
        undisturbed = np.quantile(plain_each, 0.1) / np.quantile(each, 0.1)
        print(
            f"  {name:22s} {BATCH / np.median(each):6.0f} pairs/s/core, {np.median(ratios):5.2f} x the plain loop's rate (quartiles "
            f"{np.quantile(ratios, 0.25):.2f} to {np.quantile(ratios, 0.75):.2f}; fastest tenths {undisturbed:.2f}), "
            f"rms of a coordinate {1e3 * rms:.1f} um"
        )


def delivered(run: Callable[[Pairs], NDArray[np.float64]], batch: Pairs, buffers: Pairs) -> tuple[float, NDArray[np.float64]]:
    """Processor time and points of a batch that was just written into the camera's buffers, as a driver does."""
    for frames_, buffer in zip(batch, buffers, strict=True):
        for frame, room in zip(frames_, buffer, strict=True):
            np.copyto(room, frame)
    began = time.thread_time()
    points = run(buffers)
    return time.thread_time() - began, points


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", type=int, default=160)
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--centroids", nargs="+", choices=CENTROIDS, default=list(CENTROIDS))
    given = parser.parse_args()
    cv2.setNumThreads(1)
    compare("bench", BENCH, 450.0, given.pairs, given.rounds, given.seed, given.centroids)
    compare("workshop", WORKSHOP, 615.0, given.pairs, given.rounds, given.seed, given.centroids)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
