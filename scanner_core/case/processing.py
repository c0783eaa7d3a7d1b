"""Points of a case: as scanned, of all mounts together; or anew, with another calibration, other gates, without some views, of other scans.

Nothing measured is changed.  A :class:`Processing` is a person's choice, kept in the case under the key ``processing``,
so it can be undone; the same choice gives the same points to the last bit, in the order of the trigger ids.

Points that a person took out are left away at the end: views are registered and the noise is estimated with all of them, so that
no other point moves when one is taken out.

What can be taken in again: everything that both cameras saw as one spot, whatever its verdict, so also what the epipolar
constraint, the volume or the table had rejected.  What the detector rejects within one image (no spot, too dim, saturated,
ambiguous, ...) is not kept as a centroid, so the gates of the spot can be made narrower but not wider.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.engine import TABLE_MM
from scanner_core.acquisition.status import ScanCounts
from scanner_core.case.edits import DISCARDED, PROCESSING
from scanner_core.case.line_gates import gated_places
from scanner_core.case.line_points import ScanTable
from scanner_core.case.observation import MEASURED, ObservationTable, PairTable
from scanner_core.case.points import case_calibration, case_rig
from scanner_core.case.records import ScanRecord
from scanner_core.case.removed_points import REMOVED, RemovedPoints, parted
from scanner_core.case.scan_parts import ScanPart, merged, placed_motions, refine_parts
from scanner_core.case.store import CaseStore
from scanner_core.case.stripes import StripeTable
from scanner_core.case.superseded import superseded_views
from scanner_core.devices.rig import RigConfig, dump_rig
from scanner_core.errors import CaseError, CaseFormatError, UsageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.registration import register_views
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.noise_model import CentroidNoise, NoiseModel, along_axes
from scanner_core.optics.triangulation import EpipolarGate, Triangulator

_GEOMETRIC = ("epipolar_sigmas", "volume_radius_mm", "volume_height_mm", "table_mm")
"""Gates that need the point."""
_BY_GEOMETRY = (MEASURED, "epipolar", "outside_volume", "table", "mark")
"""Verdicts that a change of those gates, or of the calibration, decides anew."""


@dataclass(frozen=True, slots=True)
class Gates:
    """Limits that a point must keep; None as it was when the object was scanned.

    Attributes
    ----------
    least_sigma_px, most_sigma_px : size of both spots, the standard deviation of the light, rms over x and y
    least_peak_dn : brightest pixel of both spots, 0 to 255
    most_uncertainty_px : standard uncertainty of both centroids by the noise of their pixels
    epipolar_sigmas : epipolar residual in its standard uncertainties (scanned with 3)
    volume_radius_mm, volume_height_mm : the cylinder on the table
    table_mm : points lower than this are the table's (scanned with 0.15)
    """

    least_sigma_px: float | None = None
    most_sigma_px: float | None = None
    least_peak_dn: float | None = None
    most_uncertainty_px: float | None = None
    epipolar_sigmas: float | None = None
    volume_radius_mm: float | None = None
    volume_height_mm: float | None = None
    table_mm: float | None = None

    def __post_init__(self) -> None:
        for name, value in self.given().items():
            least = -1000.0 if name == "table_mm" else 0.0
            if isinstance(value, bool) or not isinstance(value, int | float) or not (isfinite(value) and least <= value <= 1e6):
                raise UsageError("E-USE-01", what=f"The gate '{name}' is {value!r}", do=f"give a number from {least:g} to 1,000,000")

    def given(self) -> dict[str, float]:
        """Those that are not as scanned."""
        return {gate.name: getattr(self, gate.name) for gate in fields(self) if getattr(self, gate.name) is not None}


GATES = tuple(gate.name for gate in fields(Gates))


@dataclass(frozen=True, slots=True)
class Processing:
    """How the points of a case are computed; the default is as scanned.

    Attributes
    ----------
    calibration : identity of a calibration that the case holds; None for the one of each scan
    gates : what a point must keep
    without_views : numbers of views that are left out
    scans : ids of the scans that are merged; empty for the newest of every mount that has points, was not discarded, and
        whose mount's pose was accepted
    removed : points that a person took out
    """

    calibration: str | None = None
    gates: Gates = field(default_factory=Gates)
    without_views: tuple[int, ...] = ()
    scans: tuple[int, ...] = ()
    removed: RemovedPoints = field(default_factory=RemovedPoints)

    @property
    def as_scanned(self) -> bool:
        return self == Processing()

    def as_dict(self) -> dict[str, object]:
        """For the case and JSON; without points that were taken out it is what older programs wrote."""
        told: dict[str, object] = {
            "calibration": self.calibration,
            "gates": self.gates.given(),
            "without_views": list(self.without_views),
            "scans": list(self.scans),
        }
        return told | ({"removed": self.removed.as_dict()} if self.removed else {})

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Processing:
        """The reverse of :meth:`as_dict`; ValueError, TypeError or LookupError for anything else."""
        calibration, gates = values.get("calibration"), values.get("gates", {})
        if not (calibration is None or isinstance(calibration, str)) or not isinstance(gates, dict):
            raise TypeError("no choice of a processing")
        views, scans = (tuple(values.get(key, ())) for key in ("without_views", "scans"))
        if not all(isinstance(number, int) and not isinstance(number, bool) for number in (*views, *scans)):
            raise TypeError("views and scans are whole numbers")
        removed = RemovedPoints.from_dict(values["removed"]) if "removed" in values else RemovedPoints()
        return cls(calibration, Gates(**gates), tuple(sorted(set(views))), tuple(sorted(set(scans))), removed)


@dataclass(frozen=True, slots=True, eq=False)
class ProcessedCase:
    """What a processing gave.

    Attributes
    ----------
    processing : with the scans that were taken
    cloud : registered, mm, in the order of the trigger ids; views of later scans are numbered on.  The points of one mount are
        in its object frame, those of several in that of the first mount of the case
    taken_out : the points that a person took out, as they would be in the cloud; None for none
    mounts : that the points are of, each with where its object frame lies in the frame of the cloud
    counts : over the plans of the scans, with the verdicts as they are now
    calibrations : identities that the points were computed with
    noise : of each scan
    registered : the views were registered anew; otherwise the corrections of the scan hold
    registration : the report of that registration, None when it was not done
    """

    processing: Processing
    cloud: PointCloud
    counts: ScanCounts
    calibrations: tuple[str, ...]
    noise: tuple[NoiseModel, ...]
    registered: bool
    registration: dict[str, object] | None
    mounts: Mapping[int, RigidTransform] = field(default_factory=lambda: {0: RigidTransform.identity()})
    taken_out: PointCloud | None = None

    def as_dict(self) -> dict[str, object]:
        """For JSON and a mesh's provenance."""
        counts, removed = self.counts, self.processing.removed
        return (
            self.processing.as_dict()
            | ({"removed": removed.told()} if removed else {})
            | {
                "calibrations": list(self.calibrations),
                "mounts": list(self.mounts),
                "registered_anew": self.registered,
                "registration": self.registration,
                "planned": counts.planned,
                "measured": counts.measured,
                "rejected": counts.rejected,
                "skipped": counts.skipped,
                "noise": [asdict(noise) for noise in self.noise],
            }
        )

    def provenance(self) -> dict[str, object]:
        """Scans, calibration and processing, for the provenance of a mesh of these points."""
        told = self.as_dict()
        return {"processing": told, "scans": told["scans"], "calibration": self.calibrations[0]}


