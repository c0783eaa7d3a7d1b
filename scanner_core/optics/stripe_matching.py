"""Which places of the laser line in the left and the right image are the same place of the surface: epipolar matching.

A peak of one image has an epipolar line in the other; where that crosses the line's image there, interpolated between
neighbouring peaks, lies a candidate.  A fold of the surface, or a piece of the line that only one camera sees, gives
several candidates, or a wrong one; which it is, is not decided here.  Peaks of both images look for their partners, so
that a place is measured wherever the line crosses a row or a column of either image.

The line is a curve: its place along itself says nothing.  A point therefore has two uncertain numbers, how far the curve lies
beside itself in the one and in the other image, and its covariance is propagated from their variances.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.stripe_curve import neighbour_links
from scanner_core.optics.stripe_detection import StripePeaks
from scanner_core.optics.stripe_pairs import StripePairs
from scanner_core.optics.triangulation import StereoCameras, Triangulator

Array = NDArray[np.float64]

_SAME_PX = 1.0
"""Crossings closer than this along an epipolar line are one: links overlap where rows and columns both have peaks."""
_LEAST_SINE = 0.15
"""Of the angle between the line and the epipolar line; below it a crossing is nowhere in particular."""
_STEP_PX = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class StripeCandidates:
    """Possible points of one frame.

    Attributes
    ----------
    place : (n,) number of the peak that they belong to: those of the left image first, then those of the right image
    pairs : n places in both images
    points : (n, 3) mm, rig frame
    covariances : (n, 3, 3) mm^2
    grazing : (n,) bool: the epipolar line runs along the line
    """

    place: NDArray[np.int64]
    pairs: StripePairs
    points: Array
    covariances: Array
    grazing: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.place)

    @staticmethod
    def none() -> StripeCandidates:
        """Of a frame without a line."""
        return StripeCandidates(np.empty(0, np.int64), StripePairs.none(), np.empty((0, 3)), np.empty((0, 3, 3)), np.empty(0, np.bool_))

    @staticmethod
    def joined(parts: list[StripeCandidates]) -> StripeCandidates:
        """All of several."""
        pairs = StripePairs.joined([part.pairs for part in parts])
        place, points, covariances, grazing = (
            np.concatenate([getattr(part, name) for part in parts]) for name in ("place", "points", "covariances", "grazing")
        )
        return StripeCandidates(place, pairs, points, covariances, grazing)


class StripeMatcher:
    """Candidates of the peaks of frame pairs; immutable, so threads may share it.

    Parameters
    ----------
    floor_px : standard deviation across the line of what limits a place beside the pixels' noise
    """

    def __init__(self, cameras: StereoCameras, floor_px: float) -> None:
        self._cameras = (cameras.left, cameras.right)
        self._triangulator = Triangulator(cameras)
        self._floor_px2 = floor_px**2
        rotation = cameras.right.rotation @ cameras.left.rotation.T
        x, y, z = cameras.right.translation - rotation @ cameras.left.translation
        essential = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]) @ rotation
        self._essential = (essential, essential.T)
        """Takes a normalized place of the left, right image to its epipolar line in the other."""

    def match(self, left: StripePeaks, right: StripePeaks) -> StripeCandidates:
        """All candidates of both images' peaks."""
        if not (len(left) and len(right)):
            return StripeCandidates.none()
        peaks = (left, right)
        links = [neighbour_links(each) for each in peaks]
        parts = [self._of_peaks(side, peaks, links[1 - side]) for side in (0, 1)]
        parts[1].place[:] += len(left)
        return StripeCandidates.joined(parts)

    def _of_peaks(self, side: int, peaks: tuple[StripePeaks, StripePeaks], links: NDArray[np.int64]) -> StripeCandidates:
        """Candidates of the peaks of one image in the other."""
        mine, theirs = peaks[side], peaks[1 - side]
        if not len(links):
            return StripeCandidates.none()
        lines = self._lines(side, mine.xy)
        beside = lines @ np.c_[self._cameras[1 - side].normalize(theirs.xy), np.ones(len(theirs))].T  # (peaks, their peaks), normalized units
        first, second = beside[:, links[:, 0]], beside[:, links[:, 1]]
        place, link = np.nonzero((first <= 0) != (second <= 0))
        a, b = first[place, link], second[place, link]
        share = a / (a - b)
        i, j = links[link].T
        crossing = (1 - share[:, None]) * theirs.xy[i] + share[:, None] * theirs.xy[j]
        chord = theirs.xy[j] - theirs.xy[i]
        length = np.linalg.norm(chord, axis=1)
        tangent = chord / np.maximum(length, 1e-9)[:, None]
        epipolar = self._epipolar_direction(side, lines[place])
        kept = _one_of_each(place, np.einsum("ij,ij->i", crossing, epipolar), length)
        if not len(kept):
            return StripeCandidates.none()
        place, share, i, j = place[kept], share[kept], i[kept], j[kept]
        crossing, tangent = crossing[kept], tangent[kept]

        across = theirs.across_variance_px2()
        variance = (1 - share) ** 2 * across[i] + share**2 * across[j] + self._floor_px2
        own_variance = mine.variance_px2[place] + self._floor_px2 * (1 + mine.slope[place] ** 2)
        own = mine.xy[place]
        left_px, right_px = (own, crossing) if side == 0 else (crossing, own)
        by_right, angle = np.full(len(place), side == 1), np.arctan2(tangent[:, 1], tangent[:, 0])
        pairs = StripePairs(left_px, right_px, by_right, mine.along_row[place], np.sqrt(own_variance), np.sqrt(variance), angle)
        points, covariances, sine = self._located(side, pairs)
        finite = np.asarray(np.isfinite(points).all(axis=1), np.bool_)
        grazing = np.abs(sine) < _LEAST_SINE
        return StripeCandidates(place.astype(np.int64)[finite], pairs.select(finite), points[finite], covariances[finite], grazing[finite])

    def located(self, pairs: StripePairs) -> tuple[Array, Array]:
        """Points (n, 3) mm and covariances (n, 3, 3) mm^2 of places, rig frame."""
        points, covariances = np.empty((len(pairs), 3)), np.empty((len(pairs), 3, 3))
        for side in (0, 1):
            here = pairs.by_right == (side == 1)
            points[here], covariances[here], _ = self._located(side, pairs.select(here))
        return points, covariances

    def _located(self, side: int, pairs: StripePairs) -> tuple[Array, Array, Array]:
        """Points, covariances, and the sine of the angle between the line and the epipolar line, of places whose peaks are this image's."""
        own, crossing = (pairs.left_px, pairs.right_px) if side == 0 else (pairs.right_px, pairs.left_px)
        tangent = np.c_[np.cos(pairs.tangent_rad), np.sin(pairs.tangent_rad)]
        epipolar = self._epipolar_direction(side, self._lines(side, own))
        sine = tangent[:, 0] * epipolar[:, 1] - tangent[:, 1] * epipolar[:, 0]
        safe = np.where(np.abs(sine) < 1e-3, 1e-3, sine)
        points = self._points(side, own, crossing)
        # where the curve there lies beside itself, its crossing with the same epipolar line slides along that
        by_other = (self._points(side, own, crossing + (_STEP_PX / safe)[:, None] * epipolar) - points) / _STEP_PX
        # where the peak lies beside itself, the epipolar line moves, and its crossing along the curve
        moved = own + _STEP_PX * np.where(pairs.along_row[:, None], [1.0, 0.0], [0.0, 1.0])
        slid = self._crossed(1 - side, self._lines(side, moved), crossing, tangent)
        by_own = (self._points(side, moved, slid) - points) / _STEP_PX
        covariances = np.einsum("n,ni,nj->nij", pairs.other_px**2, by_other, by_other)
        covariances += np.einsum("n,ni,nj->nij", pairs.own_px**2, by_own, by_own)
        return points, covariances, sine

    def _lines(self, side: int, own: Array) -> Array:
        """Epipolar lines (n, 3) in the other image, normalized units, of places (n, 2) px of this one."""
        lines = np.c_[self._cameras[side].normalize(own), np.ones(len(own))] @ self._essential[side].T
        return np.asarray(lines / np.maximum(np.linalg.norm(lines[:, :2], axis=1, keepdims=True), 1e-12), np.float64)

    def _points(self, side: int, own: Array, other: Array) -> Array:
        left, right = (own, other) if side == 0 else (other, own)
        sigma = np.ones((len(own), 2))
        return self._triangulator.triangulate(left, right, sigma, sigma).points

    def _epipolar_direction(self, side: int, lines: Array) -> Array:
        """Unit vectors (n, 2) px along epipolar lines (n, 3) of the other image.

        Distortion turns them by less than matters here.
        """
        focal = np.diag(self._cameras[1 - side].matrix)[:2]
        along = np.c_[-lines[:, 1], lines[:, 0]] * focal
        return np.asarray(along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12), np.float64)

    def _crossed(self, index: int, lines: Array, near: Array, tangent: Array) -> Array:
        """Where curves through `near` (n, 2) px with these tangents cross epipolar lines (n, 3) close by."""
        camera = self._cameras[index]
        here = np.c_[camera.normalize(near), np.ones(len(near))]
        ahead = np.c_[camera.normalize(near + _STEP_PX * tangent), np.ones(len(near))]
        a, b = np.einsum("ij,ij->i", lines, here), np.einsum("ij,ij->i", lines, ahead)
        change = np.where(np.abs(b - a) < 1e-15, 1e-15, b - a)
        return np.asarray(near - (_STEP_PX * a / change)[:, None] * tangent, np.float64)


def _one_of_each(place: NDArray[np.int64], along: Array, length: Array) -> NDArray[np.int64]:
    """Numbers of the crossings to keep: of those of one place that lie together, the one of the shortest link."""
    if not len(place):
        return np.empty(0, np.int64)
    order = np.lexsort([along, place])
    new = np.r_[True, (np.diff(place[order]) != 0) | (np.diff(along[order]) > _SAME_PX)]
    group = np.cumsum(new) - 1
    best = np.lexsort([length[order], group])
    first = np.r_[True, np.diff(group[best]) != 0]
    return np.asarray(order[best[first]], np.int64)
