"""Arrays as they stand in a case: little endian, compressed with zlib.  Nothing is unpacked beyond the size that is expected."""

from __future__ import annotations

import json
import zlib

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh

_LEVEL = 1
"""Coordinates hardly compress; the higher levels take ten times as long for three percent."""


def packed(array: NDArray[np.generic], kind: str) -> bytes:
    return zlib.compress(np.ascontiguousarray(array, np.dtype(kind)).tobytes(), _LEVEL)


def unpacked(data: bytes, kind: str) -> NDArray[np.generic]:
    """One-dimensional, writable; ValueError or zlib.error when it is damaged."""
    return np.frombuffer(zlib.decompress(data), np.dtype(kind)).copy()


def packed_bits(flags: NDArray[np.bool_]) -> bytes:
    return zlib.compress(np.packbits(flags).tobytes(), _LEVEL)


def unpacked_bits(data: bytes, count: int) -> NDArray[np.bool_]:
    flat = np.frombuffer(zlib.decompress(data), np.uint8)
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
    """The reverse of :func:`mesh_columns`; ValueError or zlib.error when it is damaged."""
    points = np.frombuffer(zlib.decompress(vertices), "<f8").reshape(-1, 3).astype(np.float64)
    faces = np.frombuffer(zlib.decompress(triangles), "<i4").reshape(-1, 3).astype(np.int64)
    flat, attributes, offset = zlib.decompress(body), {}, 0
    for name, kind in json.loads(header):
        attributes[name] = np.frombuffer(flat, np.dtype(kind), len(points), offset).copy()
        offset += attributes[name].nbytes
    return TriangleMesh(points, faces, attributes)