def keep_processing(store: CaseStore, processing: Processing, rig: RigConfig | None) -> None:
    """Let the case have a choice, an edit that can be undone; `rig` has the calibration that it names and the case may lack."""
    if rig is not None and processing.calibration is not None:
        store.put_calibration(processing.calibration, dump_rig(rig))
    store.edit(PROCESSING, processing.as_dict(), "Points computed anew")


def chosen_processing(store: CaseStore) -> Processing:
    """The choice that the case holds, as scanned when it holds none; E-CASE-01 when it cannot be one."""
    value = store.value(PROCESSING)
    if value is None:
        return Processing()
    try:
        if not isinstance(value, dict):
            raise TypeError("no choice of a processing")
        return Processing.from_dict(value)
    except (LookupError, TypeError, ValueError) as fault:
        raise CaseFormatError("E-CASE-01", path=store.path, reason="its choice of 'processing' is damaged", details=str(fault)) from fault


def case_cloud(store: CaseStore) -> PointCloud:
    """The registered cloud of a case as its choice says; E-CASE-05 when no scan has a point."""
    return process_case(store, chosen_processing(store)).cloud


def process_case(store: CaseStore, processing: Processing, other: StereoCalibration | None = None) -> ProcessedCase:
    """The points of a case by a choice; the case is only read.

    The views are registered again when anything is not as scanned, otherwise the corrections that the case holds are used.

    Parameters
    ----------
    other : the calibration that the choice names, where the case need not hold it yet

    Raises
    ------
    CaseError
        E-CASE-05 no scan has points, or none is left by the gates; E-CASE-01 damaged.
    UsageError
        E-USE-01 the case holds no such scan, view or calibration.
    """
    scans = _scans(store, processing)
    poses = _poses(store, scans)
    anew = len(scans) > len(poses) or not replace(processing, scans=(), removed=RemovedPoints()).as_scanned
    taken: list[ScanPart] = []
    corrections: dict[int, RigidTransform] = {}
    verdicts: Counter[str] = Counter()
    planned = first_view = 0
    for scan in scans:
        rig, calibration = _rig(store, scan, processing.calibration, other)
        table, counted = _gated(store, scan, rig, calibration, processing)
        planned += sum(counted.values()) if isinstance(table, StripeTable) else _planned(scan.plan)
        verdicts.update(counted)
        taken.append(ScanPart(scan.id, scan.mount, table, rig, calibration).numbered_from(first_view))
        corrections |= {first_view + view: motion for view, motion in ({} if anew else store.corrections(scan.id)).items()}
        first_view += int(table.view.max(initial=-1)) + 1
    if not verdicts[MEASURED]:
        raise CaseError("E-CASE-05", path=store.path, what="points", do="scan first, or choose wider gates")
    registration: dict[str, object] | None = None
    if anew and len(poses) > 1:
        placed = refine_parts(store, taken, poses)
        registration = placed.refinement.as_dict()
        poses, corrections = placed.poses, placed.corrections
    elif anew:
        found = register_views(merged([part.measured(store) for part in taken]))
        registration = found.as_dict()
        corrections = dict(enumerate(found.corrections))
    motions = placed_motions(taken, poses, corrections) if len(poses) > 1 else corrections
    measured = [part.measured(store, motions) for part in taken]
    cloud, taken_out = parted(merged(measured), processing.removed)
    if not len(cloud):
        raise CaseError("E-CASE-05", path=store.path, what="points", do="bring back some of those that were taken out")
    if taken_out is not None:
        verdicts[MEASURED] -= len(taken_out)
        verdicts[REMOVED] += len(taken_out)
    return ProcessedCase(
        processing=replace(processing, scans=tuple(scan.id for scan in scans)),
        cloud=cloud if len(poses) == 1 else replace(cloud, table_deg=None),
        counts=ScanCounts.of(planned, verdicts),
        calibrations=tuple(dict.fromkeys(part.calibration.identity() for part in taken)),
        noise=tuple(part.noise for part in measured),
        registered=anew,
        registration=registration,
        mounts=poses,
        taken_out=taken_out if taken_out is None or len(poses) == 1 else replace(taken_out, table_deg=None),
    )


