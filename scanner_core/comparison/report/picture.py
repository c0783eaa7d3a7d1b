"""The map of deviations and the stable region as pictures of the after surface, and where the areas' numbers go on them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, THRESHOLD_LINE, DeviationScale
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.report.viewpoint import Viewpoint
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.pictures.raster import Raster, rasterized
from scanner_core.pictures.shaded import FINER, coarser, lit

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

STABLE, MOVABLE = (52, 142, 110), (214, 217, 221)
"""Of the region that carries the alignment, and of the rest."""


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """A picture of the after surface.

    Attributes
    ----------
    pixels : (h, w, 4) uint8, red, green, blue and opacity
    numbers : rank of an area and where its number goes: right and down, as shares of width and height
    """

    pixels: NDArray[np.uint8]
    numbers: tuple[tuple[int, float, float], ...]


def fitted_scale(comparison: Comparison) -> DeviationScale:
    """The scale of colours of a comparison's report."""
    values = np.where(comparison.after.supported, comparison.deviation.signed_um, np.nan)
    return DeviationScale.fitting(values, comparison.deviation.detection_level_um, comparison.parameters.tolerance_um)


class Painter:
    """Paints one comparison from any viewpoint, all pictures at one scale.

    Parameters
    ----------
    comparison : whose after surface is shown, in the frame of BEFORE
    scale : of the colours
    cancelled : asked before every picture, which then raises `Cancelled`
    """

    def __init__(self, comparison: Comparison, scale: DeviationScale, cancelled: IsCancelled = lambda: False) -> None:
        self._comparison, self._scale, self._cancelled = comparison, scale, cancelled
        mesh = comparison.after.mesh
        self._triangles = mesh.triangles
        self._points = comparison.alignment.transform.apply(mesh.vertices)
        self._normals = comparison.alignment.transform.rotate(mesh.vertex_normals())
        self._values = np.where(comparison.after.supported, comparison.deviation.signed_um, np.nan)

    def extent_mm(self, viewpoint: Viewpoint) -> tuple[float, float]:
        """Width and height of the surface as seen from there."""
        seen = self._points @ viewpoint.axes[:2].T
        width, height = seen.max(axis=0) - seen.min(axis=0)
        return float(width), float(height)

    def deviation(self, viewpoint: Viewpoint, pixel_mm: float, width: int, height: int) -> Picture:
        """The signed map: stepped colours, a line at the threshold, a hatch where there is no counterpart.

        Parameters
        ----------
        pixel_mm : edge of a pixel on the surface
        width, height : of the picture, pixels
        """
        raster, points = self._raster(viewpoint, pixel_mm, width, height)
        values = raster.sampled(self._triangles, self._values)
        colours = self._scale.colours(values, raster.sampled(self._triangles, self._comparison.deviation.level_um)).astype(np.float64)
        hatched = np.isnan(values) & (_stripes(raster.seen.shape)[raster.seen])
        colours[hatched] = HATCH
        image = self._shaded(raster, viewpoint, colours)
        beyond = np.zeros(raster.seen.shape, np.bool_)
        beyond[raster.seen] = np.abs(np.nan_to_num(values)) >= self._scale.threshold_um
        known = np.zeros(raster.seen.shape, np.bool_)
        known[raster.seen] = ~np.isnan(values)
        image[_border(beyond, known)] = (*THRESHOLD_LINE, 255.0)
        return Picture(coarser(image), self._numbers(raster, points, viewpoint, pixel_mm))

    def stable(self, viewpoint: Viewpoint, pixel_mm: float, width: int, height: int) -> Picture:
        """The region that carries the alignment, in green."""
        raster, _ = self._raster(viewpoint, pixel_mm, width, height)
        carrying = raster.sampled(self._triangles, self._comparison.alignment.stable.astype(np.float64)) > 0.5
        colours = np.where(carrying[:, None], np.array(STABLE, np.float64), np.array(MOVABLE, np.float64))
        colours[~carrying & np.isnan(raster.sampled(self._triangles, self._values))] = NO_COUNTERPART
        return Picture(coarser(self._shaded(raster, viewpoint, colours)), ())

    def _raster(self, viewpoint: Viewpoint, pixel_mm: float, width: int, height: int) -> tuple[Raster, Array]:
        """The raster, and the vertices as seen from there relative to the picture's middle, mm."""
        if self._cancelled():
            raise Cancelled
        points = self._points @ viewpoint.axes.T
        centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
        points = points - centre
        return rasterized(points, self._triangles, pixel_mm / FINER, width * FINER, height * FINER, np.zeros(2)), points

    def _shaded(self, raster: Raster, viewpoint: Viewpoint, colours: Array) -> Array:
        """(h, w, 4) 0 to 255, of colours (n, 3) of the pixels that show the surface."""
        return lit(raster, self._triangles, self._normals @ viewpoint.axes.T, colours)

    def _numbers(self, raster: Raster, points: Array, viewpoint: Viewpoint, pixel_mm: float) -> tuple[tuple[int, float, float], ...]:
        """Of every area of which a good part is seen: its rank, in the middle of that part."""
        height, width = raster.seen.shape
        fine = pixel_mm / FINER
        found = []
        for area in self._comparison.areas:
            own = points[area.vertices]
            column = np.clip(np.rint(own[:, 0] / fine + 0.5 * width - 0.5).astype(np.int64), 0, width - 1)
            row = np.clip(np.rint(0.5 * height - 0.5 - own[:, 1] / fine).astype(np.int64), 0, height - 1)
            visible = raster.depth[row, column] < own[:, 2] + 0.3
            if visible.mean() < 0.3:
                continue
            middle = np.median(np.column_stack([column, row])[visible], axis=0)
            found.append((area.rank, float((middle[0] + 0.5) / width), float((middle[1] + 0.5) / height)))
        return tuple(found)


def _stripes(shape: tuple[int, ...]) -> Mask:
    """Diagonal lines."""
    row, column = np.indices(shape)
    return np.asarray((row + column) % 12 < 3, np.bool_)


def _border(beyond: Mask, known: Mask) -> Mask:
    """Pixels on the border of a region, within what is known."""
    border = np.zeros_like(beyond)
    for axis in (0, 1):
        first = [slice(None), slice(None)]
        second = [slice(None), slice(None)]
        first[axis], second[axis] = slice(None, -1), slice(1, None)
        a, b = tuple(first), tuple(second)
        change = (beyond[a] != beyond[b]) & known[a] & known[b]
        border[a] |= change
        border[b] |= change
    return border
