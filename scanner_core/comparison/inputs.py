"""Surfaces to compare out of files and cases: as they are, in millimetres, with what was noticed about them."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.points import case_calibration, case_rig
from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.surface import LEAST_TRIANGLES, ComparedSurface
from scanner_core.comparison.unit_guess import guessed_unit
from scanner_core.comparison.vetting import vet
from scanner_core.errors import ImprontaError, InputFileError, UsageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.weld import weld
from scanner_core.mesh_io.reader import file_content, mesh_of
from scanner_core.mesh_io.stated_unit import MM, stated_unit

UNITS = ("mm", "cm", "m", "inch")
"""What a person may say."""
_NAMES = {"mm": "millimetres", "cm": "centimetres", "m": "metres", "inch": "inches", "um": "micrometres", "foot": "feet"}


def read_surface(path: Path | str, *, unit: str | None = None) -> ComparedSurface:
    """A surface out of STL, PLY, OBJ, VTP, 3MF or a case (the mesh that counts in it; the case is only looked into).

    Nothing is repaired.  Points of exactly equal place are joined, as STL needs it, and that is said where a file had them
    apart.  What the file's vertices have as ``supported`` and ``standard_uncertainty_um`` is kept.

    Parameters
    ----------
    unit : mm, cm, m or inch, to overrule what the file says or what was guessed from its size; a case is in millimetres

    Raises
    ------
    InputFileError
        E-FILE-01, -02, -03, -05 as for any mesh; E-CMP-20 with too few triangles, E-CMP-21 without any extent, E-CMP-22 when
        none of it was measured.
    CaseError, CaseFormatError, CaseLockedError
        As :meth:`CaseStore.open`; E-CASE-05 a case without a mesh.
    UsageError
        E-USE-01 a unit that is not known, or for a case.
    """
    place = Path(path)
    if unit is not None and unit not in UNITS:
        raise UsageError("E-USE-01", what=f"There is no unit '{unit}'", do=f"use one of {', '.join(UNITS)}")
    if place.suffix.lower() == SUFFIX:
        if unit not in (None, "mm"):
            raise UsageError("E-USE-01", what=f"A case is in millimetres, not in '{unit}'", do="leave the unit away")
        return _of_case(place)
    return _of_file(place, unit)


def mesh_hash(mesh: TriangleMesh) -> str:
    """SHA-256 of the corners' places and the triangles, hexadecimal; the same on every machine."""
    digest = hashlib.sha256(np.asarray(mesh.vertices, "<f8").tobytes())
    digest.update(np.asarray(mesh.triangles, "<i8").tobytes())
    return digest.hexdigest()


def _of_file(path: Path, asked: str | None) -> ComparedSurface:
    content = file_content(path)
    mesh = mesh_of(path, content)
    suffix = path.suffix.lower()
    stated = stated_unit(suffix, content)
    if suffix == ".3mf" and stated is not None:
        mesh = _scaled(mesh, 1 / MM[stated])  # the reader gave millimetres
    mesh, doubts = _joined(mesh)
    low, high = mesh.bounds()
    largest = float((high - low).max())
    guess, why = guessed_unit(largest)
    if asked is not None:
        unit, reason = asked, "as it was asked for" + (f"; the file says {_NAMES[stated]}" if stated not in (None, asked) else "")
    elif stated is not None:
        unit, reason = stated, "the file says so"
    else:
        unit, reason = guess, why
        if unit != "mm":
            # serious, because another unit multiplies every number
            doubts.append(Doubt.told("unit-guessed", True, unit=_NAMES[unit], why=why, mm=f"{largest * MM[unit]:.1f}"))
    if asked is None and stated is not None and stated != guess:
        doubts.append(Doubt.told("unit-odd", False, unit=_NAMES[stated], mm=f"{largest * MM[stated]:.4g}", guess=_NAMES[guess]))
    mesh = _scaled(mesh, MM[unit])
    origin: dict[str, object] = {"kind": "file", "path": str(path), "format": suffix[1:]}
    return _surface(path, mesh, hashlib.sha256(content).hexdigest(), unit, reason, doubts, origin)


def _of_case(path: Path) -> ComparedSurface:
    with CaseStore.open(path, read_only=True) as store:
        return case_surface(store)


