"""PLY, ASCII and binary (Turk, The PLY Polygon File Format, Stanford 1994)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.malformed import MalformedError, checked_triangles, checked_vertices, line_of, shown
from scanner_core.mesh_io.polygons import triangulated
from scanner_core.mesh_io.precision import single_is_enough
from scanner_core.one_line import one_line

_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip
_NAMES = {"i1": "char", "u1": "uchar", "i2": "short", "u2": "ushort", "i4": "int", "u4": "uint", "f4": "float", "f8": "double"}
_FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_LONGEST_HEADER = 100_000

Column = NDArray[np.generic]


@dataclass(frozen=True, slots=True)
class _Property:
    name: str
    type: str
    length_type: str | None = None  # of a list


@dataclass(slots=True)
class _Element:
    name: str
    count: int
    properties: list[_Property]


@dataclass(frozen=True, slots=True, eq=False)
class Ply:
    """What a PLY file holds.

    Attributes
    ----------
    vertices : (v, 3) float64
    vertex_attributes : the other scalar properties of the vertices, name -> (v,) in the type of the file
    corners, lengths : the vertex indices of all faces one after the other, and the number of corners of each face
    """

    vertices: NDArray[np.float64]
    vertex_attributes: dict[str, Column]
    corners: NDArray[np.int64]
    lengths: NDArray[np.int64]


def parse_ply(content: bytes) -> TriangleMesh:
    """The mesh of a PLY file's bytes; polygons are triangulated.

    Raises
    ------
    MalformedError
        The bytes are no PLY with faces; the place is named.
    """
    ply = parse_ply_elements(content)
    triangles = triangulated(ply.vertices, ply.corners, ply.lengths)
    return TriangleMesh(ply.vertices, checked_triangles(triangles, len(ply.vertices)), ply.vertex_attributes)


def parse_ply_elements(content: bytes) -> Ply:
    """Vertices, their attributes and faces of a PLY file's bytes; MalformedError names the place of a fault."""
    order, elements, start = _header(content)
    source = _Numbers(content, start) if order == "" else _Bytes(content, start, order)
    found: dict[str, dict[str, Column]] = {}
    lengths: dict[str, NDArray[np.int64]] = {}
    for element in elements:
        columns, sizes = _read_element(source, element)
        if element.name not in found:
            found[element.name] = columns
            lengths[element.name] = sizes
    vertex = dict(found.get("vertex", {}))
    if not {"x", "y", "z"} <= set(vertex):
        raise MalformedError("its header declares no vertices with x, y and z")
    points = np.column_stack([np.asarray(vertex.pop(axis), np.float64) for axis in "xyz"])
    corners = next((found["face"][name] for name in ("vertex_indices", "vertex_index") if name in found.get("face", {})), None)
    sizes = lengths["face"] if corners is not None else np.empty(0, np.int64)
    with np.errstate(invalid="ignore"):
        indices = np.empty(0, np.int64) if corners is None else np.asarray(corners, np.int64)
    scalars = {p.name: p.type for e in elements if e.name == "vertex" for p in e.properties if p.length_type is None}
    attributes = {name: _of_type(column, name, scalars[name]) for name, column in vertex.items() if name in scalars}
    return Ply(checked_vertices(points), attributes, indices, sizes)


def write_ply_elements(
    file: BinaryIO,
    vertices: NDArray[np.float64],
    attributes: dict[str, Column],
    triangles: NDArray[np.int64] | None,
    coordinate_type: str = "f4",
    remark: str = "",
    unit: str = "mm",
) -> None:
    """Binary little endian PLY of vertices (v, 3) with one property for each attribute (v,), and triangles (t, 3); `remark` is a comment, `unit`
    what its comment says that the coordinates are in."""
    fields = [(axis, "<" + coordinate_type) for axis in "xyz"]
    fields += [(name, "<" + column.dtype.str[1:]) for name, column in attributes.items()]
    rows = np.zeros(len(vertices), np.dtype(fields))
    for i, axis in enumerate("xyz"):
        rows[axis] = vertices[:, i]
    for name, column in attributes.items():
        rows[name] = column
    header = ["ply", "format binary_little_endian 1.0", f"comment Impronta, unit: {unit}", f"element vertex {len(rows)}"]
    header[3:3] = [f"comment {one_line(remark)}"] if remark else []
    header += [f"property {_NAMES[kind[1:]]} {name}" for name, kind in fields]
    if triangles is not None:
        header += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    file.write(("\n".join([*header, "end_header"]) + "\n").encode("ascii", "replace"))
    file.write(rows.tobytes())
    if triangles is not None:
        faces = np.zeros(len(triangles), np.dtype([("length", "u1"), ("corners", "<i4", (3,))]))
        faces["length"], faces["corners"] = 3, triangles
        file.write(faces.tobytes())


