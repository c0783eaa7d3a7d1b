"""Writing meshes and point clouds by the suffix of the file; a file appears whole or not at all."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import BinaryIO, TypeVar

from scanner_core.errors import InputFileError
from scanner_core.files import replaced_when_whole
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io.obj import write_obj
from scanner_core.mesh_io.ply import write_ply
from scanner_core.mesh_io.points import write_ply_points, write_xyz_points
from scanner_core.mesh_io.stated_unit import MM
from scanner_core.mesh_io.stl import write_stl
from scanner_core.mesh_io.threemf import write_3mf

T = TypeVar("T")

MESH_WRITERS: dict[str, Callable[[BinaryIO, TriangleMesh], None]] = {".stl": write_stl, ".ply": write_ply, ".obj": write_obj, ".3mf": write_3mf}
POINT_WRITERS: dict[str, Callable[[BinaryIO, PointCloud], None]] = {".xyz": write_xyz_points, ".ply": write_ply_points}


def write_mesh(path: Path | str, mesh: TriangleMesh, *, force: bool = False, remark: str = "", unit: str = "mm") -> None:
    """Write a mesh in mm as STL, PLY, OBJ or 3MF.

    Parameters
    ----------
    remark : one short line for the header of STL (51 characters) and PLY; the other formats have no place for it
    unit : of the numbers in the file, which says so: mm, cm, m or inch

    Raises
    ------
    InputFileError
        E-FILE-06, the suffix is not known.
    StorageError
        E-DISK-01 no space, E-DISK-02 not allowed, E-DISK-03 exists and not `force`; `path` is then as it was.
    """
    if unit != "mm":
        mesh = TriangleMesh(mesh.vertices / MM[unit], mesh.triangles, mesh.vertex_attributes)
    writers: dict[str, Callable[[BinaryIO, TriangleMesh], None]] = {
        ".stl": partial(write_stl, remark=remark, unit=unit),
        ".ply": partial(write_ply, remark=remark, unit=unit),
        ".obj": partial(write_obj, unit=unit),
        ".3mf": partial(write_3mf, unit=unit),
    }
    _written(Path(path), mesh, writers, force)


def write_points(path: Path | str, cloud: PointCloud, *, force: bool = False) -> None:
    """Write points in mm as XYZ text, or as PLY with covariances, views and trigger ids; errors as `write_mesh`."""
    _written(Path(path), cloud, POINT_WRITERS, force)


def check_suffix(path: Path | str, *, points: bool = False) -> None:
    """Say before long work whether its result can be written under this name; E-FILE-06 when not."""
    known = POINT_WRITERS if points else MESH_WRITERS
    suffix = Path(path).suffix.lower()
    if suffix not in known:
        raise InputFileError("E-FILE-06", suffix=Path(path).suffix, known=", ".join(known))


def _written(path: Path, value: T, writers: dict[str, Callable[[BinaryIO, T], None]], force: bool) -> None:
    writer = writers.get(path.suffix.lower())
    if writer is None:
        raise InputFileError("E-FILE-06", suffix=path.suffix, known=", ".join(writers))
    with replaced_when_whole(path, force) as unfinished, unfinished.open("wb") as file:
        writer(file, value)
