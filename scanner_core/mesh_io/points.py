"""Point clouds in files: text with columns, NPY, and PLY."""

from __future__ import annotations

import io
import re
import warnings
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io.malformed import MalformedError, checked_vertices, line_of, shown
from scanner_core.mesh_io.ply import parse_ply_elements, write_ply_elements

_COMMENT = re.compile(rb"(?:#|//|%)[^\n]*")
_AXIS = re.compile(r"^(?:points?[_:])?([xyz])(?:$|[^a-z0-9]|mm$)|^points[_:]([012])$")
_UNIT = re.compile(rb"[\[(][^\])]{0,40}[\])]")
_NUMBER = re.compile(rb"[-+]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eEdD][-+]?\d++)?|[-+]?(?:nan|inf(?:inity)?)", re.IGNORECASE)
"""Possessive: a long row of digits that is no number is looked at once."""
_COVARIANCE = tuple((f"covariance_{a}{b}_mm2", "xyz".index(a), "xyz".index(b)) for a, b in ("xx", "xy", "xz", "yy", "yz", "zz"))


def parse_text_points(content: bytes) -> PointCloud:
    """Points of a text file's bytes.

    Columns are separated by blanks, tabs, commas or semicolons; with semicolons a comma is a decimal comma.  ``#``,
    ``//`` and ``%`` start a comment.  A line of names may come first: columns named x, y and z are taken, otherwise the
    first three.  A first line with one whole number, the count of the points, is passed over.

    Raises
    ------
    MalformedError
        The line that cannot be read.
    """
    text = _COMMENT.sub(b"", _utf8(content)).replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    if b"\0" in text:
        raise MalformedError("it is no text")
    header, start = _first_line(text)
    body = text[start:]
    semicolons = b";" in (header + body[:4096])
    if semicolons and b"," in body:
        body = body.replace(b",", b".")
    body = body.translate(bytes.maketrans(b",;\t", b"   "))
    words = re.split(rb";" if semicolons else rb"\s*[,\t]\s*|\s+", _UNIT.sub(b"", header).strip())
    names = [word.strip(b" \"'").decode("ascii", "replace").lower() for word in words]
    if not body.strip():
        return PointCloud(np.empty((0, 3)))
    if not re.search(rb"\d", body):
        raise MalformedError("it holds no numbers")
    columns = _columns(names)
    try:
        table = np.loadtxt(io.BytesIO(body), np.float64, comments=None, ndmin=2, encoding="latin-1")
    except ValueError as fault:
        raise _bad_line(body, line_of(text, start), fault) from None
    if table.shape[1] < 3:
        raise MalformedError(f"it has {table.shape[1]} columns, but x, y and z are needed")
    if max(columns) >= table.shape[1]:
        raise MalformedError(f"it has {table.shape[1]} columns, but its first line names {len(names)}")
    return PointCloud(checked_vertices(table[:, columns]))


def parse_npy_points(content: bytes) -> PointCloud:
    """Points of an NPY file's bytes: an array of numbers (n, 3) or with more columns; never pickled objects."""
    file = io.BytesIO(content)
    try:
        version = np.lib.format.read_magic(file)
        if version not in ((1, 0), (2, 0)):
            raise ValueError(f"version {version} of NPY")
        read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        with warnings.catch_warnings(action="ignore"):  # that Python 2 wrote it is no news to a person
            shape, fortran, kind = read(file)
    except Exception as fault:  # the header is a Python expression: a damaged one raises nearly anything
        raise MalformedError(f"its NPY header is damaged ({shown(str(fault).encode(), 80)})") from None
    if kind.kind not in "fiu" or kind.fields is not None or kind.subdtype is not None:
        raise MalformedError(f"it holds {shown(str(kind).encode(), 40)} instead of numbers")
    if len(shape) != 2 or shape[1] < 3 or shape[0] < 0:
        raise MalformedError(f"it holds an array of the shape {shape} instead of (n, 3)")
    if shape[0] * shape[1] * kind.itemsize > len(content) - file.tell():
        raise MalformedError(f"its header announces {shape[0]} points, but the file is too short for them")
    flat = np.frombuffer(content, kind, shape[0] * shape[1], file.tell())
    return PointCloud(checked_vertices(flat.reshape(shape, order="F" if fortran else "C")[:, :3]))


