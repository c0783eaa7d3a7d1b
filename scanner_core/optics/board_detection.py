"""Finds the corners of the calibration board in a frame, to a fraction of a pixel.

The markers only tell which corner is which, but at grazing view and with pixels that are not square a marker's cell
can be two pixels high, so they are looked for in an enlarged copy.  Their homography then says where every corner must
be, and each is fitted in the frame itself.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_view import MIN_CORNERS, BoardMiss, BoardMissReason, BoardView
from scanner_core.optics.corner_refinement import refine_corners

Array = NDArray[np.float64]

_MIN_MARKERS = 4
_RANSAC_PX = 3.0
"""How far a marker's corner may lie from the homography: a strong lens bends a large board by some pixels."""
_SMALL_ROWS = 700
_ENLARGED = 4
"""Images of fewer rows are enlarged so many times to read their markers."""
_BORDER_PX = 3
_DARK_DN = 24
_BRIGHT_DN = 250
_BLURRED = 0.12
"""Steepest step between two pixels, as a part of the frame's contrast; a sharp edge has 0.4 and more."""
_MAX_SIGMA_PX = 3.5


def detect_board(image: NDArray[np.uint8], target: CharucoTarget) -> BoardView | BoardMiss:
    """The board's corners in an image (H, W) uint8, or why they cannot be used."""
    low, high = np.percentile(image[::4, ::4], (1, 99))
    if high < _DARK_DN or low >= _BRIGHT_DN:
        return BoardMiss(BoardMissReason.TOO_DARK if high < _DARK_DN else BoardMissReason.TOO_BRIGHT)
    to_pixels = _board_to_pixels(image, target)
    if to_pixels is None:
        blurred = _steepest(image) < _BLURRED * (high - low)
        return BoardMiss(BoardMissReason.TOO_BLURRED if blurred else BoardMissReason.NO_BOARD)
    points = target.object_points[:, :2]
    rough = _project(to_pixels, points)
    inside = ((rough > _BORDER_PX) & (rough < np.array(image.shape[::-1]) - 1 - _BORDER_PX)).all(axis=1)
    ids = np.flatnonzero(inside)
    if len(ids) < MIN_CORNERS:
        return BoardMiss(BoardMissReason.CUT, len(ids))
    step = 0.5 * target.square_mm
    along = [(_project(to_pixels, points[ids] + d) - _project(to_pixels, points[ids] - d)) / (2 * step) for d in step * np.eye(2)]
    fit = refine_corners(image, rough[ids], along[0], along[1], target.square_mm, 0.5 * (target.square_mm - target.marker_mm))
    if np.count_nonzero(fit.accepted) < MIN_CORNERS:
        blurred = float(np.median(fit.sigma_px)) > _MAX_SIGMA_PX
        return BoardMiss(BoardMissReason.TOO_BLURRED if blurred else BoardMissReason.TOO_FEW_CORNERS, int(np.count_nonzero(fit.accepted)))
    return BoardView(ids[fit.accepted], fit.corners_px[fit.accepted])


def _board_to_pixels(image: NDArray[np.uint8], target: CharucoTarget) -> Array | None:
    """The homography (3, 3) from the board's plane in mm to pixels by the markers that were recognized, or None."""
    board = target.board()
    scale = _ENLARGED if image.shape[0] < _SMALL_ROWS else 1
    large = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC) if scale > 1 else image
    detector = cv2.aruco.ArucoDetector(board.getDictionary())
    seen, seen_ids, _ = detector.detectMarkers(large)
    if seen_ids is None:
        return None
    known = dict(zip(np.ravel(board.getIds()).tolist(), board.getObjPoints(), strict=True))
    pairs = [(known[i], corners) for i, corners in zip(np.ravel(seen_ids).tolist(), seen, strict=True) if i in known]
    if len(pairs) < _MIN_MARKERS:
        return None
    # Resizing keeps the image's outer edges in place, not the centre of its first pixel.
    pixels = (np.concatenate([np.reshape(corners, (4, 2)) for _, corners in pairs]).astype(np.float64) + 0.5) / scale - 0.5
    plane = np.concatenate([np.reshape(points, (4, 3))[:, :2] for points, _ in pairs]).astype(np.float64)
    homography, _ = cv2.findHomography(plane, pixels, cv2.RANSAC, _RANSAC_PX)
    return None if homography is None else np.asarray(homography, np.float64)


def _project(homography: Array, points: Array) -> Array:
    """Pixels (n, 2) of points (n, 2) of the board's plane, mm."""
    p = points @ homography[:, :2].T + homography[:, 2]
    return np.asarray(p[:, :2] / p[:, 2:], np.float64)


def _steepest(image: NDArray[np.uint8]) -> float:
    """The largest step between neighbouring pixels of a row, a few outliers left out, DN."""
    return float(np.percentile(np.abs(np.diff(image.astype(np.int16), axis=1)), 99.9))
