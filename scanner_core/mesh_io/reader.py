"""Reading meshes and point clouds by the suffix of the file; files from outside are not believed."""

from __future__ import annotations

import stat
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from scanner_core.errors import InputFileError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io.malformed import MalformedError
from scanner_core.mesh_io.obj import parse_obj
from scanner_core.mesh_io.ply import parse_ply
from scanner_core.mesh_io.points import parse_npy_points, parse_ply_points, parse_text_points
from scanner_core.mesh_io.stl import parse_stl
from scanner_core.mesh_io.threemf_package import parse_3mf
from scanner_core.mesh_io.vtp import parse_vtp

T = TypeVar("T")

MOST_BYTES = 1 << 30
"""Larger files are not read: 1 GiB is a binary STL of 21 million triangles, and reading takes some times as much memory."""

MESH_PARSERS: dict[str, Callable[[bytes], TriangleMesh]] = {
    ".stl": parse_stl,
    ".ply": parse_ply,
    ".obj": parse_obj,
    ".vtp": parse_vtp,
    ".3mf": parse_3mf,
}
POINT_PARSERS: dict[str, Callable[[bytes], PointCloud]] = {
    ".ply": parse_ply_points,
    ".xyz": parse_text_points,
    ".txt": parse_text_points,
    ".csv": parse_text_points,
    ".asc": parse_text_points,
    ".npy": parse_npy_points,
}


def read_mesh(path: Path | str) -> TriangleMesh:
    """A triangle mesh from STL (binary or ASCII; equal corners are welded), PLY, OBJ or VTP in the file's unit, or from 3MF,
    which says its unit, in mm.

    Polygons are triangulated; triangles that name a vertex twice are left out.  The scalar vertex properties of PLY
    and VTP become vertex attributes.  Winding, order of the vertices and everything else stay as they are in the file.

    Raises
    ------
    InputFileError
        E-FILE-01 missing, E-FILE-02 no such mesh (with reason and place), E-FILE-03 no triangles, E-FILE-05 unreadable.
    """
    return mesh_of(Path(path), file_content(Path(path)))


def mesh_of(path: Path, content: bytes) -> TriangleMesh:
    """As :func:`read_mesh`, of the bytes that :func:`file_content` gave."""
    mesh = _parsed(path, content, MESH_PARSERS, "E-FILE-02")
    if len(mesh.triangles) == 0:
        raise InputFileError("E-FILE-03", path=path)
    return mesh


def read_points(path: Path | str) -> PointCloud:
    """A point cloud from PLY, text (XYZ, TXT, CSV, ASC) or NPY, in the file's unit.

    Raises
    ------
    InputFileError
        E-FILE-01 missing, E-FILE-04 no points (with reason and place), E-FILE-05 unreadable.
    """
    cloud = _parsed(Path(path), file_content(Path(path)), POINT_PARSERS, "E-FILE-04")
    if len(cloud) == 0:
        raise InputFileError("E-FILE-04", path=path, reason="it holds no points")
    return cloud


def _parsed(path: Path, content: bytes, parsers: dict[str, Callable[[bytes], T]], code: str) -> T:
    parse = parsers.get(path.suffix.lower())
    if parse is None:
        raise InputFileError(code, path=path, reason=f"files that end in '{path.suffix}' are not known")
    if not content:
        raise InputFileError(code, path=path, reason="it is empty")
    try:
        return parse(content)
    except MalformedError as fault:
        raise InputFileError(code, path=path, reason=fault) from fault
    except MemoryError as fault:
        raise InputFileError(code, path=path, reason="this computer has too little memory for it") from fault


def file_content(path: Path) -> bytes:
    """The bytes of a file of at most :data:`MOST_BYTES`; InputFileError E-FILE-01 missing, E-FILE-05 unreadable."""
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise InputFileError("E-FILE-05", path=path, reason="it is no file")
        if status.st_size > MOST_BYTES:
            raise InputFileError("E-FILE-05", path=path, reason=f"it has {status.st_size:,} bytes, and {MOST_BYTES:,} are the limit")
        with path.open("rb") as file:
            return file.read(status.st_size)  # a file that grows meanwhile is cut off here
    except InputFileError:
        raise
    except FileNotFoundError as fault:
        raise InputFileError("E-FILE-01", path=path) from fault
    except (OSError, ValueError) as fault:
        raise InputFileError("E-FILE-05", path=path, reason=getattr(fault, "strerror", None) or fault) from fault
    except MemoryError as fault:
        raise InputFileError("E-FILE-05", path=path, reason="this computer has too little memory for it") from fault
