"""What a case tells of its order, scans, mounts, edits, registrations and comparisons."""

from __future__ import annotations

from dataclasses import dataclass

from scanner_core.geometry.rigid import RigidTransform


@dataclass(frozen=True, slots=True)
class Order:
    """What the scan is for; `patient_code` is a code, never a name; `side` is left, right, upper, lower or empty."""

    number: str = ""
    patient_code: str = ""
    side: str = ""
    type: str = ""
    remarks: str = ""


@dataclass(frozen=True, slots=True)
class ScanRecord:
    """A scan of a case as it was recorded; `finish_reason` is None when it was interrupted; `mount` is how the object stood."""

    id: int
    kind: str
    calibration_id: str
    plan: dict[str, object]
    started: str
    ended: str | None
    finish_reason: str | None
    counts: dict[str, object] | None
    mount: int = 0


@dataclass(frozen=True, slots=True)
class ScanEnd:
    """How a scan ended; `finish_reason` and `counts` are None when it was interrupted."""

    id: int
    kind: str
    finish_reason: str | None
    counts: dict[str, object] | None


@dataclass(frozen=True, slots=True, eq=False)
class MountPose:
    """Where the object frame of a mount lies, as it was found once.

    Attributes
    ----------
    transform : object frame of the mount to that of the first mount, mm; None when it was not accepted
    report : how it was found: overlap, residual, margin, and ``first_mount``, the mount that it refers to
    """

    mount: int
    created: str
    transform: RigidTransform | None
    report: dict[str, object]

    def in_frame_of(self, first: int) -> RigidTransform | None:
        """The transform to the object frame of that mount; None when it was not accepted, or refers to another."""
        return self.transform if self.report.get("first_mount", 0) == first else None


@dataclass(frozen=True, slots=True)
class CaseEdit:
    """A change that a person made, as it was undone or redone.

    Attributes
    ----------
    key : what was changed
    words : for the menu: "Undo: `words`"
    value : of the key from now on; None when it has none
    """

    key: str
    words: str
    value: object


@dataclass(frozen=True, slots=True)
class RegistrationRecord:
    """How the views of a scan were brought together, once."""

    scan_id: int
    created: str
    calibration_id: str
    report: dict[str, object]


@dataclass(frozen=True, slots=True)
class ComparisonRecord:
    """A comparison of two surfaces; `before` and `after` tell what they were, with their hashes."""

    id: int
    created: str
    before: dict[str, object]
    after: dict[str, object]
    parameters: dict[str, object]
    result: dict[str, object]


@dataclass(frozen=True, slots=True)
class AuditLine:
    """One line of the audit trail."""

    time: str
    event: str
    detail: str
