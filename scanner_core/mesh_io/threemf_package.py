"""Reading 3MF (3MF Consortium, Core Specification 1.3; parts in several files: Production Extension 1.1).

A package from outside is not believed: of a zip entry no more is unpacked than its file pays for, objects that use each
other in a circle or a million times are refused, and XML that declares entities is not read.
"""

from __future__ import annotations

import io
import zipfile
import zlib

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.malformed import MalformedError, checked_vertices, shown
from scanner_core.mesh_io.threemf_model import ModelObject, ModelPart, Use, parse_part, unit_of_part
from scanner_core.mesh_io.xml_events import Elements, hear

UNITS_MM = {"micron": 1e-3, "millimeter": 1.0, "centimeter": 10.0, "inch": 25.4, "foot": 304.8, "meter": 1000.0}
"""The words of the specification, in millimetres."""

_MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
_RELATION = "{http://schemas.openxmlformats.org/package/2006/relationships}Relationship"
_FREE_BYTES, _MOST_GROWTH = 16 << 20, 60
"""Unpacked parts and built corners may be so large, beyond so many times the file: XML of numbers packs about 10:1."""
_DEEPEST = 32
"""Objects inside each other."""
_MOST_ENTRIES = 10_000
_MOST_USES = 5_000


def parse_3mf(content: bytes) -> TriangleMesh:
    """The mesh of a 3MF file's bytes in millimetres: everything that is to be built, each object in its place.

    A motion that mirrors turns the triangles round, so that they keep facing outwards.

    Raises
    ------
    MalformedError
        The bytes are no 3MF with triangles.
    """
    package = _Package(content)
    root = package.part(package.root)
    if root.unit not in UNITS_MM:
        raise MalformedError(f"its unit {shown(root.unit.encode('ascii', 'replace'))} is none of {', '.join(UNITS_MM)}")
    build = _Build(package, len(content))
    for item in root.items:
        build.put(item, package.root, np.eye(4), 0)
    mesh = build.mesh()
    return TriangleMesh(checked_vertices(mesh.vertices * UNITS_MM[root.unit]), mesh.triangles)


def unit_of_3mf(content: bytes) -> str:
    """The word of a 3MF file's unit, a key of :data:`UNITS_MM`; MalformedError as :func:`parse_3mf`."""
    package = _Package(content)
    return unit_of_part(package.unpacked(package.root))


class _Package:
    """The parts of a zip, each unpacked at most once and never beyond the room that is left."""

    def __init__(self, content: bytes) -> None:
        self._room = _FREE_BYTES + _MOST_GROWTH * len(content)
        self._parts: dict[str, ModelPart] = {}
        try:
            self._zip = zipfile.ZipFile(io.BytesIO(content))
        except (zipfile.BadZipFile, ValueError, OSError, NotImplementedError, OverflowError) as fault:
            raise MalformedError(f"it is no 3MF package ({fault})") from None
        entries = self._zip.infolist()
        if len(entries) > _MOST_ENTRIES:
            raise MalformedError(f"its package has {len(entries)} files, and {_MOST_ENTRIES} are the limit")
        self._entries = {_key(entry.filename): entry for entry in entries}
        self.root = self._root()

    def part(self, name: str) -> ModelPart:
        """The model part of that name."""
        key = _key(name)
        if key not in self._parts:
            self._parts[key] = parse_part(self.unpacked(name))
        return self._parts[key]

    def _root(self) -> str:
        """Where the package's relations say that the model stands."""
        relations = _Relations()
        hear(self.unpacked("_rels/.rels"), relations)
        if relations.target is None:
            raise MalformedError("its package names no model")
        return relations.target

    def unpacked(self, part: str) -> bytes:
        """The bytes of a part."""
        name = shown(part.encode("ascii", "replace"))
        entry = self._entries.get(_key(part))
        if entry is None:
            raise MalformedError(f"its package lacks the part {name}")
        if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED) or entry.flag_bits & 1:
            raise MalformedError(f"its part {name} is encrypted or packed in a way that 3MF does not know")
        if entry.file_size > self._room:
            raise MalformedError(f"its part {name} unpacks to {entry.file_size:,} bytes, too many for a file of this size")
        try:
            with self._zip.open(entry) as file:
                content = file.read(entry.file_size + 1)
        except (zipfile.BadZipFile, zlib.error, ValueError, OSError, EOFError, NotImplementedError, RuntimeError, OverflowError):
            raise MalformedError(f"its part {name} is damaged") from None
        self._room -= len(content)
        return content


def _key(name: str) -> str:
    """Part names are compared without regard to case, and some begin with a slash."""
    return name.lower().lstrip("/")


class _Build:
    """Collects the triangles of all that is built."""

    def __init__(self, package: _Package, size: int) -> None:
        self._package = package
        self._room = (_FREE_BYTES + _MOST_GROWTH * size) // 24
        self._uses = 0
        self._vertices: list[NDArray[np.float64]] = []
        self._triangles: list[NDArray[np.int64]] = []
        self._count = 0

    def put(self, use: Use, part: str, outer: NDArray[np.float64], depth: int) -> None:
        """Add an object and all that it is made of; `outer` (4, 4) acts on rows."""
        self._uses += 1
        if depth > _DEEPEST or self._uses > _MOST_USES:
            raise MalformedError("its objects use each other in a circle, or too often")
        place = use.path or part
        found = self._package.part(place).objects.get(use.object_id)
        if found is None:
            raise MalformedError(f"it uses the object {shown(use.object_id.encode('ascii', 'replace'))}, which is not there")
        if depth == 0 and found.kind in ("support", "solidsupport", "other"):
            return  # what a printer adds is no part of the body
        motion = np.eye(4)
        motion[:, :3] = use.motion
        with np.errstate(all="ignore"):
            motion = motion @ outer
        self._add(found, motion)
        for component in found.components:
            self.put(component, place, motion, depth + 1)

    def mesh(self) -> TriangleMesh:
        if not self._vertices:
            return TriangleMesh(np.empty((0, 3)), np.empty((0, 3), np.int64))
        return TriangleMesh(np.concatenate(self._vertices), np.concatenate(self._triangles))

    def _add(self, found: ModelObject, motion: NDArray[np.float64]) -> None:
        if len(found.vertices) == 0:
            return
        self._room -= len(found.vertices) + len(found.triangles)
        if self._room < 0:
            raise MalformedError("its objects are used so often that they are too large for the file that holds them")
        with np.errstate(all="ignore"):
            self._vertices.append(checked_vertices(found.vertices @ motion[:3, :3] + motion[3, :3]))
            mirrored = bool(np.linalg.det(motion[:3, :3]) < 0)
        self._triangles.append((found.triangles[:, ::-1] if mirrored else found.triangles) + self._count)
        self._count += len(found.vertices)


class _Relations(Elements):
    """Keeps the first relation to a model."""

    target: str | None = None

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        if tag == _RELATION and attributes.get("Type") == _MODEL_TYPE and self.target is None:
            self.target = attributes.get("Target", "")
