"""What a case tells of its surface and of how it was measured, read once for all checks and the certificate."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime

from scanner_core.acquisition.mark_visits import MarksReport, case_marks
from scanner_core.case.closure import closure_um
from scanner_core.case.glance import DELIVERY
from scanner_core.case.points import case_calibration, case_rig
from scanner_core.case.processing import chosen_processing
from scanner_core.case.records import MountPose, Order, ScanRecord
from scanner_core.case.store import CaseStore
from scanner_core.coverage.accepted import accepted_places
from scanner_core.errors import ImprontaError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.optics.calibration_age import CalibrationAge, calibration_age


@dataclass(frozen=True, slots=True)
class CalibrationFacts:
    """The calibration that the points were computed with, as it stood at the scan.

    Attributes
    ----------
    id, date : of the calibration
    age : at the scan, None where a date cannot be read
    held_out_um : error on corners that took no part in it
    scale_verified : a certified length was shown to it
    """

    id: str
    date: str
    age: CalibrationAge | None
    held_out_um: float
    scale_verified: bool


@dataclass(frozen=True, slots=True, eq=False)
class CaseFacts:
    """A case that is to be delivered.

    Attributes
    ----------
    order : what it is for
    mesh : the surface that counts in the case
    mesh_id : of it, in the case
    report : of its reconstruction, empty where there is none
    scans : that it was made of, oldest first
    rig : name of the rig of the newest of them, or empty
    virtual : that rig was simulated
    calibration : None where the case does not tell
    mounts : poses of the mounts, those that were not accepted included
    mount_count : mounts that the surface is made of
    closure_um : by how much the first view lay beside itself at the end of the turn, of several scans the worst; None where it was not
        measured again
    views_um : to which the views of the newest scan agree, robust standard deviation; None where that is not known
    marks : what the marks on the rim say, None without
    points : that the surface was made of, 0 where that is not known
    removed : of them, how many a person took out
    current : the surface was made of the points as they are now; None where that is not known
    accepted : places that a person accepted as they are
    delivered : the newest delivery of it, as the case remembers it; empty where there was none
    """

    order: Order
    mesh: TriangleMesh
    mesh_id: int
    report: dict[str, object]
    scans: tuple[ScanRecord, ...]
    rig: str
    virtual: bool
    calibration: CalibrationFacts | None
    mounts: tuple[MountPose, ...]
    mount_count: int
    closure_um: float | None
    views_um: float | None
    marks: MarksReport | None
    points: int
    removed: int
    current: bool | None
    accepted: int
    delivered: dict[str, object]

    @property
    def scanned(self) -> str:
        """When the newest scan began, ISO 8601; empty where that is not known."""
        return self.scans[-1].started if self.scans else ""


def read_facts(store: CaseStore) -> CaseFacts:
    """All of it; E-CASE-05 when the case holds no mesh, E-CASE-01 when it is damaged."""
    mesh, provenance = store.mesh()
    used = provenance.get("scans")
    chosen = {number for number in used if isinstance(number, int)} if isinstance(used, list) else set()
    known = [scan for scan in store.scans() if scan.kind == "scan"]
    scans = tuple(scan for scan in known if not chosen or scan.id in chosen)
    processing, report = (_table(provenance.get(name)) for name in ("processing", "report"))
    removed = _table(processing.get("removed")).get("count", 0)
    points = report.get("points", 0)
    rig, virtual, calibration = _measured_with(store, scans, provenance)
    registrations = [record.report for record in store.registrations(scans[-1].id)] if scans else []
    closures = [told for scan in scans if (told := closure_um(store, scan.id)) is not None]
    return CaseFacts(
        order=store.order(),
        mesh=mesh,
        mesh_id=store.mesh_id() or 0,
        report=report,
        scans=scans,
        rig=rig,
        virtual=virtual,
        calibration=calibration,
        mounts=tuple(store.mount_poses().values()),
        mount_count=len({scan.mount for scan in scans}),
        closure_um=max(closures, default=None),
        views_um=_newest(registrations, "residual_after_um"),
        marks=case_marks(store, [scan.id for scan in scans]) if scans else None,
        points=points if isinstance(points, int) else 0,
        removed=removed if isinstance(removed, int) else 0,
        current=_is_current(store, provenance),
        accepted=len(accepted_places(store)),
        delivered=_table(store.value(DELIVERY)),
    )


def _measured_with(store: CaseStore, scans: tuple[ScanRecord, ...], provenance: dict[str, object]) -> tuple[str, bool, CalibrationFacts | None]:
    """Name of the rig, whether it was simulated, and the calibration at the newest scan."""
    if not scans:
        return "", False, None
    try:
        rig, calibration = case_rig(store, scans[-1])
        named = provenance.get("calibration")
        if isinstance(named, str) and named != scans[-1].calibration_id:
            calibration = case_calibration(store, named)
    except ImprontaError:
        return "", False, None  # a rig that is damaged is a check with a remark, no reason to tell nothing
    try:
        age = calibration_age(calibration, datetime.fromisoformat(scans[-1].started).astimezone())
    except ValueError:
        age = None
    verified = calibration.scale is not None and calibration.scale.verified
    facts = CalibrationFacts(calibration.identity(), calibration.date, age, calibration.held_out_rms_um, verified)
    return rig.name, bool(rig.virtual), facts


def _is_current(store: CaseStore, provenance: dict[str, object]) -> bool | None:
    """Whether the choice of points is still the one that the mesh was made with; None where the mesh does not tell."""
    used = provenance.get("scans")
    if not isinstance(used, list):
        return None
    try:
        processing = chosen_processing(store)
        chosen = processing.as_dict()
        discarded = store.value("discarded_scans", [])
        scans = chosen.pop("scans") or store.counting_scans(discarded if isinstance(discarded, list) else [])
    except ImprontaError:
        return None
    before = _table(provenance.get("processing"))
    made = {name: before.get(name, blank) for name, blank in (("calibration", None), ("gates", {}), ("without_views", []))}
    now = {name: chosen.get(name) for name in made}
    removed = processing.removed.told() if processing.removed else {}
    return scans == used and made == now and removed == _table(before.get("removed"))


def _newest(reports: list[dict[str, object]], name: str) -> float | None:
    """A number of the newest report that has it."""
    told = [report[name] for report in reports if isinstance(report.get(name), int | float) and not isinstance(report[name], bool)]
    return float(str(told[-1])) if told else None


def _table(value: object) -> dict[str, object]:
    return value if isinstance(value, dict) else {}
