"""A compared surface made ready to draw and to point at, away from the GUI thread."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkBinnedDecimation

from app.views.surface_picker import SurfacePicker
from app.views.vtk_arrays import copied, copied_ids
from scanner_core.geometry.mesh import TriangleMesh

_COARSE_TRIANGLES = 18_000
"""Drawn of each surface while the camera moves on a machine that is slow at it."""
_FEW = 2000
"""Vertices that stand for the surface where only its extent matters."""


@dataclass(frozen=True, slots=True, eq=False)
class DrawnSurface:
    """A mesh with what drawing it needs.

    Attributes
    ----------
    mesh : as it came
    normals : (v, 3) float32
    few : (k, 3) mm, some thousand vertices, those that lie farthest out among them
    poly : as VTK has it, with its normals
    coarse : fewer triangles between the same vertices; None where there are few already
    picker : rays into it
    """

    mesh: TriangleMesh
    normals: NDArray[np.float32]
    few: NDArray[np.float64]
    poly: Any
    coarse: Any
    picker: SurfacePicker

    @classmethod
    def of(cls, mesh: TriangleMesh) -> DrawnSurface:
        places = vtkPoints()
        places.SetData(copied(mesh.vertices.astype(np.float32)))
        triangles = np.ascontiguousarray(mesh.triangles, np.int64)
        cells = vtkCellArray()
        cells.SetData(copied_ids(np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)), copied_ids(triangles.ravel()))
        poly = vtkPolyData()
        poly.SetPoints(places)
        poly.SetPolys(cells)
        normals = mesh.vertex_normals().astype(np.float32)
        poly.GetPointData().SetNormals(copied(normals))
        coarse = _thinned(mesh, poly) if len(triangles) > 1.5 * _COARSE_TRIANGLES else None
        return cls(mesh, normals, _few(mesh.vertices), poly, coarse, SurfacePicker(mesh, poly, normals))


def _few(vertices: NDArray[np.float64]) -> NDArray[np.float64]:
    """Every so many of the vertices (v, 3), and the outermost ones to 26 sides."""
    sides = np.array([[x, y, z] for x in (0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)], np.float64)
    along = vertices @ sides.T
    outermost = np.unique(np.concatenate([along.argmin(axis=0), along.argmax(axis=0)]))
    return np.concatenate([vertices[outermost], vertices[:: max(len(vertices) // _FEW, 1)]])


def _thinned(mesh: TriangleMesh, poly: Any) -> Any:
    """The same vertices with fewer triangles between them: one vertex a cell of a grid (Lindstrom 2000), a few ten milliseconds."""
    low, high = mesh.bounds()
    edge_mm = np.sqrt(2.3 * mesh.area() / _COARSE_TRIANGLES)
    thin = vtkBinnedDecimation()
    thin.SetInputData(poly)
    thin.AutoAdjustNumberOfDivisionsOff()
    thin.SetNumberOfDivisions(*(int(max(extent / edge_mm, 1)) for extent in high - low))
    thin.SetPointGenerationModeToUseInputPoints()
    thin.Update()
    coarse = vtkPolyData()
    coarse.SetPoints(poly.GetPoints())
    coarse.SetPolys(thin.GetOutput().GetPolys())
    return coarse
