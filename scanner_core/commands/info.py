"""``impronta info``: what is in a case, mesh or point file."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.commands.console import Console
from scanner_core.errors import InputFileError
from scanner_core.geometry.checks import check_mesh
from scanner_core.mesh_io import read_mesh, read_points
from scanner_core.mesh_io.formats import MESH_SUFFIXES, holds_triangles

_POINT_ONLY = (".xyz", ".txt", ".csv", ".asc", ".npy")


def run(given: argparse.Namespace, console: Console) -> int:
    path = Path(given.file)
    suffix = path.suffix.lower()
    if suffix == SUFFIX:
        values = _case(path)
    elif not path.exists():
        raise InputFileError("E-FILE-01", path=path)
    elif suffix in _POINT_ONLY or (suffix == ".ply" and not holds_triangles(path)):
        values = _points(path)
    elif suffix in MESH_SUFFIXES:
        values = _mesh(path)
    else:
        raise InputFileError("E-FILE-05", path=path, reason=f"files of the kind '{suffix}' are not known")
    console.result(values, [f"{name}: {value}" for name, value in values.items()])
    return 0


def _case(path: Path) -> dict[str, object]:
    with CaseStore.open(path) as store:
        scans = [
            {
                "kind": scan.kind,
                "started": scan.started,
                "finish_reason": scan.finish_reason or "interrupted",
                "observations": store.verdict_counts(scan.id),
                "counts": scan.counts,
                "calibration": scan.calibration_id,
                "registered_views": len(store.corrections(scan.id)),
            }
            for scan in store.scans()
        ]
        values: dict[str, object] = {"kind": "case", "file": str(path), "order": asdict(store.order()), "scans": scans, "meshes": store.mesh_count()}
        if store.mesh_count():
            mesh, provenance = store.mesh()
            values["mesh"] = {"vertices": len(mesh.vertices), "triangles": len(mesh.triangles), "provenance": provenance}
        return values


def _mesh(path: Path) -> dict[str, object]:
    mesh = read_mesh(path)
    low, high = mesh.bounds()
    checks = check_mesh(mesh)
    return {
        "kind": "mesh",
        "file": str(path),
        "vertices": len(mesh.vertices),
        "triangles": len(mesh.triangles),
        "low_mm": low.round(4).tolist(),
        "high_mm": high.round(4).tolist(),
        "size_mm": (high - low).round(4).tolist(),
        "area_mm2": round(mesh.area(), 4),
        "volume_mm3": round(mesh.volume(), 4) if checks.closed else None,
        "attributes": sorted(mesh.vertex_attributes),
        **checks.as_dict(),
    }


def _points(path: Path) -> dict[str, object]:
    cloud = read_points(path)
    low, high = cloud.points.min(axis=0), cloud.points.max(axis=0)
    return {
        "kind": "points",
        "file": str(path),
        "points": len(cloud),
        "low_mm": low.round(4).tolist(),
        "high_mm": high.round(4).tolist(),
        "size_mm": (high - low).round(4).tolist(),
    }
