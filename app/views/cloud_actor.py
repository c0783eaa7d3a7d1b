"""The point cloud as VTK draws it: a buffer of fixed size for the live cloud, the whole cloud once nothing moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.height_colours import HEIGHT, table
from app.views.vtk_arrays import copied, copied_ids, shared

LIVE_LIMIT = 60_000
"""Points drawn while the cloud grows."""
MOVING_LIMIT = 30_000
"""Points drawn while the camera moves."""
POINT_SIZES = ((2_500, 6.0), (8_000, 5.0), (60_000, 4.0), (10**9, 3.0))
"""Most points, and their size on the screen."""
STILL_LIMIT = 400_000
"""Points drawn while nothing moves."""

Floats = NDArray[np.float32]


class CloudActor:
    """Points coloured by height and lit by their normals.

    The live buffer never holds more than ``LIVE_LIMIT`` points: when it is full every second one is dropped, and from
    then on only every second new one is taken, and so on.  Rows come coarse to fine, so the thinned cloud stays even.
    """

    def __init__(self) -> None:
        self._all = np.empty((4096, 3), np.float32)
        self._towards = np.empty((4096, 3), np.float32)
        self._count = 0
        self._live = _Drawn(LIVE_LIMIT)
        self._stride = 1
        self._quiet = False
        self._still: _Drawn | None = None
        self.generation = 0
        """Changes whenever points that were there go away; stale normals are told by it."""
        self._corners = np.array([[np.inf] * 3, [-np.inf] * 3])
        self.actor = vtkActor()
        self.actor.SetMapper(self._live.mapper)
        look = self.actor.GetProperty()
        look.SetRepresentationToPoints()
        look.SetColor(0.52, 0.56, 0.6)
        look.SetInterpolationToPhong()
        look.SetAmbient(0.3)
        look.SetDiffuse(0.75)
        look.SetSpecular(0.05)

    def __len__(self) -> int:
        return self._count

    @property
    def bounds_mm(self) -> NDArray[np.float64] | None:
        """(2, 3) lowest and highest corner, or None without points."""
        return self._corners if self._count else None

    @property
    def drawn(self) -> int:
        """Number of points that the next picture holds."""
        if self.actor.GetMapper() is self._live.mapper:
            return self._live.drawn
        return self._still.drawn if self._still is not None else 0

    def clear(self) -> None:
        self._count = 0
        self._stride = 1
        self._still = None
        self._live.clear()
        self.generation += 1
        self._corners = np.array([[np.inf] * 3, [-np.inf] * 3])
        self.actor.SetMapper(self._live.mapper)

    def append(self, points: NDArray[np.float64], towards: NDArray[np.float64]) -> None:
        """Add points (n, 3) mm; `towards` (n, 3) are unit vectors to where they were seen from, their first normals."""
        if not len(points):
            return
        start, end = self._count, self._count + len(points)
        if end > len(self._all):
            room = max(end, 2 * len(self._all))
            self._all = np.concatenate([self._all[:start], np.empty((room - start, 3), np.float32)])
            self._towards = np.concatenate([self._towards[:start], np.empty((room - start, 3), np.float32)])
        self._all[start:end] = points
        self._towards[start:end] = towards
        self._count = end
        self._corners[0] = np.minimum(self._corners[0], points.min(axis=0))
        self._corners[1] = np.maximum(self._corners[1], points.max(axis=0))
        first = -start % self._stride
        while self._live.count + len(range(start + first, end, self._stride)) > LIVE_LIMIT:
            self._live.halve()
            self._stride *= 2
            self.generation += 1
            first = -start % self._stride
        self._live.append(self._all[start + first : end : self._stride], towards[first :: self._stride])
        self._live.show_range(self._corners[0, 2], self._corners[1, 2])
        self._still = None
        self.actor.SetMapper(self._live.mapper)

    def live_points(self) -> tuple[Floats, Floats]:
        """Copies of the points in the live buffer, (m, 3) mm, and of the directions to where they were seen from."""
        kept = slice(0, self._count, self._stride)
        return self._all[kept].copy(), self._towards[kept].copy()

    def all_points(self) -> tuple[Floats, Floats]:
        """The same for all points, thinned to what is drawn when nothing moves."""
        kept = slice(0, self._count, self._still_stride())
        return self._all[kept].copy(), self._towards[kept].copy()

    def light_live(self, normals: NDArray[np.float64], generation: int) -> None:
        """Normals (m, 3) of the first m live points, unless the buffer was thinned meanwhile."""
        if generation == self.generation:
            self._live.light(normals)

    def show_still(self, normals: NDArray[np.float64], generation: int) -> None:
        """From now on the whole cloud, with normals (m, 3) for :meth:`all_points`."""
        points = self._all[: self._count : self._still_stride()]
        if generation != self.generation or len(normals) != len(points):
            return
        self._still = _Drawn(len(points))
        self._still.append(points, normals)
        self._still.show_range(self._corners[0, 2], self._corners[1, 2])
        self._still.mapper.SetScalarVisibility(not self._quiet)
        self.actor.SetMapper(self._still.mapper)

    def fit_point_size(self, pixel_ratio: float) -> None:
        """Larger points while they are few, so that the surface closes to the eye."""
        size = next(size for most, size in POINT_SIZES if self.drawn <= most)
        self.actor.GetProperty().SetPointSize(pixel_ratio * (2.0 if self._quiet else size))

    def quiet(self, on: bool) -> None:
        """Small and grey: the surface that grows among the points is what matters."""
        self._quiet = on
        for drawn in (self._live, self._still):
            if drawn is not None:
                drawn.mapper.SetScalarVisibility(not on)

    def thin_for_motion(self, moving: bool) -> None:
        """Fewer points while the camera moves."""
        if moving:
            self.actor.SetMapper(self._live.mapper)
            self._live.thin(-(-self._live.count // MOVING_LIMIT))
        else:
            self._live.thin(1)
            if self._still is not None:
                self.actor.SetMapper(self._still.mapper)

    def _still_stride(self) -> int:
        return max(1, -(-self._count // STILL_LIMIT))


class _Drawn:
    """Points, normals and heights in buffers of a fixed size that VTK reads in place."""

    def __init__(self, room: int) -> None:
        self._points = np.zeros((room, 3), np.float32)
        self._normals = np.zeros((room, 3), np.float32)
        self._heights = np.zeros(room, np.float32)
        self.count = 0
        self._step = 1
        self._places = vtkPoints()
        self._places.SetData(shared(self._points))
        self._vtk_normals = shared(self._normals)
        self._vtk_heights = shared(self._heights)
        self._poly = vtkPolyData()
        self._poly.SetPoints(self._places)
        self._poly.GetPointData().SetNormals(self._vtk_normals)
        self._poly.GetPointData().SetScalars(self._vtk_heights)
        lookup = vtkLookupTable()
        lookup.SetTable(copied(table(HEIGHT)))
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputData(self._poly)
        self.mapper.SetLookupTable(lookup)
        self.mapper.SetUseLookupTableScalarRange(False)
        self._changed()

    @property
    def drawn(self) -> int:
        return -(-self.count // self._step)

    def clear(self) -> None:
        self.count = 0
        self._step = 1
        self._changed()

    def append(self, points: Floats, normals: NDArray[np.float64]) -> None:
        end = self.count + len(points)
        self._points[self.count : end] = points
        self._normals[self.count : end] = normals
        self._heights[self.count : end] = points[:, 2]
        self.count = end
        self._points[end:] = self._points[0]  # VTK counts unused points into the bounds
        self._changed()

    def halve(self) -> None:
        """Keep every second point."""
        kept = -(-self.count // 2)
        for buffer in (self._points, self._normals, self._heights):
            buffer[:kept] = buffer[: self.count : 2].copy()
        self.count = kept

    def light(self, normals: NDArray[np.float64]) -> None:
        self._normals[: len(normals)] = normals
        self._vtk_normals.Modified()
        self._poly.Modified()

    def thin(self, step: int) -> None:
        if step != self._step:
            self._step = max(1, step)
            self._changed()

    def show_range(self, low_mm: float, high_mm: float) -> None:
        self.mapper.SetScalarRange(low_mm, max(high_mm, low_mm + 1e-3))

    def _changed(self) -> None:
        drawn = np.arange(0, self.count, self._step, dtype=np.int64)
        cells = vtkCellArray()
        if len(drawn):
            cells.SetData(copied_ids(np.array([0, len(drawn)], np.int64)), copied_ids(drawn))
        self._poly.SetVerts(cells)
        for part in (self._places.GetData(), self._vtk_normals, self._vtk_heights):
            part.Modified()
        self._places.Modified()
        self._poly.Modified()
