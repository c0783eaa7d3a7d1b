"""DICOM files: every element that the standard asks for, the content unharmed, no name; and DCMTK's word where it is installed."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from pydicom import dcmread
from pydicom.dataset import Dataset

from scanner_core.errors import UsageError
from scanner_core.mesh_io.dicom import PDF_STORAGE, STL_STORAGE, DicomSubject, write_encapsulated_pdf, write_encapsulated_stl
from scanner_core.mesh_io.stl import parse_stl
from tests.core.comparison.made import plate

SUBJECT = DicomSubject("P-0417", "2026-0417", "left", "2026-11-27T06:00:00+01:00", "bench")
PDF = b"%PDF-1.4 nothing but an odd number of bytes"

# PS3.3: modules Patient, General Study, Encapsulated Document Series, General Equipment, Encapsulated Document, SOP Common
_FILLED = ["SOPClassUID", "SOPInstanceUID", "StudyInstanceUID", "Modality", "SeriesInstanceUID", "SeriesNumber", "InstanceNumber"]
_FILLED += ["BurnedInAnnotation", "MIMETypeOfEncapsulatedDocument", "EncapsulatedDocument"]
_PRESENT = ["PatientName", "PatientID", "PatientBirthDate", "PatientSex", "StudyDate", "StudyTime", "ReferringPhysicianName", "StudyID"]
_PRESENT += ["AccessionNumber", "Manufacturer", "ContentDate", "ContentTime", "AcquisitionDateTime", "DocumentTitle", "ConceptNameCodeSequence"]
_OF_STL = ["FrameOfReferenceUID", "ManufacturerModelName", "DeviceSerialNumber", "SoftwareVersions", "MeasurementUnitsCodeSequence"]
_OF_STL += ["ModelModification", "ModelMirroring"]


def _both(folder: Path, subject: DicomSubject = SUBJECT) -> tuple[Dataset, Dataset]:
    write_encapsulated_stl(folder / "a.dcm", plate(), subject, "Surface", force=True)
    write_encapsulated_pdf(folder / "p.dcm", PDF, subject, "Report", force=True)
    return dcmread(folder / "a.dcm"), dcmread(folder / "p.dcm")


def test_every_element_is_there(tmp_path: Path) -> None:
    stl, pdf = _both(tmp_path)
    for file, filled in ((stl, _FILLED + _OF_STL), (pdf, [*_FILLED, "ConversionType"])):
        assert [name for name in filled if not file.get(name)] == []
        assert [name for name in _PRESENT if name not in file] == []
        assert file.PatientName == ""
        assert file.PatientID == "P-0417"
        assert file.ImageLaterality == "L"
        for uid in (file.SOPInstanceUID, file.StudyInstanceUID, file.SeriesInstanceUID):
            assert uid.is_valid
            assert uid.startswith("2.25.")
    assert (stl.SOPClassUID, pdf.SOPClassUID) == (STL_STORAGE, PDF_STORAGE)
    assert (stl.Modality, pdf.Modality) == ("M3D", "DOC")
    assert stl.StudyInstanceUID == pdf.StudyInstanceUID
    assert len({stl.SeriesInstanceUID, pdf.SeriesInstanceUID, stl.SOPInstanceUID, pdf.SOPInstanceUID, stl.StudyInstanceUID}) == 5
    unit = stl.MeasurementUnitsCodeSequence[0]
    assert (unit.CodeValue, unit.CodingSchemeDesignator) == ("mm", "UCUM")


def test_the_content_is_unharmed_and_of_even_length(tmp_path: Path) -> None:
    stl, pdf = _both(tmp_path)
    for file in (stl, pdf):
        assert len(file.EncapsulatedDocument) % 2 == 0
    mesh = parse_stl(stl.EncapsulatedDocument[: stl.EncapsulatedDocumentLength])
    assert np.allclose(mesh.vertices[mesh.triangles], plate().vertices[plate().triangles], atol=1e-5)
    assert pdf.EncapsulatedDocument[: pdf.EncapsulatedDocumentLength] == PDF


def test_the_same_content_gives_the_same_bytes_and_another_another_instance(tmp_path: Path) -> None:
    _both(tmp_path)
    before = [(tmp_path / name).read_bytes() for name in ("a.dcm", "p.dcm")]
    stl, _ = _both(tmp_path)
    assert [(tmp_path / name).read_bytes() for name in ("a.dcm", "p.dcm")] == before
    write_encapsulated_stl(tmp_path / "other.dcm", plate(9, 9), SUBJECT, "Surface")
    other = dcmread(tmp_path / "other.dcm")
    assert other.SOPInstanceUID != stl.SOPInstanceUID
    assert other.StudyInstanceUID == stl.StudyInstanceUID


@pytest.mark.parametrize("code", ["a\\b\nc", "歯" * 90, "", " "])
def test_a_code_of_any_kind_can_be_written(code: str, tmp_path: Path) -> None:
    stl, _ = _both(tmp_path, DicomSubject(code, code, "", ""))
    assert "ImageLaterality" not in stl
    assert "\\" not in stl.PatientID
    assert len(stl.PatientID) <= 64
    assert len(stl.StudyID) <= 16


def test_without_the_package_a_sentence_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pydicom", None)
    with pytest.raises(UsageError, match="E-CMP-40"):
        write_encapsulated_stl(tmp_path / "a.dcm", plate(), SUBJECT, "Surface")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(shutil.which("dcm2pdf") is None, reason="DCMTK is not installed")
def test_dcmtk_reads_them(tmp_path: Path) -> None:
    stl, _ = _both(tmp_path)
    for name in ("a.dcm", "p.dcm"):
        said = subprocess.run(["dcmftest", name], cwd=tmp_path, capture_output=True, text=True, check=True)
        assert said.stdout.startswith("yes")
        said = subprocess.run(["dcmdump", "-q", name], cwd=tmp_path, capture_output=True, text=True, check=True)
        assert said.stderr == ""
    subprocess.run(["dcm2pdf", "p.dcm", "p.pdf"], cwd=tmp_path, capture_output=True, check=True)
    assert (tmp_path / "p.pdf").read_bytes() == PDF
    said = subprocess.run(["dcmdump", "-q", "+L", "+P", "0042,0011", "a.dcm"], cwd=tmp_path, capture_output=True, text=True, check=True)
    told = bytes.fromhex(said.stdout.split(" OB ")[1].split()[0].replace("\\", ""))
    assert told == stl.EncapsulatedDocument
