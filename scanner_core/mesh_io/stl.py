"""STL, binary and ASCII (3D Systems, StereoLithography Interface Specification, 1989)."""

from __future__ import annotations

import re
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld
from scanner_core.mesh_io.malformed import MalformedError, checked_triangles, checked_vertices, line_of, shown

_HEADER_BYTES = 80
_FACET = np.dtype([("normal", "<f4", (3,)), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])

_NUMBERS = rb"\s+(\S+)" * 3
_ASCII_FACET = re.compile(
    rb"\s*facet\s+normal(?:\s+\S+){3}\s+outer\s+loop" + (rb"\s+vertex" + _NUMBERS) * 3 + rb"\s+endloop\s+endfacet(?=\s)", re.IGNORECASE
)
_ASCII_BETWEEN = re.compile(rb"\s*(?:endsolid[^\n]*|solid[^\n]*)(?:\n|\Z)", re.IGNORECASE)


def parse_stl(content: bytes) -> TriangleMesh:
    """The mesh of an STL file's bytes; equal corners are welded.

    Raises
    ------
    MalformedError
        The bytes are no STL; the place is named.
    """
    corners = _ascii_corners(content) if _is_ascii(content) else _binary_corners(content)
    vertices, index = weld(checked_vertices(corners))
    return TriangleMesh(vertices, checked_triangles(index.reshape(-1, 3), len(vertices)))


def write_stl(file: BinaryIO, mesh: TriangleMesh, remark: str = "", unit: str = "mm") -> None:
    """Binary STL; the header says ``UNITS=mm``, or whatever the numbers are in, then the remark; the normals follow the triangles' winding."""
    title = f"Impronta binary STL UNITS={unit} {remark}".encode("ascii", "replace")[:_HEADER_BYTES]
    facets = np.zeros(len(mesh.triangles), _FACET)
    normal = mesh.area_vectors()
    length = np.linalg.norm(normal, axis=1)
    facets["normal"] = normal / np.where(length > 0, length, 1.0)[:, None]
    facets["corners"] = mesh.vertices[mesh.triangles]
    file.write(title.ljust(_HEADER_BYTES, b" "))
    file.write(np.uint32(len(facets)).astype("<u4").tobytes())
    file.write(facets.tobytes())


def _is_ascii(content: bytes) -> bool:
    """Binary files may begin with 'solid' too, so their length decides first."""
    if content[:512].lstrip()[:5].lower() != b"solid":
        return False
    if len(content) >= _HEADER_BYTES + 4:
        count = int.from_bytes(content[_HEADER_BYTES : _HEADER_BYTES + 4], "little")
        if len(content) == _HEADER_BYTES + 4 + count * _FACET.itemsize:
            return False
    return b"\0" not in content[:4096]


def _binary_corners(content: bytes) -> NDArray[np.float64]:
    start = _HEADER_BYTES + 4
    if len(content) < start:
        raise MalformedError(f"it ends after {len(content)} bytes, within the header of {start} bytes")
    count = int.from_bytes(content[_HEADER_BYTES:start], "little")
    end = start + count * _FACET.itemsize
    if end > len(content):
        there = (len(content) - start) // _FACET.itemsize
        raise MalformedError(f"its header announces {count} triangles, but the file ends after {there}")
    if content[end:].strip(b"\0 \t\r\n"):
        raise MalformedError(f"its header announces {count} triangles, but {len(content) - end} bytes follow them")
    facets = np.frombuffer(content, _FACET, count, start)
    with np.errstate(invalid="ignore"):  # a signalling NaN; it is refused by its place later
        return np.asarray(facets["corners"].reshape(-1, 3), np.float64)


def _ascii_corners(content: bytes) -> NDArray[np.float64]:
    numbers: list[bytes] = []
    position = 0
    closed = True
    while True:
        if (facet := _ASCII_FACET.match(content, position)) and not closed:
            numbers += facet.groups()
            position = facet.end()
        elif between := _ASCII_BETWEEN.match(content, position):
            closed = between.group().lstrip()[:3].lower() == b"end"
            position = between.end()
        else:
            break
    rest = content[position:].lstrip()
    if rest or not closed:
        line = line_of(content, len(content) - len(rest))
        what = f"line {line} is no facet: {shown(rest.splitlines()[0])}" if rest else f"it ends in line {line} without 'endsolid'"
        raise MalformedError(what)
    corners = np.empty(len(numbers))
    for row, number in enumerate(numbers):
        try:
            corners[row] = float(number)
        except ValueError:
            raise MalformedError(f"corner {row // 3 + 1} has the coordinate {shown(number)}, which is no number") from None
    return corners.reshape(-1, 3)
