"""``impronta export`` only looks at the case."""

from __future__ import annotations

from pathlib import Path

from pydicom import dcmread

from scanner_core.__main__ import main
from tests.core.case.old_case import write_old_case


def test_exporting_changes_nothing_beside_the_output(tmp_path: Path) -> None:
    folder = tmp_path / "cases"
    folder.mkdir()
    write_old_case(folder / "old.impronta")
    before = (folder / "old.impronta").read_bytes()
    assert main(["export", str(folder / "old.impronta"), "--out", str(tmp_path / "a.stl")]) == 0
    assert (tmp_path / "a.stl").stat().st_size > 84
    assert [(file.name, file.read_bytes()) for file in folder.iterdir()] == [("old.impronta", before)]


def test_a_mesh_goes_to_a_clinics_archive(tmp_path: Path) -> None:
    write_old_case(tmp_path / "old.impronta")
    assert main(["export", str(tmp_path / "old.impronta"), "--out", str(tmp_path / "a.dcm")]) == 0
    assert main(["export", str(tmp_path / "old.impronta"), "--out", str(tmp_path / "a.stl")]) == 0
    file = dcmread(tmp_path / "a.dcm")
    assert file.EncapsulatedDocument == (tmp_path / "a.stl").read_bytes()
    assert file.PatientName == ""