def parse_ply_points(content: bytes) -> PointCloud:
    """Points of a PLY file's bytes, with covariances, views and trigger ids when it carries them."""
    ply = parse_ply_elements(content)
    known = ply.vertex_attributes
    covariances = None
    if all(name in known for name, _, _ in _COVARIANCE):
        covariances = np.empty((len(ply.vertices), 3, 3))
        for name, i, j in _COVARIANCE:
            covariances[:, i, j] = covariances[:, j, i] = known[name]
        if not np.isfinite(covariances).all():
            raise MalformedError("its covariances are not finite")
    views = known["view"].astype(np.int32) if "view" in known and known["view"].dtype.kind in "iu" else None
    ids = known["trigger_id"].astype(np.int64) if "trigger_id" in known and known["trigger_id"].dtype.kind in "iu" else None
    return PointCloud(ply.vertices, covariances, views, ids)


def write_ply_points(file: BinaryIO, cloud: PointCloud) -> None:
    """Binary little endian PLY in millimetres, double, with all that is known of each point."""
    attributes: dict[str, NDArray[np.generic]] = {}
    if cloud.covariances is not None:
        attributes |= {name: cloud.covariances[:, i, j] for name, i, j in _COVARIANCE}
    if cloud.views is not None:
        attributes["view"] = cloud.views.astype(np.int32)
    if cloud.trigger_ids is not None:
        attributes["trigger_id"] = cloud.trigger_ids.astype(np.int32)
    write_ply_elements(file, cloud.points, attributes, None, "f8")


def write_xyz_points(file: BinaryIO, cloud: PointCloud) -> None:
    """Text with x, y and z in millimetres to the nanometre."""
    file.write(b"# x_mm y_mm z_mm\n")
    for begin in range(0, len(cloud), 20_000):
        part = cloud.points[begin : begin + 20_000]
        file.write((b"%.6f %.6f %.6f\n" * len(part)) % tuple(part.ravel().tolist()))


def _utf8(content: bytes) -> bytes:
    """Text that other programs saved as UTF-16, or with a byte order mark."""
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", "replace").encode("utf-8")
    return content.removeprefix(b"\xef\xbb\xbf")


def _first_line(text: bytes) -> tuple[bytes, int]:
    """The first line when it is no row of numbers (names, or a count), and where the rows start."""
    at = len(text) - len(text.lstrip())
    end = text.find(b"\n", at)
    line = text[at:] if end < 0 else text[at:end]
    words = re.split(rb"[,;\s]+", line.strip())
    numeric = [_NUMBER.fullmatch(word) is not None for word in words if word]
    if not line or (numeric and all(numeric) and len(numeric) > 1):
        return b"", at
    if any(numeric) and len(numeric) > 1 and not any(re.match(rb"[\"']?[A-Za-z]", word) for word in words):
        return b"", at  # a damaged row of numbers, to be refused with its line
    return line, len(text) if end < 0 else end + 1


def _columns(names: list[str]) -> list[int]:
    """Which columns are x, y and z."""
    found: dict[str, int] = {}
    for place, name in enumerate(names):
        if match := _AXIS.match(name):
            found.setdefault((match.group(1) or match.group(2)).translate(str.maketrans("012", "xyz")), place)
    return [found[axis] for axis in "xyz"] if len(found) == 3 else [0, 1, 2]


def _bad_line(body: bytes, first_line: int, fault: ValueError) -> MalformedError:
    """Name the line that the table parser stumbled over."""
    columns = 0
    for number, line in enumerate(body.split(b"\n"), first_line):
        words = line.split()
        if not words:
            continue
        columns = columns or len(words)
        if len(words) != columns:
            return MalformedError(f"line {number} has {len(words)} columns where the first row has {columns}")
        for word in words:
            try:
                float(word)
            except ValueError:
                return MalformedError(f"line {number} holds {shown(word)}, which is no number")
    return MalformedError(str(fault))