def write_ply(file: BinaryIO, mesh: TriangleMesh, remark: str = "", unit: str = "mm") -> None:
    """Binary little endian PLY in millimetres, or in what `unit` says, with the mesh's vertex attributes as properties
    (``standard_uncertainty_um`` as float, ``supported`` as uchar); `remark` is a comment.

    Coordinates are float, and double where the origin is so far away that float would move vertices visibly."""
    attributes: dict[str, Column] = {}
    for name, column in mesh.vertex_attributes.items():
        if name == "supported":
            column = np.asarray(column, np.uint8)
        elif column.dtype.str[1:] not in _NAMES or name == "standard_uncertainty_um":
            column = np.asarray(column, np.float32)
        attributes[name] = column
    write_ply_elements(file, mesh.vertices, attributes, mesh.triangles, "f4" if single_is_enough(mesh.vertices) else "f8", remark, unit)


def _header(content: bytes) -> tuple[str, list[_Element], int]:
    """Byte order ('' for ASCII), the elements and where they start."""
    if not content.startswith((b"ply\n", b"ply\r")):
        raise MalformedError("it does not begin with the line 'ply'")
    end = content.find(b"end_header", 0, _LONGEST_HEADER)
    start = content.find(b"\n", end) + 1
    if end < 0 or start == 0:
        raise MalformedError("its header has no line 'end_header'")
    order: str | None = None
    elements: list[_Element] = []
    for number, line in enumerate(content[:end].splitlines(), 1):
        match [word.decode("ascii", "replace") for word in line.split()]:
            case ["ply"] | [] | ["comment", *_] | ["obj_info", *_]:
                pass
            case ["format", name, *_] if name in _FORMATS:
                order = _FORMATS[name]
            case ["element", name, count] if count.isdigit() and len(count) < 16:
                elements.append(_Element(name, int(count), []))
            case ["property", "list", length_type, type_, name] if elements and {length_type, type_} <= set(_TYPES):
                if "f" in _TYPES[length_type]:
                    raise MalformedError(f"line {number} counts the list '{name}' with the type '{length_type}'")
                elements[-1].properties.append(_Property(name, _TYPES[type_], _TYPES[length_type]))
            case ["property", type_, name] if elements and type_ in _TYPES:
                elements[-1].properties.append(_Property(name, _TYPES[type_]))
            case _:
                raise MalformedError(f"line {number} of its header is not understood: {shown(line)}")
    if order is None:
        raise MalformedError("its header has no line 'format'")
    for element in elements:
        if len({p.name for p in element.properties}) < len(element.properties):
            raise MalformedError(f"its header declares a property of '{element.name}' twice")
    return order, elements, start


class _Bytes:
    """The elements of a binary file, taken one after the other."""

    def __init__(self, content: bytes, position: int, order: str) -> None:
        self._content, self._position, self._order = content, position, order

    def width(self, kind: str, count: int) -> int:
        return int(kind[1]) * count

    def left(self) -> int:
        return len(self._content) - self._position

    def rows(self, fields: list[tuple[str, int]], count: int) -> list[Column]:
        """`count` rows of fields (type, number of values); the room has been checked."""
        row = np.dtype([(f"f{i}", self._order + kind, (number,)) for i, (kind, number) in enumerate(fields)])
        table = np.frombuffer(self._content, row, count, self._position)
        self._position += count * row.itemsize
        return [table[f"f{i}"].astype(kind) for i, (kind, _) in enumerate(fields)]

    def mark(self) -> int:
        return self._position

    def back(self, mark: int) -> None:
        self._position = mark


