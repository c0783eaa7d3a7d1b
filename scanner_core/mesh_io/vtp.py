"""VTP, the XML file of a vtkPolyData (VTK's "XML file formats" reference): ASCII, base64 and appended arrays.

VTK's own reader is not used for files from outside: it believes the offsets and counts of the file.
"""

from __future__ import annotations

import base64
import binascii
import re
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.inflation import COMPRESSORS, inflated
from scanner_core.mesh_io.malformed import MalformedError, checked_triangles, checked_vertices, shown
from scanner_core.mesh_io.polygons import triangulated

_TYPES = {
    "Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4", "UInt32": "u4", "Int64": "i8", "UInt64": "u8",
    "Float32": "f4", "Float64": "f8",
}  # fmt: skip
_MOST_VALUES = 1_000_000_000
_MOST_GROWTH, _FREE_BYTES = 200, 64 << 20
"""All arrays together may be so many times as large as the file, beyond the first 64 MiB: any number of arrays can name the same bytes."""
_TOO_LARGE = "its arrays together are too large for the file that holds them"
_APPENDED = re.compile(rb"<AppendedData[^>]{0,200}>\s{0,200}_")  # bounded: a search that fails stays linear

Column = NDArray[np.generic]


def parse_vtp(content: bytes) -> TriangleMesh:
    """The mesh of a VTP file's bytes: all pieces together, polygons and strips triangulated, point arrays with one
    component as vertex attributes.

    Raises
    ------
    MalformedError
        The bytes are no VTP; the array is named.
    """
    root, appended = _tree(content)
    arrays = _Arrays(root, appended, _FREE_BYTES + _MOST_GROWTH * len(content))
    pieces = root.findall("PolyData/Piece")
    if root.tag != "VTKFile" or root.get("type") != "PolyData" or not pieces:
        raise MalformedError("it is no VTKFile of the type PolyData")
    meshes = [_piece(arrays, piece, number) for number, piece in enumerate(pieces, 1)]
    first = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    names = set.intersection(*(set(mesh.vertex_attributes) for mesh in meshes))
    return TriangleMesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([mesh.triangles + begin for mesh, begin in zip(meshes, first[:-1], strict=True)]),
        {name: np.concatenate([mesh.vertex_attributes[name] for mesh in meshes]) for name in sorted(names)},
    )


class _Builder(ElementTree.TreeBuilder):
    """Refuses a document type where it begins, in any encoding: entities are declared there."""

    def doctype(self, _name: str, _public: str | None, _system: str | None) -> None:
        raise MalformedError("its XML declares entities, which no VTP needs")


def _tree(content: bytes) -> tuple[ElementTree.Element, bytes]:
    """The XML without the appended bytes (raw ones are no XML), and those bytes from behind the underscore on."""
    appended = b""
    if found := _APPENDED.search(content):
        end = content.rfind(b"</AppendedData>")
        if end < found.end():
            raise MalformedError("it ends within its appended data")
        appended = content[found.end() : end]
        content = content[: found.end() - 1] + content[end:]
    parser = ElementTree.XMLParser(target=_Builder())
    try:
        parser.feed(content)
        return parser.close(), appended
    except MalformedError:
        raise
    except (ElementTree.ParseError, LookupError, ValueError) as fault:
        raise MalformedError(f"its XML is damaged ({fault})") from None


def _piece(arrays: _Arrays, piece: ElementTree.Element, number: int) -> TriangleMesh:
    count = _whole(piece, "NumberOfPoints", f"piece {number}")
    points = piece.find("Points/DataArray")
    if points is None:
        raise MalformedError(f"piece {number} has no points")
    vertices = checked_vertices(np.asarray(arrays.read(points, 3 * count), np.float64).reshape(-1, 3))
    triangles = triangulated(vertices, *_cells(arrays, piece, "Polys", number))
    strips = _strips(*_cells(arrays, piece, "Strips", number))
    attributes = {}
    for array in piece.findall("PointData/DataArray"):
        if array.get("NumberOfComponents", "1") == "1" and array.get("Name") and array.get("type") in _TYPES:
            attributes[array.get("Name", "")] = arrays.read(array, count)
    return TriangleMesh(vertices, checked_triangles(np.concatenate([triangles, strips]), len(vertices)), attributes)


