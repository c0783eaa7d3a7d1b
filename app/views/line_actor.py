"""Thick lines over a surface: outlines of areas, contours of a section, the threshold on the map."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkContourFilter, vtkSmoothPolyDataFilter, vtkStripper
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.surface_colours import rgb
from app.views.vtk_arrays import copied, copied_ids, numbers_of, places_of

Vertices = NDArray[np.int64]
_FEWEST_POINTS = 14
"""A closed line of fewer points is noise that crosses the threshold, not the border of anything."""
_LIFT_MM = 0.06
"""A smoothed line would sink into the surface here and there."""
_CURTAIN = "//VTK::Color::Impl\n  if ((gl_FragCoord.x - curtain.x) * curtain.y < 0.0) discard;\n"


class LineActor:
    """Lines of one colour, or none."""

    def __init__(self, colour: str, width: float, *, behind: bool = False) -> None:
        """`width` in pixels of the screen; `behind` other lines at the same place, as their rim."""
        self._width = width
        self._there, self._shown = False, True
        self._mapper = vtkPolyDataMapper()
        self._mapper.ScalarVisibilityOff()
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -100.0 if behind else -700.0)
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        self.actor.SetVisibility(False)
        self.actor.PickableOff()
        look = self.actor.GetProperty()
        look.SetColor(*(value / 255 for value in rgb(colour)))
        look.LightingOff()
        self.set_pixel_ratio(1.0)
        shader = self.actor.GetShaderProperty()
        shader.AddFragmentShaderReplacement("//VTK::Color::Impl", True, _CURTAIN, False)
        self.set_curtain(0.0, 0)

    def set_pixel_ratio(self, ratio: float) -> None:
        self.actor.GetProperty().SetLineWidth(self._width * ratio)

    def set_curtain(self, x: float, side: int) -> None:
        """Only what lies right (+1) or left (-1) of a column of the picture, device pixels; 0 for all."""
        self.actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform2f("curtain", (x, float(side)))

    def set_cut(self, normal: NDArray[np.float64], offset: float) -> None:
        """Only points with ``normal . p <= offset``; a normal of zeros for all."""
        self._mapper.RemoveAllClippingPlanes()
        if normal.any():
            plane = vtkPlane()
            plane.SetNormal(*(-normal))
            plane.SetOrigin(*(normal * offset))
            self._mapper.AddClippingPlane(plane)

    def show_poly(self, poly: Any) -> None:
        """Lines as VTK has them, or None."""
        self._there = poly is not None
        self.actor.SetVisibility(self._there and self._shown)
        if poly is not None:
            self._mapper.SetInputData(poly)

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 3) mm, of the lines that there are."""
        return places_of(self._mapper.GetInput().GetPoints().GetData()) if self._there else np.zeros((0, 3))

    def set_shown(self, on: bool) -> None:
        """Whether they are in the picture at all."""
        self._shown = on
        self.actor.SetVisibility(self._there and on)


