"""A stable region out of a file: what a person marked elsewhere."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.surface import ComparedSurface
from scanner_core.errors import InputFileError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.proximity import closest_points
from scanner_core.mesh_io.reader import file_content, mesh_of
from scanner_core.mesh_io.stated_unit import MM, stated_unit
from scanner_core.one_line import one_line

REACH_MM = 0.2
"""A vertex this close to the surface of a mask belongs to it: parts that another program cut out are remeshed a little."""

_RENUMBERED = ("points-joined", "points-loose")


def read_mask(path: Path, after: ComparedSurface) -> NDArray[np.bool_]:
    """(v,) bool, the vertices of `after` that a file marks as stable.

    Either JSON, a list of vertex numbers (from 0, in the order in which the file of `after` names them first), or a mesh: the
    stable part cut out of `after`, where it lies in that file; its unit is what its file says, else that of `after`.

    Raises
    ------
    InputFileError
        E-FILE-01, -02, -03, -05 as any mesh; E-CMP-23 when it marks nothing, or what is not there, or numbers what was renumbered.
    """
    content = file_content(path)
    if path.suffix.lower() == ".json":
        if any(doubt.code in _RENUMBERED for doubt in after.doubts):
            reason = f"points of {after.name} were joined or left out, so the numbers of its file are no longer theirs; give the part as a mesh"
            raise InputFileError("E-CMP-23", path=path, reason=reason)
        return _listed(path, content, len(after.mesh.vertices))
    part = mesh_of(path, content)
    unit = stated_unit(path.suffix.lower(), content)
    if path.suffix.lower() != ".3mf":  # whose reader gives millimetres
        part = TriangleMesh(part.vertices * MM[unit or after.unit], part.triangles)
    marked = np.asarray(closest_points(part, after.mesh.vertices).distances_mm <= REACH_MM, np.bool_)
    if not marked.any():
        raise InputFileError("E-CMP-23", path=path, reason=f"no vertex of {after.name} lies within {REACH_MM} mm of it")
    return marked


def _listed(path: Path, content: bytes, count: int) -> NDArray[np.bool_]:
    try:
        numbers = json.loads(content)
    except (ValueError, RecursionError) as fault:
        raise InputFileError("E-CMP-23", path=path, reason=f"it is no JSON ({one_line(fault)})") from fault
    if not isinstance(numbers, list) or not numbers or not all(isinstance(n, int) and not isinstance(n, bool) for n in numbers):
        raise InputFileError("E-CMP-23", path=path, reason="it is no list of vertex numbers")
    if wrong := [n for n in numbers if not 0 <= n < count]:
        raise InputFileError("E-CMP-23", path=path, reason=f"it names the vertex {one_line(wrong[0])}, but there are {count} (from 0)")
    marked = np.zeros(count, np.bool_)
    marked[numbers] = True
    return marked
