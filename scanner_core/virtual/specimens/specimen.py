"""An object that stands on the virtual table, with its truth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

from scanner_core.devices.rig import VolumeConfig
from scanner_core.errors import UsageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.poly_data import poly_data
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

_OPENING = 0.1
"""A mesh is open when its opening is larger than this share of its surface: small holes do not turn an object over."""


@dataclass(frozen=True, slots=True, eq=False)
class Specimen:
    """A specimen in the object frame: it stands on the table, as it was made centred on the axis by its bounding box.

    Attributes
    ----------
    name : as asked for
    mesh : the true surface, mm
    albedo : share of the light that it scatters back
    true_radius_mm : of the sphere, else None
    analytic_distance : unsigned distance of points (n, 3) to the true surface where it has a formula, else None
    pose : how it was put down: from the object frame as it was made to the object frame now
    """

    name: str
    mesh: TriangleMesh
    albedo: float = 1.0
    true_radius_mm: float | None = None
    analytic_distance: Callable[[Array], Array] | None = None
    pose: RigidTransform = field(default_factory=RigidTransform.identity)

    @property
    def radius_mm(self) -> float:
        """Of the smallest cylinder about the axis that holds it."""
        return float(np.hypot(self.mesh.vertices[:, 0], self.mesh.vertices[:, 1]).max())

    @property
    def height_mm(self) -> float:
        """Of its highest point over the table."""
        return float(self.mesh.vertices[:, 2].max())

    def distance_mm(self, points: Array) -> Array:
        """Unsigned distance (n,) of object-frame points (n, 3) to the true surface, mm."""
        if self.analytic_distance is not None:
            return self.analytic_distance(points)
        field = vtkImplicitPolyDataDistance()
        field.SetInput(poly_data(self.mesh))
        distance = vtkDoubleArray()
        field.FunctionValue(numpy_to_vtk(np.ascontiguousarray(points, np.float64), deep=1), distance)
        unsigned: Array = np.abs(vtk_to_numpy(distance).astype(np.float64))
        return unsigned


def opening_down(mesh: TriangleMesh) -> TriangleMesh:
    """An open mesh turned so that it stands on its opening, as a person puts a cast on the table; others as they are.

    The area vectors of a closed surface sum to zero; those of an open one sum to the opening's own area, and face away
    from it.
    """
    faces = mesh.area_vectors().sum(axis=0)
    length = float(np.linalg.norm(faces))
    if length < _OPENING * mesh.area():
        return mesh
    axis = np.cross(faces, [0.0, 0.0, 1.0])
    sine, cosine = float(np.linalg.norm(axis)), float(faces[2])
    # Upside down there is no axis between the two directions: any horizontal one serves.
    unit = axis / sine if sine > 1e-9 * length else np.array([1.0, 0.0, 0.0])
    turn = RigidTransform.from_vector(np.arctan2(sine, cosine) * unit, np.zeros(3))
    return TriangleMesh(turn.apply(mesh.vertices), mesh.triangles, mesh.vertex_attributes)


def stand_on_table(mesh: TriangleMesh) -> TriangleMesh:
    """The mesh moved so that its bounding box is centred on the axis and stands on the table."""
    low, high = mesh.bounds()
    offset = np.array([*(0.5 * (low + high))[:2], low[2]])
    return TriangleMesh(mesh.vertices - offset, mesh.triangles, mesh.vertex_attributes)


def check_fits(specimen: Specimen, volume: VolumeConfig) -> None:
    """Refuse a specimen that the cameras could not see whole.

    Raises
    ------
    UsageError
        E-RIG-02 with both sizes as diameter x height.
    """
    if specimen.radius_mm > volume.radius_mm or specimen.height_mm > volume.height_mm:
        raise UsageError(
            "E-RIG-02",
            size_mm=f"{2 * specimen.radius_mm:.1f} (diameter) x {specimen.height_mm:.1f} (height)",
            volume_mm=f"{2 * volume.radius_mm:.1f} x {volume.height_mm:.1f}",
        )
