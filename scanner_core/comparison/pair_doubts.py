"""What two surfaces together give reason to doubt, before they are aligned."""

from __future__ import annotations

import re
from collections.abc import Iterator
from datetime import datetime

import numpy as np

from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.one_line import one_line

LARGEST_RATIO = 2.0
"""Of the sizes; a surface of which one half is missing is some 0.7 times as large as the whole, another unit 2.54 times or more."""
_OPPOSITES = (("left", "right"), ("upper", "lower"), ("maxilla", "mandible"))
_UNIT_RATIOS = (
    (2.54, "centimetres and inches"),
    (10.0, "millimetres and centimetres"),
    (25.4, "millimetres and inches"),
    (1000.0, "millimetres and metres"),
)


def pair_doubts(before: ComparedSurface, after: ComparedSurface) -> tuple[Doubt, ...]:
    """The same file twice, orders that contradict each other, sizes that do not belong together; gravest first."""
    found = [*_identical(before, after), *_orders(before, after), *_sizes(before.mesh, after.mesh), *_dates(before, after)]
    return tuple(sorted(found, key=lambda doubt: not doubt.serious))


def _identical(before: ComparedSurface, after: ComparedSurface) -> Iterator[Doubt]:
    same_mesh = before.mesh.vertices.shape == after.mesh.vertices.shape and np.array_equal(before.mesh.vertices, after.mesh.vertices)
    if before.sha256 == after.sha256:
        yield Doubt.told("identical-files", True, before=before.name, after=after.name)
    elif same_mesh and np.array_equal(before.mesh.triangles, after.mesh.triangles):
        yield Doubt.told("identical-surfaces", True, before=before.name, after=after.name)


def _orders(before: ComparedSurface, after: ComparedSurface) -> Iterator[Doubt]:
    """A field that only one of the two fills in says nothing."""
    for key, code in (("type", "types-differ"), ("side", "sides-differ")):
        first, second = (str(surface.origin.get(key) or "").strip() for surface in (before, after))
        if _contradict(first, second):
            yield Doubt.told(code, True, before=before.name, first=one_line(first), after=after.name, second=one_line(second))
    patients = [surface.origin.get("patient_code") for surface in (before, after)]
    if all(patients) and patients[0] != patients[1]:
        yield Doubt.told("patients-differ", True, before=before.name, after=after.name)


def _contradict(first: str, second: str) -> bool:
    """Whether two entries of an order cannot both be right: no word in common, or opposite words."""
    one, two = (set(re.findall(r"\w+", entry.casefold())) for entry in (first, second))
    opposite = any(a in one - two and b in two - one for pair in _OPPOSITES for a, b in (pair, pair[::-1]))
    return bool(one and two) and (not one & two or opposite)


def _sizes(before: TriangleMesh, after: TriangleMesh) -> Iterator[Doubt]:
    ratio = _spread_mm(after) / _spread_mm(before)
    if 1 / LARGEST_RATIO <= ratio <= LARGEST_RATIO:
        return
    more = max(ratio, 1 / ratio)
    known = next(({"units": names, "factor": f"{factor:g}"} for factor, names in _UNIT_RATIOS if abs(more / factor - 1) < 0.15), {})
    yield Doubt.told("sizes-differ/units" if known else "sizes-differ", True, ratio=f"{ratio:.3g}", **known)


def _spread_mm(mesh: TriangleMesh) -> float:
    """Root mean square distance of the surface from its centroid: of the shape alone, not of its pose."""
    areas, middles = mesh.areas(), mesh.vertices[mesh.triangles].mean(axis=1)
    weights = areas / areas.sum()
    return float(np.sqrt(weights @ ((middles - weights @ middles) ** 2).sum(axis=1)))


def _dates(before: ComparedSurface, after: ComparedSurface) -> Iterator[Doubt]:
    try:
        first, second = (datetime.fromisoformat(str(surface.origin["date"])) for surface in (before, after))
        late = first > second
    except (KeyError, TypeError, ValueError):
        return
    if late:
        times = {"first": f"{first:%Y-%m-%d %H:%M}", "second": f"{second:%Y-%m-%d %H:%M}"}
        yield Doubt.told("dates-exchanged", False, before=before.name, after=after.name, **times)
