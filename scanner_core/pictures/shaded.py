"""A surface under light, as a small picture: a thumbnail of an order, a place that is to be scanned again, a certificate."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.pictures.raster import Raster, rasterized

Array = NDArray[np.float64]

FINER = 2
"""Pixels that are computed for one of the picture, along either edge: soft edges."""
PLASTER, MARKED = (218, 209, 194), (232, 129, 41)
"""Of a surface without colours of its own, and of the vertices that are pointed out; told apart with every kind of colour vision."""
_LIGHT = np.array([-0.30, 0.45, 0.84])
"""Direction to the light: right, up, towards the eye."""
_STEP_MM = 1.2
"""A step in depth between neighbouring pixels that is drawn as an edge."""
_MARGIN = 0.06
"""Share of the picture that stays free on every side."""


def shaded_picture(
    mesh: TriangleMesh,
    towards: Array,
    width_px: int,
    height_px: int,
    colours: NDArray[np.uint8] | None = None,
    marked: NDArray[np.int64] | None = None,
) -> NDArray[np.uint8]:
    """The whole surface in parallel projection, as large as it fits, on a transparent ground.

    Parameters
    ----------
    towards : (3,) direction from the surface to the eye, of any length but zero; +z points up in the picture, +y where one looks along z
    colours : (v, 3) red, green, blue of the vertices, 0 to 255; plaster without them
    marked : indices of vertices that are painted over in :data:`MARKED`

    Returns
    -------
    (height_px, width_px, 4) uint8, red, green, blue and opacity; wholly transparent for a mesh without triangles
    """
    if not len(mesh.triangles):
        return np.zeros((height_px, width_px, 4), np.uint8)
    axes = looking(towards)
    used = np.zeros(len(mesh.vertices), np.bool_)
    used[mesh.triangles] = True
    seen = mesh.vertices @ axes.T
    low, high = seen[used].min(axis=0), seen[used].max(axis=0)
    width, height = (1 - 2 * _MARGIN) * width_px, (1 - 2 * _MARGIN) * height_px
    pixel_mm = max(float(high[0] - low[0]) / width, float(high[1] - low[1]) / height, 1e-9) / FINER
    raster = rasterized(seen, mesh.triangles, pixel_mm, width_px * FINER, height_px * FINER, 0.5 * (low + high)[:2])
    painted = np.broadcast_to(np.array(PLASTER, np.float64), (len(seen), 3)) if colours is None else np.asarray(colours, np.float64)
    at_pixels = raster.sampled(mesh.triangles, painted)
    if marked is not None:
        weight = np.zeros(len(seen))
        weight[marked] = 1.0
        at_pixels[raster.sampled(mesh.triangles, weight) > 0.5] = MARKED
    return coarser(lit(raster, mesh.triangles, mesh.vertex_normals() @ axes.T, at_pixels, max(_STEP_MM, 6 * pixel_mm)))


def looking(towards_eye: Array, up: Array | None = None) -> Array:
    """(3, 3) rows: right, up, towards the eye; orthonormal, right-handed.

    Parameters
    ----------
    towards_eye : (3,), not zero
    up : (3,) what points up in the picture, not parallel to it; without one +z, and +y where one looks along z
    """
    eye = np.asarray(towards_eye, np.float64)
    eye = eye / np.linalg.norm(eye)
    if up is None:
        up = np.array([0.0, 0.0, 1.0]) if abs(eye[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
    right = np.cross(up, eye)
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])


def lit(raster: Raster, triangles: NDArray[np.int64], normals: Array, colours: Array, step_mm: float = _STEP_MM) -> Array:
    """(h, w, 4) 0 to 255: colours under light, silhouettes drawn finely, nothing where nothing is seen.

    Parameters
    ----------
    normals : (v, 3) right, up, towards the eye
    colours : (n, 3) 0 to 255 of the n pixels that show the surface
    step_mm : a step in depth between neighbouring pixels that is drawn as an edge
    """
    facing = raster.sampled(triangles, normals)
    facing /= np.maximum(np.linalg.norm(facing, axis=1), 1e-12)[:, None]
    facing *= np.where(facing[:, 2] < 0, -1.0, 1.0)[:, None]
    light = 0.55 + 0.45 * np.clip(facing @ (_LIGHT / np.linalg.norm(_LIGHT)), 0, 1)
    image = np.zeros((*raster.seen.shape, 4))
    image[raster.seen] = np.column_stack([colours * light[:, None], np.full(len(colours), 255.0)])
    depth = np.where(raster.seen, raster.depth, -1e6)
    edge = np.zeros(raster.seen.shape, np.bool_)
    edge[:, 1:] |= np.abs(np.diff(depth, axis=1)) > step_mm
    edge[1:] |= np.abs(np.diff(depth, axis=0)) > step_mm
    image[edge & raster.seen, :3] *= 0.45
    return image


def coarser(image: Array) -> NDArray[np.uint8]:
    """Means of squares of :data:`FINER` pixels, the colours weighted by their opacity."""
    height, width = image.shape[0] // FINER, image.shape[1] // FINER
    blocks = image.reshape(height, FINER, width, FINER, 4)
    opacity = blocks[..., 3:].sum(axis=(1, 3))
    colours = (blocks[..., :3] * blocks[..., 3:]).sum(axis=(1, 3)) / np.maximum(opacity, 1.0)
    return np.asarray(np.concatenate([colours, opacity / FINER**2], axis=2).round(), np.uint8)
