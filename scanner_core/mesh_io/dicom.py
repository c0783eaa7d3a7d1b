"""Meshes and reports as DICOM files: Encapsulated STL and Encapsulated PDF (PS3.3, A.85.1 and A.45.1), by the extra ``impronta[dicom]``."""

from __future__ import annotations

import io
import uuid
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from scanner_core import __version__
from scanner_core.errors import UsageError
from scanner_core.files import replaced_when_whole
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.stl import write_stl

if TYPE_CHECKING:
    from pydicom.dataset import Dataset

STL_STORAGE, PDF_STORAGE = "1.2.840.10008.5.1.4.1.1.104.3", "1.2.840.10008.5.1.4.1.1.104.1"
_NAMESPACE = uuid.UUID("5f0f7b5a-8d3e-4c0e-9a37-2f1d6c1b8e44")
_LATERALITY = {"left": "L", "right": "R"}
_LONGEST = 64
"""Characters of a Long String (PS3.5, 6.2)."""


@dataclass(frozen=True, slots=True)
class DicomSubject:
    """Whom and what a file concerns.

    Attributes
    ----------
    code : of the patient or of the order; never a name
    order : its number; files of one order are one study
    side : left, right or empty
    made : time stamp, ISO 8601
    device : which rig measured; empty when that is not known
    """

    code: str
    order: str
    side: str
    made: str
    device: str = ""

    @classmethod
    def of(cls, patient_code: str, order: str, side: str, made: str, device: str = "") -> DicomSubject:
        """By the patient's code where there is one, else by the order's number: the same for every file of an order."""
        return cls(patient_code or order, order, side, made, device)


def check_pydicom() -> None:
    """Say before long work whether DICOM files can be written; UsageError E-CMP-40 when not."""
    try:
        import pydicom  # noqa: F401
    except ImportError as fault:
        raise UsageError("E-CMP-40", details=str(fault)) from fault


def write_encapsulated_stl(path: Path, mesh: TriangleMesh, subject: DicomSubject, title: str, *, force: bool = False) -> None:
    """Write a mesh in millimetres as binary STL within a DICOM file; the same mesh, subject and title give the same bytes.

    Raises
    ------
    UsageError
        E-CMP-40, pydicom is not installed.
    StorageError
        as `replaced_when_whole`.
    """
    check_pydicom()
    from pydicom.dataset import Dataset

    stl = io.BytesIO()
    write_stl(stl, mesh)
    file = _document(subject, title, stl.getvalue(), "model/stl", STL_STORAGE, "M3D")
    file.FrameOfReferenceUID = _uid("frame", subject.order, file.SOPInstanceUID)
    file.PositionReferenceIndicator = None
    file.ManufacturerModelName = "Impronta"
    file.DeviceSerialNumber = _long_string(subject.device) or "unknown"
    unit = Dataset()
    unit.CodeValue, unit.CodingSchemeDesignator, unit.CodeMeaning = "mm", "UCUM", "millimeter"
    file.MeasurementUnitsCodeSequence = [unit]
    file.BurnedInAnnotation = "NO"
    file.ModelModification = "NO"
    file.ModelMirroring = "NO"
    _write(path, file, force)


def write_encapsulated_pdf(path: Path, pdf: bytes, subject: DicomSubject, title: str, *, force: bool = False) -> None:
    """Write a PDF within a DICOM file; errors as `write_encapsulated_stl`."""
    check_pydicom()
    file = _document(subject, title, pdf, "application/pdf", PDF_STORAGE, "DOC")
    file.ConversionType = "WSD"  # from a workstation
    file.BurnedInAnnotation = "YES"  # the order's number and the dates stand on the page
    _write(path, file, force)


def _document(subject: DicomSubject, title: str, content: bytes, mime: str, storage: str, modality: str) -> Dataset:
    """What both have in common: patient, study, series, equipment, document."""
    from pydicom.dataset import Dataset

    file = Dataset()
    day, time = subject.made[:10].replace("-", ""), subject.made[11:19].replace(":", "")
    file.SpecificCharacterSet = "ISO_IR 192"
    file.SOPClassUID = storage
    file.SOPInstanceUID = _uid("instance", storage, subject.code, subject.order, subject.side, subject.made, title, content)
    file.PatientName = None
    file.PatientID = _long_string(subject.code)
    file.PatientBirthDate = file.PatientSex = None
    file.StudyInstanceUID = _uid("study", subject.code, subject.order)
    file.StudyID = _long_string(subject.order)[:16]
    file.StudyDate = file.StudyTime = file.AccessionNumber = file.ReferringPhysicianName = None
    file.Modality = modality
    file.SeriesInstanceUID = _uid("series", storage, subject.code, subject.order, subject.made)
    file.SeriesNumber = file.InstanceNumber = 1
    file.Manufacturer = "Impronta"
    file.SoftwareVersions = __version__
    file.InstanceCreationDate = file.ContentDate = day
    file.InstanceCreationTime = file.ContentTime = time
    file.AcquisitionDateTime = None
    if subject.side in _LATERALITY:
        file.ImageLaterality = _LATERALITY[subject.side]
    file.DocumentTitle = title
    file.ConceptNameCodeSequence = []
    file.MIMETypeOfEncapsulatedDocument = mime
    file.EncapsulatedDocumentLength = len(content)
    file.EncapsulatedDocument = content + b"\0" * (len(content) % 2)
    return file


def _write(path: Path, file: Dataset, force: bool) -> None:
    from pydicom.dataset import FileMetaDataset
    from pydicom.filewriter import dcmwrite
    from pydicom.uid import UID, ExplicitVRLittleEndian

    meta = FileMetaDataset()
    meta.TransferSyntaxUID = ExplicitVRLittleEndian
    meta.ImplementationClassUID = UID(_uid("implementation"))
    meta.ImplementationVersionName = f"IMPRONTA_{__version__}"[:16]
    file.file_meta = meta
    with replaced_when_whole(path, force) as partial:
        dcmwrite(partial, file, enforce_file_format=True)


def _uid(*parts: str | bytes) -> str:
    """A UID of the parts, always the same for the same ones: a UUID of version 5 under the root 2.25 (PS3.5, B.2)."""
    name = b"".join(len(part).to_bytes(8, "big") + part for part in (p if isinstance(p, bytes) else p.encode() for p in parts))
    return f"2.25.{uuid.uuid5(_NAMESPACE, name.hex()).int}"


def _long_string(words: str) -> str:
    """Text that a Long String may hold: no backslash, no control characters, not too long."""
    return "".join("_" if letter == "\\" or not letter.isprintable() else letter for letter in words).strip()[:_LONGEST]
