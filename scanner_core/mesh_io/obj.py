"""Wavefront OBJ: vertices and faces; all else in such a file is passed over."""

from __future__ import annotations

from typing import BinaryIO

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.malformed import MalformedError, checked_triangles, checked_vertices, shown
from scanner_core.mesh_io.polygons import triangulated
from scanner_core.mesh_io.precision import decimals


def parse_obj(content: bytes) -> TriangleMesh:
    """The mesh of an OBJ file's bytes; polygons are triangulated, negative indices count back from the last vertex.

    Raises
    ------
    MalformedError
        A line that cannot be right; it is named.
    """
    coordinates: list[float] = []
    corners: list[int] = []
    lengths: list[int] = []
    number = 0
    for number, line in enumerate(content.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").splitlines(), 1):
        words = line.split(b"#", 1)[0].split()
        if not words:
            continue
        try:
            if words[0] == b"v":
                x, y, z = words[1:4]
                coordinates += (float(x), float(y), float(z))
            elif words[0] == b"f":
                count = len(coordinates) // 3
                for word in words[1:]:
                    index = int(word.split(b"/", 1)[0])
                    if index == 0 or index < -count:
                        raise MalformedError(f"line {number} names the vertex {index}, but {count} vertices stand before it (counted from 1)")
                    corners.append(index - 1 if index > 0 else count + index)
                lengths.append(len(words) - 1)
        except MalformedError:
            raise
        except ValueError:
            raise MalformedError(f"line {number} cannot be right: {shown(line)}") from None
    if number and not coordinates and b"\0" in content:
        raise MalformedError("it is no text")
    if corners and max(corners) >= len(coordinates) // 3:
        raise MalformedError(f"a face names the vertex {max(corners) + 1}, but there are {len(coordinates) // 3} vertices (counted from 1)")
    vertices = checked_vertices(np.array(coordinates, np.float64).reshape(-1, 3))
    triangles = triangulated(vertices, np.array(corners, np.int64), np.array(lengths, np.int64))
    return TriangleMesh(vertices, checked_triangles(triangles, len(vertices)))


def write_obj(file: BinaryIO, mesh: TriangleMesh, unit: str = "mm") -> None:
    """OBJ in millimetres, or in what `unit` says, nine significant digits or, far from the origin, sixteen."""
    file.write(f"# Impronta, unit: {unit}\n".encode("ascii"))
    row = b"v %.9g %.9g %.9g\n".replace(b"9", b"%d" % decimals(mesh.vertices))
    for rows in _chunks(len(mesh.vertices)):
        part = mesh.vertices[rows]
        file.write((row * len(part)) % tuple(part.ravel().tolist()))
    for rows in _chunks(len(mesh.triangles)):
        faces = mesh.triangles[rows] + 1
        file.write((b"f %d %d %d\n" * len(faces)) % tuple(faces.ravel().tolist()))


def _chunks(count: int, size: int = 20_000) -> list[slice]:
    return [slice(begin, begin + size) for begin in range(0, count, size)]