def outlines(points: NDArray[np.float64], normals: NDArray[np.float32], triangles: Vertices, groups: list[Vertices]) -> Any:
    """Smoothed borders of groups of vertices, or None: of the triangles all of whose corners belong to one group."""
    count = len(points)
    borders = []
    for group in groups:
        member = np.zeros(count, np.bool_)
        member[group] = True
        inside = triangles[member[triangles].all(axis=1)]
        edges = np.concatenate([inside[:, [0, 1]], inside[:, [1, 2]], inside[:, [2, 0]]])
        edges.sort(axis=1)
        keys, times = np.unique(edges[:, 0] * count + edges[:, 1], return_counts=True)
        border = keys[times == 1]
        borders.append(np.column_stack([border // count, border % count]))
    segments = np.concatenate(borders) if borders else np.zeros((0, 2), np.int64)
    if not len(segments):
        return None
    used, numbers = np.unique(segments, return_inverse=True)
    poly = _poly(points[used] + _LIFT_MM * normals[used])
    poly.SetLines(_cells(numbers.reshape(-1, 2)))
    smooth = vtkSmoothPolyDataFilter()
    smooth.SetInputData(_joined(poly))
    smooth.SetNumberOfIterations(15)
    smooth.SetRelaxationFactor(0.3)
    smooth.SetEdgeAngle(180.0)
    smooth.Update()
    return smooth.GetOutput()


def level_lines(points: NDArray[np.float64], triangles: Vertices, values: NDArray[np.float64], levels: Sequence[float]) -> Any:
    """Lines on which values (v,) reach one of the levels, over the triangles where all are finite; small loops left out; or None."""
    poly = _poly(points)
    poly.SetPolys(_cells(triangles[np.isfinite(values)[triangles].all(axis=1)]))
    poly.GetPointData().SetScalars(copied(np.nan_to_num(values)))
    contour = vtkContourFilter()
    contour.SetInputData(poly)
    for number, level in enumerate(levels):
        contour.SetValue(number, level)
    contour.Update()
    joined = _joined(contour.GetOutput())
    lines = joined.GetLines()
    starts, corners = numbers_of(lines.GetOffsetsArray()), numbers_of(lines.GetConnectivityArray())
    sizes = np.diff(starts)
    long = sizes >= _FEWEST_POINTS
    if not long.any():
        return None
    kept = vtkCellArray()
    kept.SetData(copied_ids(np.concatenate([[0], np.cumsum(sizes[long])])), copied_ids(corners[np.repeat(long, sizes)].astype(np.int64)))
    joined.SetLines(kept)
    return joined


def plane_lines(points: NDArray[np.float64], triangles: Vertices, origin: NDArray[np.float64], normal: NDArray[np.float64]) -> Any:
    """Where triangles meet the plane through `origin` across `normal` (3,), or None; VTK's cutters take twenty times as long."""
    height = (points - origin) @ normal
    above = height > 0
    times = above[triangles].sum(axis=1)
    met = (times == 1) | (times == 2)
    crossed = triangles[met]
    if not len(crossed):
        return None
    lone = (above[crossed] == (times[met] == 1)[:, None]).argmax(axis=1)  # the corner that is alone on its side
    number = np.arange(len(crossed))
    tip = crossed[number, lone]
    ends = []
    for step in (1, 2):
        foot = crossed[number, (lone + step) % 3]
        share = height[tip] / (height[tip] - height[foot])
        ends.append(points[tip] + share[:, None] * (points[foot] - points[tip]))
    poly = _poly(np.concatenate(ends))
    poly.SetLines(_cells(np.column_stack([number, number + len(number)])))
    return poly


def segments(starts: NDArray[np.float64], ends: NDArray[np.float64]) -> Any:
    """Straight lines from points (n, 3) mm to points (n, 3), or None for none."""
    if not len(starts):
        return None
    number = np.arange(len(starts))
    poly = _poly(np.concatenate([starts, ends]))
    poly.SetLines(_cells(np.column_stack([number, number + len(number)])))
    return poly


def paths(lines: Sequence[NDArray[np.float64]]) -> Any:
    """Lines through points (k, 3) mm each, or None for none."""
    long = [line for line in lines if len(line) > 1]
    if not long:
        return None
    return segments(np.concatenate([line[:-1] for line in long]), np.concatenate([line[1:] for line in long]))


def together(polys: Sequence[Any]) -> Any:
    """Several lines as one, or None."""
    if not any(poly is not None for poly in polys):
        return None
    append = vtkAppendPolyData()
    for poly in polys:
        if poly is not None:
            append.AddInputData(poly)
    append.Update()
    return append.GetOutput()


def _joined(poly: Any) -> Any:
    """Segments put together to long lines."""
    stripper = vtkStripper()
    stripper.SetInputData(poly)
    stripper.JoinContiguousSegmentsOn()
    stripper.SetMaximumLength(1_000_000)
    stripper.Update()
    return stripper.GetOutput()


def _poly(points: NDArray[np.float64]) -> Any:
    places = vtkPoints()
    places.SetData(copied(points.astype(np.float32)))
    poly = vtkPolyData()
    poly.SetPoints(places)
    return poly


def _cells(corners: Vertices) -> Any:
    """Cells (n, k) of k corners each."""
    count, size = corners.shape
    cells = vtkCellArray()
    cells.SetData(copied_ids(np.arange(0, size * count + 1, size, dtype=np.int64)), copied_ids(corners.astype(np.int64).ravel()))
    return cells