class _Numbers(_Bytes):
    """The elements of an ASCII file: the same, counted in numbers."""

    def __init__(self, content: bytes, position: int) -> None:
        super().__init__(b"", 0, "")
        try:
            self._values = np.fromstring(content[position:], np.float64, sep=" ")
        except (ValueError, DeprecationWarning):
            raise _no_number(content, position) from None

    def width(self, kind: str, count: int) -> int:
        return count

    def left(self) -> int:
        return len(self._values) - self._position

    def rows(self, fields: list[tuple[str, int]], count: int) -> list[Column]:
        width = sum(number for _, number in fields)
        table = self._values[self._position : self._position + count * width].reshape(count, width)
        self._position += count * width
        columns, begin = [], 0
        for kind, number in fields:
            with np.errstate(invalid="ignore", over="ignore"):
                columns.append(table[:, begin : begin + number].astype(kind if kind[0] == "f" else "i8"))
            begin += number
        return columns


def _no_number(content: bytes, position: int) -> MalformedError:
    line = line_of(content, position)
    for number, text in enumerate(content[position:].split(b"\n"), line):
        for word in text.split():
            try:
                float(word)
            except ValueError:
                return MalformedError(f"line {number} holds {shown(word)}, which is no number")
    return MalformedError("its numbers cannot be read")


def _read_element(source: _Bytes, element: _Element) -> tuple[dict[str, Column], NDArray[np.int64]]:
    """All rows of one element: scalars as (n,), lists joined to one array; and the lengths of the last list.

    Nearly always all rows are alike (triangles): then they are one table.  Only otherwise they are read row by row.
    """
    if not element.properties:
        return {}, np.zeros(0, np.int64)
    if all(p.length_type is None for p in element.properties):
        width = sum(source.width(p.type, 1) for p in element.properties)
        if element.count * width > source.left():
            raise _too_short(element, source.left() // width)
        columns = source.rows([(p.type, 1) for p in element.properties], element.count)
        return {p.name: column[:, 0] for p, column in zip(element.properties, columns, strict=True)}, np.zeros(0, np.int64)
    mark = source.mark()
    if element.count > 0:
        first = _read_row(source, element, 0)
        source.back(mark)
        alike = _read_alike(source, element, [len(values) for values in first])
        if alike is not None:
            return alike
        source.back(mark)
    rows = [_read_row(source, element, row) for row in range(element.count)]
    joined: dict[str, Column] = {}
    lengths = np.zeros(0, np.int64)
    for i, p in enumerate(element.properties):
        joined[p.name] = np.concatenate([row[i] for row in rows]) if rows else np.empty(0)
        if p.length_type is not None:
            lengths = np.array([len(row[i]) for row in rows], np.int64)
    return joined, lengths


def _read_alike(source: _Bytes, element: _Element, lengths: list[int]) -> tuple[dict[str, Column], NDArray[np.int64]] | None:
    fields: list[tuple[str, int]] = []
    for p, length in zip(element.properties, lengths, strict=True):
        fields += [(p.type, 1)] if p.length_type is None else [(p.length_type, 1), (p.type, length)]
    if element.count * sum(source.width(kind, number) for kind, number in fields) > source.left():
        return None
    columns = iter(source.rows(fields, element.count))
    joined: dict[str, Column] = {}
    last = 0
    for p, length in zip(element.properties, lengths, strict=True):
        if p.length_type is not None:
            if (next(columns) != length).any():
                return None
            last = length
        joined[p.name] = next(columns).reshape(-1)
    return joined, np.full(element.count, last, np.int64)


def _read_row(source: _Bytes, element: _Element, row: int) -> list[Column]:
    values: list[Column] = []
    for p in element.properties:
        length = 1
        if p.length_type is not None:
            if source.left() < source.width(p.length_type, 1):
                raise _too_short(element, row)
            length = int(source.rows([(p.length_type, 1)], 1)[0][0, 0])
            if length < 0:
                raise MalformedError(f"{element.name} {row + 1} has a list of {length} values")
        if source.left() < source.width(p.type, length):
            raise _too_short(element, row)
        values.append(source.rows([(p.type, length)], 1)[0].reshape(-1))
    return values


def _of_type(column: Column, name: str, kind: str) -> Column:
    """Values of an ASCII file in the type that the header declares."""
    if column.dtype.str[1:] == kind:
        return column
    narrow = column.astype(kind)
    if (narrow != column).any():
        raise MalformedError(f"the property '{name}' has values that do not fit its type {_NAMES[kind]}")
    return narrow


def _too_short(element: _Element, there: int) -> MalformedError:
    return MalformedError(f"its header announces {element.count} of '{element.name}', but the file ends after {there}")
