"""The visits to the marks that a case holds, and what they say: all of it is computed again from the centroids.

A visit is a scan record of the kind ``marks``: its plan holds the rows over the balls at one position of the table, and beside
them which scan it belongs to, what it was for, and which balls were to be seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from scanner_core.acquisition.mark_centres import MarkCentre, mark_centres
from scanner_core.acquisition.mark_watch import MarkWatch
from scanner_core.case.points import case_rig
from scanner_core.case.records import ScanRecord
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig
from scanner_core.optics.calibration import StereoCalibration

KIND = "marks"
"""Of the scan records."""
During = Literal["search", "scan", "check"]
"""What a visit is for: a ``search`` only finds the marks, a ``check`` compares them before an interrupted scan goes on."""


@dataclass(frozen=True, slots=True)
class VisitPlan:
    """What stands in a visit's plan beside its rows.

    Attributes
    ----------
    scan_id : of the scan for which it was made
    during : what it was for
    view : of that scan
    wanted : numbers of the balls that were to be seen, from 0
    """

    scan_id: int
    during: During
    view: int
    wanted: tuple[int, ...]

    def as_dict(self) -> dict[str, object]:
        return {"scan": self.scan_id, "during": self.during, "view": self.view, "wanted": list(self.wanted)}

    @staticmethod
    def of(record: ScanRecord) -> VisitPlan | None:
        """Of a scan record; None when it is no visit."""
        told: Any = record.plan.get(KIND)
        if record.kind != KIND or not isinstance(told, dict):
            return None
        try:
            return VisitPlan(int(told["scan"]), told["during"], int(told["view"]), tuple(int(number) for number in told["wanted"]))
        except (KeyError, TypeError, ValueError):
            return None


@dataclass(frozen=True, slots=True)
class MarksReport:
    """What the marks say of a scan: its check value.

    Attributes
    ----------
    visits : that showed a mark
    marks_um : rms difference of the marks' distances against the reference, None when it cannot be told
    reference : ``calibrated`` distances, or those of the ``first visits``
    repeatability_um : rms of a coordinate of a mark's centre over the visits
    scale_error_ppm, scale_uncertainty_ppm : of the distances against the calibrated ones, None without
    """

    visits: int
    marks_um: float | None
    reference: str
    repeatability_um: float | None
    scale_error_ppm: float | None = None
    scale_uncertainty_ppm: float | None = None

    @staticmethod
    def of(watch: MarkWatch, calibrated: bool) -> MarksReport:
        rms, repeat, scale = watch.distance_rms_um(), watch.repeatability_um(), watch.scale_error()
        told = (None, None) if scale is None else (round(1e6 * scale[0], 1), round(1e6 * scale[1], 1))
        return MarksReport(
            watch.visits,
            None if rms is None else round(rms, 2),
            "calibrated" if calibrated else "first visits",
            None if repeat is None else round(repeat, 2),
            *told,
        )

    def as_dict(self) -> dict[str, object]:
        """For JSON and a mesh's provenance."""
        told: dict[str, object] = {"visits": self.visits, "marks_um": self.marks_um, "reference": self.reference}
        return told | {
            "repeatability_um": self.repeatability_um,
            "scale_error_ppm": self.scale_error_ppm,
            "scale_uncertainty_ppm": self.scale_uncertainty_ppm,
        }

    def brief(self) -> str:
        """As the headers of files tell it."""
        return f"marks_um={'unknown' if self.marks_um is None else f'{self.marks_um:.1f}'} visits={self.visits}"

    def words(self) -> str:
        """For a person."""
        rms = "unknown" if self.marks_um is None else f"{self.marks_um:.1f}"
        return f"marks_um {rms} ({self.visits} visits, against the {self.reference} distances)"


def visit_centres(store: CaseStore, record: ScanRecord, rig: RigConfig, calibration: StereoCalibration) -> list[MarkCentre]:
    """The balls that a visit shows."""
    return mark_centres(store.observations(record.id), rig, calibration)


def recalled(store: CaseStore, scan_id: int, rig: RigConfig, calibration: StereoCalibration) -> MarkWatch | None:
    """A watch that has seen the visits of a scan; None when the rig of the scan has no marks, or none was made."""
    if rig.marks is None:
        return None
    watch: MarkWatch | None = None
    for record in store.scans():
        visit = VisitPlan.of(record)
        if visit is None or visit.scan_id != scan_id or visit.during != "scan":
            continue
        table = store.observations(record.id)
        watch = watch or MarkWatch(rig.marks, calibration)
        if len(table):
            watch.add_visit(visit.view, float(table.table_deg[0]), visit.wanted, mark_centres(table, rig, calibration))
    return watch


def case_marks(store: CaseStore, scans: Sequence[int] = ()) -> MarksReport | None:
    """The check value of some scans of a case, of several the worst; by default of the newest.  None when they had no marks."""
    known = [scan for scan in store.scans() if scan.kind == "scan"]
    asked = [scan for scan in known if scan.id in scans] or known[-1:]
    reports = [report for scan in asked if (report := marks_report(store, scan)) is not None]
    return max(reports, key=lambda report: report.marks_um or 0.0, default=None)


def marks_report(store: CaseStore, scan: ScanRecord, calibration: StereoCalibration | None = None) -> MarksReport | None:
    """The check value of a scan of a case, with its own calibration or another; None when it was scanned without marks."""
    if not any(visit.scan_id == scan.id for record in store.scans() if (visit := VisitPlan.of(record)) is not None):
        return None
    rig, used = case_rig(store, scan)
    watch = recalled(store, scan.id, rig, calibration or used)
    if watch is None or rig.marks is None:
        return None
    return MarksReport.of(watch, rig.marks.distances_mm is not None)
