"""Arrays as they stand in a case: little endian, compressed with zlib.  What is unpacked is checked; a case may be damaged.

Every function that unpacks raises ValueError or zlib.error for what cannot be right.
"""

from __future__ import annotations

import json
import re
import zlib

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh

_LEVEL = 1
"""Coordinates hardly compress; the higher levels take ten times as long for three percent."""

LARGEST = 1 << 30
"""Bytes of an unpacked array; the coordinates of 45 million vertices."""
_HIGHEST_RATIO, _FREE = 250, 1 << 20
"""Coordinates and indices are packed to a tenth at best; beyond a first MiB a small file must not become a large array."""


def packed(array: NDArray[np.generic], kind: str) -> bytes:
    return zlib.compress(np.ascontiguousarray(array, np.dtype(kind)).tobytes(), _LEVEL)


def unpacked(data: bytes, kind: str) -> NDArray[np.generic]:
    """One-dimensional."""
    return np.frombuffer(_inflated(data, min(LARGEST, _FREE + _HIGHEST_RATIO * len(data))), np.dtype(kind))


def packed_bits(flags: NDArray[np.bool_]) -> bytes:
    return zlib.compress(np.packbits(flags).tobytes(), _LEVEL)


def unpacked_bits(data: bytes, count: int) -> NDArray[np.bool_]:
    if not 0 <= count <= 8 * LARGEST:
        raise ValueError(f"{count} elements")
    flat = np.frombuffer(_inflated(data, (count + 7) // 8), np.uint8)
    if len(flat) != (count + 7) // 8:
        raise ValueError(f"{len(flat)} bytes for {count} elements")
    return np.unpackbits(flat, count=count).astype(np.bool_)


def mesh_columns(mesh: TriangleMesh) -> tuple[bytes, bytes, str, bytes]:
    """Vertices, triangles, and the names, types and values of the attributes."""
    names = sorted(mesh.vertex_attributes)
    header = [[name, mesh.vertex_attributes[name].dtype.newbyteorder("<").str] for name in names]
    body = b"".join(np.ascontiguousarray(mesh.vertex_attributes[name], np.dtype(kind)).tobytes() for name, kind in header)
    return packed(mesh.vertices, "<f8"), packed(mesh.triangles, "<i4"), json.dumps(header), zlib.compress(body, _LEVEL)


def mesh_of(vertices: bytes, triangles: bytes, header: str, body: bytes) -> TriangleMesh:
    """The reverse of :func:`mesh_columns`."""
    points = unpacked(vertices, "<f8").reshape(-1, 3).astype(np.float64)
    faces = unpacked(triangles, "<i4").reshape(-1, 3).astype(np.int64)
    if not np.isfinite(points).all():
        raise ValueError("a vertex is not finite")
    if len(faces) and not 0 <= faces.min() <= faces.max() < len(points):
        raise ValueError("a triangle has a vertex that is not there")
    columns = [(str(name), _number_type(kind)) for name, kind in json.loads(header)]
    flat = _inflated(body, len(points) * sum(kind.itemsize for _, kind in columns))
    attributes, offset = {}, 0
    for name, kind in columns:
        attributes[name] = np.frombuffer(flat, kind, len(points), offset).copy()
        offset += attributes[name].nbytes
    return TriangleMesh(points, faces, attributes)


def _number_type(kind: object) -> np.dtype[np.generic]:
    """Of an attribute: such as ``<f4``, nothing else that numpy would take for a type."""
    if not isinstance(kind, str) or not re.fullmatch(r"[<>|][biuf][1248]", kind):
        raise ValueError("an attribute holds no numbers")
    return np.dtype(kind)


def _inflated(data: bytes, most: int) -> bytes:
    """All of it, but never more than `most` bytes."""
    stream = zlib.decompressobj()
    content = stream.decompress(data, most + 1)
    if len(content) > most:
        raise ValueError("an array is larger than it may be")
    if not stream.eof:
        raise ValueError("an array is cut short")
    return content