# ------------------------------------------------------------------------------------------ inner
def _scans(store: CaseStore, processing: Processing) -> list[ScanRecord]:
    """The chosen scans, in the order of their ids."""
    known = {scan.id: scan for scan in store.scans() if scan.kind == "scan"}
    if missing := [number for number in processing.scans if number not in known]:
        raise UsageError("E-USE-01", what=f"The case holds no scan {missing[0]}", do=f"choose from {', '.join(map(str, known)) or 'none'}")
    if processing.scans:
        return [known[number] for number in sorted(processing.scans)]
    discarded = store.value(DISCARDED, [])
    if not isinstance(discarded, list):
        raise CaseFormatError("E-CASE-01", path=store.path, reason=f"its choice of '{DISCARDED}' is damaged")
    if counting := store.counting_scans(discarded):
        return [known[number] for number in counting]
    raise CaseError("E-CASE-05", path=store.path, what="points", do="scan first")


def _poses(store: CaseStore, scans: list[ScanRecord]) -> dict[int, RigidTransform]:
    """Where the mounts of these scans lie in the first mount of the case, in the order of their numbers; one alone is in its own frame."""
    mounts = sorted({scan.mount for scan in scans})
    if len(mounts) == 1:
        return {mounts[0]: RigidTransform.identity()}
    first, known = store.first_mount(), store.mount_poses()
    poses = {mount: RigidTransform.identity() if mount == first else known[mount].in_frame_of(first) if mount in known else None for mount in mounts}
    if missing := [mount for mount, pose in poses.items() if pose is None]:
        what = f"It is not known how mount {missing[0]} of the case lies to the others"
        raise UsageError("E-USE-01", what=what, do="register it first with 'impronta register CASE', or choose scans of one mount")
    return {mount: pose for mount, pose in poses.items() if pose is not None}


def _planned(plan: Mapping[str, Any]) -> int:
    """Trigger ids of a plan."""
    return sum(int(row["count"]) for view in plan["views"] for row in view["rows"])


def _rig(store: CaseStore, scan: ScanRecord, calibration_id: str | None, other: StereoCalibration | None) -> tuple[RigConfig, StereoCalibration]:
    """The rig as it was used, with the calibration that is asked for."""
    rig, used = case_rig(store, scan)
    if calibration_id is None or calibration_id == scan.calibration_id:
        return rig, used
    if other is None or other.identity() != calibration_id:
        if calibration_id not in store.calibration_ids():
            raise UsageError("E-USE-01", what=f"The case holds no calibration {calibration_id!r}", do="choose one with --calibration RIG.toml")
        other = case_calibration(store, calibration_id)
    if (other.left.size_px, other.right.size_px) != (used.left.size_px, used.right.size_px):
        raise UsageError("E-USE-01", what="The calibration is of cameras with other images", do="choose a calibration of this rig")
    return rig.with_calibration(other), other


