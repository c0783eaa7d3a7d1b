"""``impronta info``: what is in a case, mesh or point file."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path
from typing import Any

from scanner_core.acquisition.mark_visits import KIND, case_marks
from scanner_core.case.decoding import damaged
from scanner_core.case.processing import chosen_processing
from scanner_core.case.recovery import describe
from scanner_core.case.store import SUFFIX, CaseStore, MountPose
from scanner_core.commands.console import Console
from scanner_core.comparison.keeping import KeptComparison, kept_comparisons
from scanner_core.errors import InputFileError
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import read_mesh, read_points

_POINT_ONLY = (".xyz", ".txt", ".csv", ".asc", ".npy")


def run(given: argparse.Namespace, console: Console) -> int:
    path = Path(given.file)
    suffix = path.suffix.lower()
    if suffix == SUFFIX:
        values = _case(path)
    elif not path.exists():
        raise InputFileError("E-FILE-01", path=path)
    elif suffix in _POINT_ONLY:
        values = _points(path)
    else:
        values = _mesh_or_points(path)
    console.result(values, _case_words(values) if values["kind"] == "case" else [f"{name}: {value}" for name, value in values.items()])
    return 0


def _case_words(values: dict[str, Any]) -> list[str]:
    """A case in lines that a person reads."""
    order = ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in values["order"].items() if value)
    lines = [f"Case {values['file']}", f"Order: {order or 'none'}"]
    for scan in values["scans"]:
        seen = ", ".join(f"{name} {count}" for name, count in sorted(scan["observations"].items()))
        of = (f" of mount {scan['mount']}" if scan["mount"] else "") + (" by line" if scan["laser"] == "line" else "")
        words = f"{scan['kind'].capitalize()} {scan['id']}{of}: {scan['finish_reason']}, begun {scan['started']}, calibration {scan['calibration']}"
        lines += [words, f"    {seen or 'nothing exposed'}"]
    if values["interrupted"] is not None:
        words = "Interrupted: {measured} of {wanted} points, {views_done} of {views} views complete"
        words += "." if values["scans"][-1]["laser"] == "line" else "; go on with 'impronta scan --resume'."
        lines.append(words.format(**values["interrupted"]))
    if (marks := values.get("marks")) is not None:
        rms = "unknown" if marks["marks_um"] is None else f"{marks['marks_um']:.1f} um"
        lines.append(f"Marks on the table's rim: {rms} rms off their {marks['reference']} distances, {marks['visits']} visits")
    for pose in values["mounts"]:
        words = f"joined, residual {pose['residual_um']} um" if pose["accepted"] else f"kept apart: {pose['reason']}"
        lines.append(f"Mount {pose['mount']}: {words}")
    choice = ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in values["processing"].items() if value and name != "removed")
    removed = values["processing"].get("removed")
    lines.append(f"Points: {choice or 'as scanned'}" + (f", {removed['count']} taken out by hand" if removed else ""))
    mesh = values.get("mesh")
    lines.append(f"Meshes: {values['meshes']}" + (f"; the chosen one has {mesh['triangles']} triangles" if mesh else ""))
    for kept in values["comparisons"]:
        rms = "not known" if kept["rms_um"] is None else f"{kept['rms_um']:.1f} um"
        words = f"Comparison {kept['id']} of {kept['created']}: {kept['after']} against {kept['before']}, frame {kept['frame']}, rms {rms}, "
        words += "reliable" if kept["reliable"] else "NOT reliable"
        lines.append(words + ("" if kept["shown"] else "; undone or replaced") + ("" if kept["of_this_mesh"] else "; of another mesh"))
    return lines


def _comparison(path: Path, kept: KeptComparison) -> dict[str, object]:
    """What a person finds a kept comparison by."""
    values: dict[str, Any] = kept.values
    with damaged(path, f"comparison {kept.id}"):
        rms_um = values["deviation"]["rms_um"]
        return {
            "id": kept.id,
            "created": kept.created,
            "before": str(values["before"]["name"]),
            "after": str(values["after"]["name"]),
            "frame": str(values["alignment"]["frame"]),
            "rms_um": None if rms_um is None else float(rms_um),
            "reliable": bool(values["reliable"]),
            "shown": kept.shown,
            "of_this_mesh": kept.of_this_mesh,
        }


def _mount(pose: MountPose) -> dict[str, object]:
    """How a mount was joined to the first, or why it was not."""
    told = {name: pose.report.get(name) for name in ("first_mount", "start", "overlap_fraction", "residual_um", "margin", "unique", "reason")}
    return {"mount": pose.mount, "accepted": pose.transform is not None, "registered": pose.created, **told}


def _case(path: Path) -> dict[str, object]:
    with CaseStore.open(path, read_only=True) as store:
        scans = [
            {
                "id": scan.id,
                "kind": scan.kind,
                "mount": scan.mount,
                "laser": "line" if store.by_line(scan.id) else "spot",
                "started": scan.started,
                "finish_reason": scan.finish_reason or "interrupted",
                "observations": store.verdict_counts(scan.id),
                "counts": scan.counts,
                "calibration": scan.calibration_id,
                "registered_views": len(store.corrections(scan.id)),
            }
            for scan in store.scans()
            if scan.kind != KIND
        ]
        values: dict[str, object] = {"kind": "case", "file": str(path), "order": asdict(store.order()), "scans": scans, "meshes": store.mesh_count()}
        values["comparisons"] = [_comparison(path, kept) for kept in kept_comparisons(store)]
        choice = chosen_processing(store)
        values["processing"] = choice.as_dict() | ({"removed": choice.removed.told()} if choice.removed else {})
        if (marks := case_marks(store)) is not None:
            values["marks"] = marks.as_dict()
        values["mounts"] = [_mount(pose) for _, pose in sorted(store.mount_poses().items())]
        told = describe(store)
        values["interrupted"] = told and {name: getattr(told, name) for name in ("measured", "wanted", "views_done", "views")}
        if store.mesh_id() is not None:
            mesh, provenance = store.mesh()
            values["mesh"] = {"vertices": len(mesh.vertices), "triangles": len(mesh.triangles), "provenance": provenance}
        return values


def _mesh_or_points(path: Path) -> dict[str, object]:
    try:
        return _mesh(path, read_mesh(path))
    except InputFileError as error:
        if error.code != "E-FILE-03":
            raise
        return _points(path)  # a PLY without triangles is a cloud


def _mesh(path: Path, mesh: TriangleMesh) -> dict[str, object]:
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
        **asdict(checks),
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
