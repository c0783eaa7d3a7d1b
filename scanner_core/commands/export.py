"""``impronta export``: mesh or points out of a case."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.acquisition.mark_visits import case_marks
from scanner_core.case.processing import case_cloud
from scanner_core.case.store import CaseStore
from scanner_core.commands.console import Console
from scanner_core.files import check_free
from scanner_core.mesh_io import check_suffix, write_mesh, write_points
from scanner_core.mesh_io.dicom import DicomSubject, check_pydicom, write_encapsulated_stl

_POINT_SUFFIXES = (".xyz",)
_DICOM_SUFFIX = ".dcm"


def run(given: argparse.Namespace, console: Console) -> int:
    out = Path(given.out).resolve()
    points_wanted, dicom_wanted = out.suffix.lower() in _POINT_SUFFIXES, out.suffix.lower() == _DICOM_SUFFIX
    if dicom_wanted:
        check_pydicom()
    elif not points_wanted:
        check_suffix(out)
    check_free(out, given.force)
    with CaseStore.open(Path(given.case), read_only=True) as store:
        if points_wanted:
            cloud = case_cloud(store)
            write_points(out, cloud, force=given.force)
            console.result({"file": str(out), "points": len(cloud)}, [f"{len(cloud)} points written to {out}."])
        else:
            mesh, provenance = store.mesh()
            scans = provenance.get("scans")
            marks = case_marks(store, scans if isinstance(scans, list) else ())
            if dicom_wanted:
                write_encapsulated_stl(out, mesh, _subject(store), "Surface", force=given.force)
            else:
                write_mesh(out, mesh, force=given.force, remark="" if marks is None else marks.brief())
            told: dict[str, object] = {} if marks is None else {"marks": marks.as_dict()}
            console.result({"file": str(out), "triangles": len(mesh.triangles)} | told, [f"{len(mesh.triangles)} triangles written to {out}."])
    return 0


def _subject(store: CaseStore) -> DicomSubject:
    """Whom the case's mesh concerns."""
    order = store.order()
    scans = [scan for scan in store.scans() if scan.kind == "scan"]
    made = scans[-1].started if scans else ""
    return DicomSubject.of(order.patient_code, order.number, order.side, made)
