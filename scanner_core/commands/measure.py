"""``impronta measure``: canal length, volume, area, and a section of a case's surface or of a mesh file."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.commands.console import Console
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.measuring.canal import measure_canal
from scanner_core.measuring.enclosed_volume import measure_volume
from scanner_core.measuring.section import SectionPlane, measure_section
from scanner_core.mesh_io import read_mesh


def run(given: argparse.Namespace, console: Console) -> int:
    path = Path(given.file)
    mesh = _mesh(path)
    volume, canal = measure_volume(mesh), measure_canal(mesh)
    values: dict[str, object] = {
        "file": str(path),
        "area_mm2": mesh.area(),
        "volume_mm3": None if volume is None else volume.volume_mm3,
        "volume_at_most_off_mm3": None if volume is None else volume.uncertainty_mm3,
        "canal_mm": None if canal is None else canal.length_mm,
        "canal_opens": None if canal is None else canal.opens,
    }
    lines = [f"Surface: {mesh.area():.1f} mm2"]
    lines.append("Volume: none, the surface is not closed" if volume is None else f"Volume: {volume.volume_mm3:.1f} mm3")
    if volume is not None and volume.uncertainty_mm3 is not None:
        lines[-1] += f", at most {volume.uncertainty_mm3:.1f} mm3 off"
    end = "where it opens" if canal is not None and canal.opens else "the other end"
    lines.append("Canal: none from the highest point" if canal is None else f"Canal: {canal.length_mm:.2f} mm from its tip to {end}")
    if given.height is not None:
        cut = measure_section(mesh, SectionPlane.through(np.array([0.0, 0.0, given.height]), np.array([0.0, 0.0, 1.0])))
        area = None if cut is None else cut.area_mm2
        values |= {"section_height_mm": given.height, "section_mm2": area, "section_perimeter_mm": None if cut is None else cut.perimeter_mm}
        told = "the plane does not meet the surface" if cut is None else f"perimeter {cut.perimeter_mm:.2f} mm"
        lines.append(f"Section at {given.height:g} mm: " + (told if area is None else f"{area:.2f} mm2, {told}"))
    console.result(values, lines)
    return 0


def _mesh(path: Path) -> TriangleMesh:
    """Of a case, or of a mesh file in millimetres."""
    if path.suffix.lower() != SUFFIX:
        return read_mesh(path)
    with CaseStore.open(path, read_only=True) as store:
        return store.mesh()[0]
