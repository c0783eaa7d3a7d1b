"""The report and the after surface for a clinic's archive."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.report import content
from scanner_core.files import check_free, replaced_when_whole
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.dicom import DicomSubject, check_pydicom, write_encapsulated_pdf, write_encapsulated_stl

NAMES = ("report.dcm", "after.dcm")


def write_dicom(comparison: Comparison, page: Path, folder: Path, *, force: bool = False, made: str) -> list[Path]:
    """Write report.dcm, the finished PDF `page`, and after.dcm, the after surface in the frame of BEFORE; both or neither.

    Parameters
    ----------
    folder : exists
    made : the time that the page tells, from `wall_clock.stamp`

    Raises
    ------
    UsageError
        E-CMP-40, pydicom is not installed.
    StorageError
        as `write_report`.
    """
    check_pydicom()
    paths = [folder / name for name in NAMES]
    for path in paths:
        check_free(path, force)
    subject = _subject(comparison, made)
    after = comparison.after.mesh
    with ExitStack() as whole:
        report, surface = (whole.enter_context(replaced_when_whole(path, force)) for path in paths)
        write_encapsulated_pdf(report, page.read_bytes(), subject, content.TITLE, force=True)
        placed = TriangleMesh(comparison.alignment.transform.apply(after.vertices), after.triangles)
        write_encapsulated_stl(surface, placed, subject, "AFTER in the frame of BEFORE", force=True)
    return paths


def _subject(comparison: Comparison, made: str) -> DicomSubject:
    """The order of the after surface, or the beginning of its SHA-256 where it has none."""
    origin = comparison.after.origin
    order = str(origin.get("order") or comparison.after.sha256[:16])
    return DicomSubject.of(str(origin.get("patient_code") or ""), order, str(origin.get("side") or ""), made, str(origin.get("rig") or ""))