def _gated(
    store: CaseStore, scan: ScanRecord, rig: RigConfig, calibration: StereoCalibration, processing: Processing
) -> tuple[ScanTable, Counter[str]]:
    """The observations that pass, and all verdicts."""
    if store.by_line(scan.id):
        return gated_places(store, scan.id, rig, calibration, processing.gates.given(), processing.without_views)
    pairs = store.pairs(scan.id)
    verdicts = Counter(store.verdict_counts(scan.id))
    verdicts.subtract(pairs.verdict.tolist())
    verdict = pairs.verdict.copy()
    gates = processing.gates
    if calibration.identity() != scan.calibration_id or any(getattr(gates, name) is not None for name in _GEOMETRIC):
        again = np.isin(verdict, _BY_GEOMETRY)
        verdict[again] = _by_geometry(pairs.observations.select(again), rig, calibration, gates)
    for reason, passes in _by_spots(pairs, gates):
        verdict[(verdict == MEASURED) & ~passes] = reason
    seen_views = set(pairs.observations.view.tolist())
    if missing := [view for view in processing.without_views if view not in seen_views]:
        raise UsageError("E-USE-01", what=f"Scan {scan.id} of the case has no view {missing[0]}", do=f"choose from {sorted(seen_views)}")
    verdict[(verdict == MEASURED) & np.isin(pairs.observations.view, processing.without_views)] = "left_out"
    over = superseded_views(scan.plan, pairs.observations.view[pairs.verdict == MEASURED], processing.without_views)
    verdict[(verdict == MEASURED) & np.isin(pairs.observations.view, over)] = "superseded"
    verdicts.update(verdict.tolist())
    return pairs.observations.select(verdict == MEASURED), Counter({name: count for name, count in verdicts.items() if count > 0})


def _by_geometry(table: ObservationTable, rig: RigConfig, calibration: StereoCalibration, gates: Gates) -> NDArray[np.object_]:
    """Verdicts (n,) as the engine gives them while scanning."""
    pixels = CentroidNoise(along_axes(table.left_uncertainty_px, table.left_sigma_px), along_axes(table.right_uncertainty_px, table.right_sigma_px))
    sigmas = NoiseModel.prior(calibration, rig.spot.floor_px).centroid_sigmas(calibration, pixels)
    seen = Triangulator(calibration).triangulate(table.left_px, table.right_px, *sigmas)
    points = np.empty_like(seen.points)
    for table_deg in np.unique(table.table_deg):
        here = table.table_deg == table_deg
        points[here] = calibration.rig_to_object(float(table_deg)).apply(seen.points[here])
    gate = EpipolarGate()
    if gates.epipolar_sigmas is not None:  # the floor goes along, or a narrow gate would not be one
        gate = EpipolarGate(gates.epipolar_sigmas, gate.floor_px * gates.epipolar_sigmas / gate.sigmas)
    radius = rig.volume.radius_mm if gates.volume_radius_mm is None else gates.volume_radius_mm
    height = rig.volume.height_mm if gates.volume_height_mm is None else gates.volume_height_mm
    inside = (np.hypot(points[:, 0], points[:, 1]) <= radius) & (points[:, 2] <= height)
    above = points[:, 2] >= (TABLE_MM if gates.table_mm is None else gates.table_mm)
    matches = gate.accepts(seen.epipolar_residual_px, *sigmas)
    mark = np.zeros(len(points), bool) if rig.marks is None else rig.marks.holds(points)  # a wider volume does not make them the object's
    return np.select([~matches, ~inside, ~above, mark], ["epipolar", "outside_volume", "table", "mark"], MEASURED).astype(object)


def _by_spots(pairs: PairTable, gates: Gates) -> list[tuple[str, NDArray[np.bool_]]]:
    """Reason of a rejection and which pairs pass, for every gate of the spots that is given."""
    table = pairs.observations
    sizes = np.sqrt(np.stack([np.mean(sigma**2, axis=1) for sigma in (table.left_sigma_px, table.right_sigma_px)]))
    uncertainty = np.maximum(table.left_uncertainty_px, table.right_uncertainty_px)
    found = []
    if gates.least_sigma_px is not None:
        found.append(("too_small", sizes.min(axis=0) >= gates.least_sigma_px))
    if gates.most_sigma_px is not None:
        found.append(("too_large", sizes.max(axis=0) <= gates.most_sigma_px))
    if gates.least_peak_dn is not None:
        found.append(("too_dim", pairs.peak_dn.min(axis=1) >= gates.least_peak_dn))
    if gates.most_uncertainty_px is not None:
        found.append(("too_uncertain", uncertainty <= gates.most_uncertainty_px))
    return found