def case_surface(store: CaseStore) -> ComparedSurface:
    """The mesh that counts in a case that is open; errors as :func:`read_surface`."""
    mesh, provenance = store.mesh()
    origin: dict[str, object] = {"kind": "case", "path": str(store.path), "mesh_id": store.mesh_id(), "mesh_provenance": provenance}
    order = store.order()
    origin |= {"order": order.number, "side": order.side, "type": order.type}
    # In memory only: to tell patients apart, and for an archive.  `surface_values` writes it nowhere.
    origin["patient_code"] = order.patient_code
    origin |= _measured_with(store, provenance)
    return _surface(store.path, mesh, mesh_hash(mesh), "mm", "a case is in millimetres", [], origin)


def _measured_with(store: CaseStore, provenance: dict[str, object]) -> dict[str, object]:
    """Date, rig and calibration of the newest scan that the mesh was made of; empty where the case does not tell."""
    used = provenance.get("scans")
    scans = [scan for scan in store.scans() if scan.kind == "scan" and (not isinstance(used, list) or not used or scan.id in used)]
    if not scans:
        return {}
    told: dict[str, object] = {"date": scans[-1].started}
    try:
        rig, calibration = case_rig(store, scans[-1])
        named = provenance.get("calibration")
        if isinstance(named, str) and named != scans[-1].calibration_id:
            calibration = case_calibration(store, named)
    except ImprontaError:
        return told  # a rig that is damaged keeps no surface from being compared
    told |= {"rig": rig.name, "calibration_id": calibration.identity(), "calibration_date": calibration.date}
    return told | ({"null_levels": [level.as_dict() for level in rig.null_levels]} if rig.null_levels else {})


def _surface(path: Path, mesh: TriangleMesh, sha256: str, unit: str, reason: str, doubts: list[Doubt], origin: dict[str, object]) -> ComparedSurface:
    if len(mesh.triangles) < LEAST_TRIANGLES:
        raise InputFileError("E-CMP-20", path=path, triangles=len(mesh.triangles), least=LEAST_TRIANGLES)
    low, high = mesh.bounds()
    if not (high - low).max() > 0 or not mesh.area() > 0:
        raise InputFileError("E-CMP-21", path=path)
    supported = _supported(mesh)
    if not supported.any():
        raise InputFileError("E-CMP-22", path=path)
    return ComparedSurface(mesh, path.name, sha256, unit, reason, supported, (*vet(mesh), *doubts), origin)


def _supported(mesh: TriangleMesh) -> NDArray[np.bool_]:
    """What was measured: the attribute of that name, else everything."""
    flags = mesh.vertex_attributes.get("supported")
    return np.ones(len(mesh.vertices), np.bool_) if flags is None else np.asarray(flags != 0, np.bool_)


def _scaled(mesh: TriangleMesh, factor: float) -> TriangleMesh:
    return mesh if factor == 1.0 else TriangleMesh(mesh.vertices * factor, mesh.triangles, mesh.vertex_attributes)


def _joined(mesh: TriangleMesh) -> tuple[TriangleMesh, list[Doubt]]:
    """The mesh with points of exactly equal place as one, and without points that belong to no triangle."""
    vertices, index = weld(mesh.vertices)
    apart = len(mesh.vertices) - len(vertices)
    triangles = index[mesh.triangles]
    used = np.zeros(len(vertices), np.bool_)
    used[triangles] = True
    loose = int(len(vertices) - used.sum())
    if not apart and not loose:
        return mesh, []
    number = np.cumsum(used) - 1
    first = np.full(len(vertices), len(mesh.vertices))
    np.minimum.at(first, index, np.arange(len(index)))
    kept = first[used]
    doubts = []
    if apart:
        doubts.append(Doubt.told("points-joined", False, count=str(apart)))
    if loose:
        doubts.append(Doubt.told("points-loose", False, count=str(loose)))
    a, b, c = triangles.T
    whole = (a != b) & (b != c) & (c != a)
    if not whole.all():
        doubts.append(Doubt.told("triangles-collapsed", False, count=str(int((~whole).sum()))))
    attributes = {name: values[kept] for name, values in mesh.vertex_attributes.items()}
    return TriangleMesh(vertices[used], number[triangles[whole]], attributes), doubts
