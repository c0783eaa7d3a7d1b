"""The clouds of several mounts, each in its colour; one that was not joined stands beside.  Import it when the 3D view is there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.mount_words import mount_colour
from app.views.surface_colours import rgb
from app.views.vtk_arrays import copied, copied_ids
from scanner_core.case.mount_job import MountCloud

_MOST = 60_000
"""Points drawn, of all mounts together."""
POINT_SIZE = 3.0
_BESIDE = 0.2


class MountsAside:
    """One answer."""

    range_um = None
    slices = None

    def __init__(self, clouds: Sequence[MountCloud]) -> None:
        self._actors: list[Any] = []
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        for cloud in sorted(clouds, key=lambda cloud: cloud.pose is None):
            points, towards = cloud.points, cloud.towards
            if cloud.pose is not None:
                points, towards = cloud.pose.apply(points), cloud.pose.rotate(towards)
            elif len(self._actors):
                shift = high[1] + _BESIDE * (high[1] - low[1]) - points[:, 1].min()
                points = points + np.array([0.0, shift, 0.0])
            low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
            self._actors.append(point_actor(points, towards, mount_colour(cloud.mount), _MOST // len(clouds)))
        self._bounds = np.array([low, high]) if self._actors else None

    @property
    def actors(self) -> Sequence[Any]:
        return self._actors

    @property
    def bounds_mm(self) -> NDArray[np.float64] | None:
        return self._bounds

    def fit_pixels(self, ratio: float) -> None:
        for actor in self._actors:
            actor.GetProperty().SetPointSize(POINT_SIZE * ratio)


def point_actor(points: NDArray[np.float64], towards: NDArray[np.float64], colour: str, most: int = _MOST) -> Any:
    """At most so many of points (n, 3) mm, of one colour, lit by the directions (n, 3) from which they were seen."""
    stride = max(1, -(-len(points) // most))
    points, towards = points[::stride], towards[::stride]
    places, cells = vtkPoints(), vtkCellArray()
    places.SetData(copied(points.astype(np.float32)))
    cells.SetData(copied_ids(np.arange(len(points) + 1, dtype=np.int64)), copied_ids(np.arange(len(points), dtype=np.int64)))
    poly = vtkPolyData()
    poly.SetPoints(places)
    poly.SetVerts(cells)
    poly.GetPointData().SetNormals(copied(towards.astype(np.float32)))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(poly)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetRepresentationToPoints()
    look.SetColor(*(value / 255 for value in rgb(colour)))
    look.SetPointSize(POINT_SIZE)
    look.SetAmbient(0.45)
    look.SetDiffuse(0.6)
    return actor
