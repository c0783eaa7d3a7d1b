"""One model part of a 3MF package (3MF Consortium, Core Specification 1.3, chapters 3 and 4): objects, components, build."""

from __future__ import annotations

from array import array
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from scanner_core.mesh_io.malformed import MalformedError, checked_triangles, checked_vertices, shown
from scanner_core.mesh_io.xml_events import Elements, hear

_CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
_PRODUCTION_PATH = "{http://schemas.microsoft.com/3dmanufacturing/production/2015/06}path"
_DEFAULT_UNIT = "millimeter"

Motion = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Use:
    """That an object is put somewhere: `motion` (4, 3) acts on rows (x, y, z, 1); `path` names another part of the package."""

    object_id: str
    motion: Motion
    path: str | None


@dataclass(slots=True, eq=False)
class ModelObject:
    """An object: its own triangles, or uses of other objects."""

    kind: str
    vertices: NDArray[np.float64]
    triangles: NDArray[np.int64]
    components: list[Use] = field(default_factory=list)


@dataclass(frozen=True, slots=True, eq=False)
class ModelPart:
    """What one XML part says: its unit's word, its objects by id, and what is to be built."""

    unit: str
    objects: dict[str, ModelObject]
    items: list[Use]


def parse_part(xml: bytes) -> ModelPart:
    """A model part; elements of extensions are passed over.

    Raises
    ------
    MalformedError
        The XML is damaged, declares entities, or holds what is no number.
    """
    builder = _Builder()
    hear(xml, builder)
    return builder.part()


def unit_of_part(xml: bytes) -> str:
    """The word of the unit alone."""
    root = _Root()
    with suppress(StopIteration):
        hear(xml, root)
    return root.unit


class _Root(Elements):
    """Listens to the first element only."""

    unit = ""

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        self.unit = attributes.get("unit", _DEFAULT_UNIT)
        raise StopIteration


class _Builder(Elements):
    """Takes the elements as they come: no tree is made, so the memory is that of the numbers."""

    def __init__(self) -> None:
        self._unit: str | None = None
        self._objects: dict[str, ModelObject] = {}
        self._items: list[Use] = []
        self._object: ModelObject | None = None
        self._id = ""
        self._coordinates, self._corners = array("d"), array("q")

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        if self._unit is None:
            if tag != _CORE + "model":
                raise MalformedError("its model part is no 3MF model")
            self._unit = attributes.get("unit", _DEFAULT_UNIT)
        elif not tag.startswith(_CORE):
            return
        elif self._object is None:
            if tag == _CORE + "object":
                self._begin(attributes)
            elif tag == _CORE + "item":
                self._items.append(_use(attributes))
        elif tag == _CORE + "vertex":
            self._numbers(self._coordinates, float, attributes, ("x", "y", "z"), "vertex")
        elif tag == _CORE + "triangle":
            self._numbers(self._corners, int, attributes, ("v1", "v2", "v3"), "triangle")
        elif tag == _CORE + "component":
            self._object.components.append(_use(attributes))

    def end(self, tag: str) -> None:
        if tag != _CORE + "object" or self._object is None:
            return
        try:
            self._object.vertices = checked_vertices(np.array(self._coordinates, np.float64))
            self._object.triangles = checked_triangles(np.array(self._corners, np.int64), len(self._object.vertices))
        except MalformedError as fault:
            raise MalformedError(f"in its object {shown(self._id.encode())} {fault}") from None
        self._objects[self._id] = self._object
        self._object = None

    def part(self) -> ModelPart:
        return ModelPart(self._unit or "", self._objects, self._items)

    def _begin(self, attributes: dict[str, str]) -> None:
        self._id = attributes.get("id", "")
        if self._id in self._objects:
            raise MalformedError(f"two of its objects have the id {shown(self._id.encode())}")
        self._object = ModelObject(attributes.get("type", "model"), np.empty((0, 3)), np.empty((0, 3), np.int64))
        self._coordinates, self._corners = array("d"), array("q")

    def _numbers(self, into: array[float] | array[int], kind: type, attributes: dict[str, str], names: tuple[str, ...], what: str) -> None:
        try:
            for name in names:
                into.append(kind(attributes[name]))
        except KeyError as fault:
            raise MalformedError(f"{what} {len(into) // 3 + 1} of its object {shown(self._id.encode())} lacks {fault}") from None
        except (ValueError, OverflowError):
            said = shown(attributes[name].encode("ascii", "replace"))
            raise MalformedError(f"{what} {len(into) // 3 + 1} of its object {shown(self._id.encode())} has the {name} {said}") from None


def _use(attributes: dict[str, str]) -> Use:
    """An item of the build, or a component."""
    words = attributes.get("transform", "1 0 0 0 1 0 0 0 1 0 0 0").split()
    try:
        motion = np.array([float(word) for word in words]).reshape(4, 3)
    except ValueError:
        raise MalformedError(f"a transform of it is not made of 12 numbers: {shown(' '.join(words).encode('ascii', 'replace'))}") from None
    if not np.isfinite(motion).all():
        raise MalformedError("a transform of it is not finite")
    return Use(attributes.get("objectid", ""), motion, attributes.get(_PRODUCTION_PATH))