def _cells(arrays: _Arrays, piece: ElementTree.Element, kind: str, number: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """All corners of the cells of a kind, and the number of corners of each."""
    count = _whole(piece, f"NumberOf{kind}", f"piece {number}") if piece.get(f"NumberOf{kind}") else 0
    if count == 0:
        return np.empty(0, np.int64), np.empty(0, np.int64)
    named = {array.get("Name"): array for array in piece.findall(f"{kind}/DataArray")}
    if not {"connectivity", "offsets"} <= set(named):
        raise MalformedError(f"piece {number} has no connectivity or no offsets for its {kind}")
    ends = arrays.read(named["offsets"], count).astype(np.int64)
    lengths = np.diff(ends, prepend=0)
    if (ends < 0).any() or (lengths < 0).any():
        raise MalformedError(f"the offsets of the {kind} in piece {number} do not rise")
    corners = arrays.read(named["connectivity"], None).astype(np.int64)
    if len(corners) < ends[-1]:
        raise MalformedError(f"the {kind} of piece {number} have {len(corners)} corners, but their offsets end at {ends[-1]}")
    return corners[: ends[-1]], lengths


def _strips(corners: NDArray[np.int64], lengths: NDArray[np.int64]) -> NDArray[np.int64]:
    """Triangles (t, 3) of triangle strips; every second one is turned round."""
    if len(corners) < 3:
        return np.empty((0, 3), np.int64)
    strip = np.repeat(np.arange(len(lengths)), lengths)
    place = np.arange(len(corners)) - np.repeat(np.cumsum(lengths) - lengths, lengths)
    whole = np.flatnonzero(strip[:-2] == strip[2:])
    triangles = corners[whole[:, None] + np.arange(3)]
    odd = place[whole] % 2 == 1
    triangles[odd] = triangles[odd][:, [1, 0, 2]]
    return np.asarray(triangles, np.int64)


def _whole(element: ElementTree.Element, name: str, place: str) -> int:
    text = (element.get(name) or "").strip()
    if not (text.isascii() and text.isdigit() and len(text) < 16):
        raise MalformedError(f"'{name}' of {place} is no count: {shown(text.encode())}")
    return int(text)


class _Arrays:
    """Reads the DataArray elements of one file."""

    def __init__(self, root: ElementTree.Element, appended: bytes, most_bytes: int) -> None:
        self._room = most_bytes
        self._order = ">" if root.get("byte_order") == "BigEndian" else "<"
        self._header = np.dtype(self._order + ("u8" if root.get("header_type") == "UInt64" else "u4"))
        self._compressor = root.get("compressor")
        if self._compressor is not None and self._compressor not in COMPRESSORS:
            raise MalformedError(f"its compressor {shown(self._compressor.encode())} is not known")
        element = root.find("AppendedData")
        self._raw = element is not None and element.get("encoding") == "raw"
        self._appended = appended

    def read(self, array: ElementTree.Element, count: int | None) -> Column:
        """The values of a DataArray; exactly `count` of them unless that is None."""
        name = f"the array {shown((array.get('Name') or '').encode())}"
        kind = _TYPES.get(array.get("type") or "")
        if kind is None:
            raise MalformedError(f"{name} has the unknown type {shown((array.get('type') or '').encode())}")
        match array.get("format", "ascii"):
            case "ascii":
                values = _numbers(array.text or "", kind, name)
            case "binary":
                values = self._values(self._unbase64("".join((array.text or "").split()).encode("ascii", "replace"), name), kind, name)
            case "appended":
                offset = _whole(array, "offset", name)
                if offset > len(self._appended):
                    raise MalformedError(f"{name} starts at {offset}, behind the end of the appended data ({len(self._appended)} bytes)")
                if self._raw:
                    values = self._values(self._block(self._appended[offset:], name), kind, name)
                else:
                    values = self._values(self._unbase64(self._appended[offset:], name), kind, name)
            case other:
                raise MalformedError(f"{name} has the unknown format {shown(other.encode())}")
        self._room -= values.nbytes
        if self._room < 0:
            raise MalformedError(_TOO_LARGE)
        if count is not None and len(values) != count:
            raise MalformedError(f"{name} holds {len(values)} values where {count} are announced")
        return values

    def _values(self, content: bytes, kind: str, name: str) -> Column:
        width = int(kind[1])
        if len(content) % width:
            raise MalformedError(f"{name} ends within a value")
        return np.frombuffer(content, self._order + kind).astype(kind)

    def _unbase64(self, text: bytes, name: str) -> bytes:
        """Base64 comes in one run (plain) or in two (compressed: the header is encoded on its own)."""
        size = self._header.itemsize
        if self._compressor is None:
            length = int(self._heads(_decoded(text, 0, size, name), 1, name)[0])
            return self._block(_decoded(text, 0, size + length, name), name)
        blocks = int(self._heads(_decoded(text, 0, size, name), 1, name)[0])
        head_bytes = (3 + blocks) * size
        if head_bytes > len(text):
            raise MalformedError(f"{name} announces {blocks} blocks, more than there is room for")
        head = _decoded(text, 0, head_bytes, name)
        skipped = -(-head_bytes // 3) * 4
        body_bytes = int(self._heads(head, 3 + blocks, name)[3:].sum(dtype=object))
        return self._block(head + _decoded(text, skipped, body_bytes, name), name)

    def _block(self, content: bytes, name: str) -> bytes:
        """The bytes of an array from its header on."""
        size = self._header.itemsize
        if self._compressor is None:
            length = int(self._heads(content, 1, name)[0])
            if size + length > len(content):
                raise MalformedError(f"{name} announces {length} bytes, but {len(content) - size} are there")
            return content[size : size + length]
        blocks = int(self._heads(content, 1, name)[0])
        if blocks == 0:
            return b""
        heads = [int(value) for value in self._heads(content, 3 + blocks, name)]
        block_bytes, last_bytes, packed = heads[1], heads[2], heads[3:]
        total = block_bytes * (blocks - 1) + (last_bytes or block_bytes)
        begin = (3 + blocks) * size
        if total > self._room:
            raise MalformedError(_TOO_LARGE)
        if begin + sum(packed) > len(content) or total > _MOST_VALUES:
            raise MalformedError(f"{name} announces more bytes than there are")
        pieces = []
        for number, length in enumerate(packed):
            want = last_bytes if number == blocks - 1 and last_bytes else block_bytes
            pieces.append(inflated(self._compressor, content[begin : begin + length], want, name))
            begin += length
        return b"".join(pieces)

    def _heads(self, content: bytes, count: int, name: str) -> NDArray[np.generic]:
        if count * self._header.itemsize > len(content):
            raise MalformedError(f"{name} ends within its header")
        return np.frombuffer(content, self._header, count)


def _decoded(text: bytes, begin: int, count: int, name: str) -> bytes:
    """`count` bytes out of the base64 text that begins at `begin`."""
    end = begin + -(-count // 3) * 4
    if end > len(text):
        raise MalformedError(f"{name} announces {count} bytes, more than there are")
    try:
        return base64.b64decode(text[begin:end], validate=True)[:count]
    except binascii.Error:
        raise MalformedError(f"{name} holds characters that are no base64") from None


def _numbers(text: str, kind: str, name: str) -> Column:
    try:
        values = np.fromstring(text, np.float64, sep=" ")
    except (ValueError, DeprecationWarning):
        raise MalformedError(f"{name} holds something that is no number") from None
    with np.errstate(invalid="ignore", over="ignore"):
        return values.astype(kind)
