"""What is certified of a delivered surface: the same facts for the JSON and the page, told by ``schemas/delivery-1.schema.json``."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from scanner_core import __version__
from scanner_core.delivery.examining import Examination
from scanner_core.delivery.pose import LaidSurface
from scanner_core.delivery.profile import Profile
from scanner_core.geometry.mesh import TriangleMesh

SCHEMA = 1
"""Of the JSON; another number when a key changes its meaning or goes."""
KIND = "impronta delivery certificate"
ANYWAY = "Delivered anyway: a person decided to deliver this surface although it is not ready."


@dataclass(frozen=True, slots=True)
class DeliveredFile:
    """A file as it was written."""

    name: str
    role: str
    size_bytes: int
    sha256: str

    @classmethod
    def of(cls, written: Path, name: str, role: str) -> DeliveredFile:
        """Of the bytes at `written`, which will be called `name`; `role` is mesh, points or certificate."""
        with written.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
        return cls(name, role, written.stat().st_size, digest)

    def as_dict(self) -> dict[str, object]:
        return {"name": self.name, "role": self.role, "bytes": self.size_bytes, "sha256": self.sha256}


@dataclass(frozen=True, slots=True, eq=False)
class Certificate:
    """A delivery.

    Attributes
    ----------
    examination : what the checks found
    profile : how it was delivered
    mesh : as it lies in the file, mm
    laid : the pose, and whether it could be found
    made : ISO 8601
    anyway : a person delivered it although it is not ready
    files : mesh first; the certificate's page among them, its JSON not
    """

    examination: Examination
    profile: Profile
    mesh: TriangleMesh
    laid: LaidSurface
    made: str
    anyway: bool
    files: tuple[DeliveredFile, ...]

    @property
    def mesh_file(self) -> DeliveredFile:
        return self.files[0]

    def as_dict(self) -> dict[str, object]:
        """For JSON; the patient's code stays in the case."""
        facts, profile = self.examination.facts, self.profile
        low, high = self.mesh.bounds()
        return {
            "kind": KIND,
            "schema": SCHEMA,
            "made": self.made,
            "program": f"Impronta {__version__}",
            "order": {"number": facts.order.number, "type": facts.order.type, "side": facts.order.side},
            "verdict": self.examination.verdict.value,
            "delivered_anyway": self.anyway,
            "remark": ANYWAY if self.anyway else "",
            "checks": [check.as_dict() for check in self.examination.checks],
            "surface": {
                "triangles": len(self.mesh.triangles),
                "vertices": len(self.mesh.vertices),
                "size_mm": [round(float(length), 3) for length in high - low],
                "unit": profile.unit,
                "base": "open" if profile.open_base else "as measured",
                "pose": profile.pose.value,
                "pose_found": self.laid.found,
                "case_to_file": [[round(float(value), 9) for value in row] for row in self.laid.transform.matrix()],
            },
            "calibration": self._calibration(),
            "rig": {"name": facts.rig, "simulated": facts.virtual},
            "scanned": facts.scanned,
            "profile": profile.name,
            "files": [file.as_dict() for file in self.files],
        }

    def _calibration(self) -> dict[str, object] | None:
        known = self.examination.facts.calibration
        if known is None:
            return None
        return {
            "id": known.id,
            "date": known.date,
            "state_at_scan": None if known.age is None else known.age.state.value,
            "days_left_at_scan": None if known.age is None else round(known.age.days_left, 1),
            "held_out_um": round(known.held_out_um, 2),
            "scale_verified": known.scale_verified,
        }
