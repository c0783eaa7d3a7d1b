"""Brings the mounts of a case together, and keeps what came of it.

A mount is joined to those before it when a place for it was found (or a person's picked points say where), when its surface
then lies on theirs as closely as the views of one mount lie on each other, and when all pairs of mounts that overlap agree.
One that does not is kept apart, with the reason; it is tried again after every other that could be joined.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from scanner_core.case.edits import DISCARDED
from scanner_core.case.line_points import scan_table
from scanner_core.case.points import case_rig
from scanner_core.case.scan_parts import PlacedMounts, ScanPart, merged, placed_motions, refine_parts
from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseError, UsageError
from scanner_core.geometry.mount_refinement import PairFit
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import IsCancelled, OnProgress
from scanner_core.sentences import SENTENCES

Array = NDArray[np.float64]
Picks = tuple[Array, Array]
"""Places (n, 3) mm on a mount, in its own object frame, and the same places (n, 3) mm in that of the first mount."""

_AS_CLOSE, _AS_CLOSE_UM = 1.5, 5.0
"""A mount lies on the others when its distance is so many times that of views of one mount, and so much."""
_LEAST_AGREEING = 0.8
_MOST_CLOSURE_UM = 20.0
"""By so much a pair of mounts may want to lie otherwise than all pairs together let it: four times what is common to its points."""


class Start(Protocol):
    """How a mount lies on those that were joined before; see :class:`scanner_core.mounting.mount_start.MountStart`."""

    @property
    def transform(self) -> RigidTransform: ...
    @property
    def accepted(self) -> bool: ...
    @property
    def code(self) -> str: ...
    @property
    def fields(self) -> Mapping[str, object]: ...
    def as_dict(self) -> dict[str, object]: ...


class FindPose(Protocol):
    """Finds how `moving` lies on `fixed`, each in its own object frame."""

    def __call__(
        self,
        fixed: PointCloud,
        moving: PointCloud,
        *,
        seed: int,
        progress: OnProgress,
        cancelled: IsCancelled,
        fixed_towards: Array | None = None,
        moving_towards: Array | None = None,
    ) -> Start: ...


@dataclass(frozen=True, slots=True, eq=False)
class MountOutcome:
    """What became of one mount.

    Attributes
    ----------
    pose : its object frame to that of the first mount; None when it was not joined
    start : ``first``, ``kept`` (as it was joined before), ``found`` or ``picked``
    code, fields : of the sentence that says why it was not joined; empty when it was
    found : what the search for a place told, where there was one
    pairs : how it lies on each of the mounts that were joined before
    """

    mount: int
    points: int
    pose: RigidTransform | None
    start: str
    code: str = ""
    fields: Mapping[str, object] = field(default_factory=dict)
    found: Mapping[str, object] = field(default_factory=dict)
    pairs: tuple[PairFit, ...] = ()

    @property
    def reason(self) -> str:
        """Why it was not joined."""
        return SENTENCES[self.code].what.format(**self.fields) if self.code else ""

    def as_dict(self, first_mount: int) -> dict[str, object]:
        """For the case and JSON."""
        nearest = max(self.pairs, key=lambda pair: pair.matches, default=None)
        return {
            "mount": self.mount,
            "first_mount": first_mount,
            "points": self.points,
            "accepted": self.pose is not None,
            "start": self.start,
            "code": self.code,
            "reason": self.reason,
            "overlap_fraction": None if nearest is None else round(nearest.overlap_fraction, 3),
            "residual_um": None if nearest is None else round(nearest.residual_um, 2),
            "margin": self.found.get("margin"),
            "unique": None if not self.found else self.found.get("verdict") == "accepted",
            "transform": None if self.pose is None else self.pose.matrix().tolist(),
            "search": dict(self.found),
        }


@dataclass(frozen=True, slots=True, eq=False)
class RegisteredMounts:
    """The mounts of a case, as they lie now.

    Attributes
    ----------
    outcomes : of every mount, that of the first too, in the order of their numbers
    refinement : the report of the refinement of those that were joined; None when there are none beside the first
    closure_um : in a loop of mounts, how far a pair would rather lie otherwise; None without a loop
    """

    first_mount: int
    outcomes: tuple[MountOutcome, ...]
    refinement: dict[str, object] | None
    closure_um: float | None

    @property
    def refused(self) -> tuple[MountOutcome, ...]:
        """Those that were not joined."""
        return tuple(outcome for outcome in self.outcomes if outcome.pose is None)

    def error(self, store: CaseStore) -> CaseError | None:
        """What to say when a mount was not joined."""
        if not self.refused:
            return None
        outcome = self.refused[0]
        return CaseError("E-MNT-10", mount=outcome.mount, reason=outcome.reason, path=store.path)

    def as_dict(self) -> dict[str, object]:
        """The object ``mounts`` of the JSON."""
        return {
            "first_mount": self.first_mount,
            "mounts": [outcome.as_dict(self.first_mount) for outcome in self.outcomes],
            "joined": [outcome.mount for outcome in self.outcomes if outcome.pose is not None],
            "loop_closure_um": None if self.closure_um is None else round(self.closure_um, 2),
            "refinement": self.refinement,
        }

    def summary(self) -> list[str]:
        """The same in words."""
        lines = []
        for outcome in self.outcomes:
            values: dict[str, Any] = outcome.as_dict(self.first_mount)
            if outcome.mount == self.first_mount:
                continue
            if outcome.pose is None:
                lines.append(f"Mount {outcome.mount} is kept apart: {outcome.reason}")
                continue
            margin = "" if values["margin"] is None else f", margin to the second-best pose {values['margin']:.2f}"
            words = f"Mount {outcome.mount} joined ({outcome.start}): overlap {100 * values['overlap_fraction']:.0f} %, "
            lines.append(words + f"residual {values['residual_um']:.1f} um{margin}.")
        if self.refinement is not None and not self.refinement["converged"]:
            lines.append("The mounts still moved by micrometres when their refinement ended: more overlap, or points, would hold them.")
        if self.closure_um is not None:
            lines.append(f"Loops of mounts close within {self.closure_um:.1f} um.")
        return lines


def register_mounts(
    store: CaseStore,
    picks: Mapping[int, Picks] | None = None,
    *,
    anew: bool = False,
    find: FindPose | None = None,
    seed: int = 0,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = lambda: False,
) -> RegisteredMounts:
    """Bring all mounts of the case together that can be, and keep poses, corrections and reports in it.

    Parameters
    ----------
    picks : by mount, points that a person picked; that mount is not searched for
    anew : search also for the mounts that were joined before
    find : the search; None for :func:`scanner_core.mounting.find_pose`

    Raises
    ------
    CaseError
        E-CASE-05 when no scan has a point.
    ComparisonError
        E-CMP-05 when picked points do not say how surfaces lie.
    UsageError
        E-USE-01 for picks on a mount that the case does not have.
    Cancelled
        Nothing was kept.
    """
    registering = _Registering(store, picks or {}, anew, find or _default(), seed, progress, cancelled)
    result = registering.run()
    reports = [(outcome.mount, outcome.pose, outcome.as_dict(result.first_mount)) for outcome in result.outcomes if outcome.start != "first"]
    if reports:
        store.put_mount_poses(reports, registering.corrections())
    return result


def _default() -> FindPose:
    from scanner_core.mounting.global_pose import find_pose

    return find_pose


class _Registering:
    """One run: which mounts are joined so far, and where."""

    def __init__(
        self, store: CaseStore, picks: Mapping[int, Picks], anew: bool, find: FindPose, seed: int, progress: OnProgress, cancelled: IsCancelled
    ) -> None:
        self._store, self._picks, self._anew, self._find, self._seed = store, picks, anew, find, seed
        self._progress, self._cancelled = progress, cancelled
        self._parts = {part.mount: part for part in mount_parts(store)}
        if not self._parts:
            raise CaseError("E-CASE-05", path=store.path, what="points", do="scan first")
        self._first = min(self._parts)
        if unknown := [mount for mount in picks if mount not in self._parts or mount == self._first]:
            others = ", ".join(str(mount) for mount in self._parts if mount != self._first) or "none"
            raise UsageError("E-USE-01", what=f"Points were picked on mount {unknown[0]}", do=f"pick on mounts that are to be joined: {others}")
        self._poses = {self._first: RigidTransform.identity()}
        self._placed: PlacedMounts | None = None

    def run(self) -> RegisteredMounts:
        first = MountOutcome(self._first, len(self._parts[self._first].table), RigidTransform.identity(), "first")
        outcomes = {self._first: first}
        before = {} if self._anew else {mount: pose.in_frame_of(self._first) for mount, pose in self._store.mount_poses().items()}
        # Those that were joined before come first, then what a person has picked: they are what the others are searched on.
        waiting = sorted(set(self._parts) - {self._first}, key=lambda mount: (before.get(mount) is None, mount not in self._picks, mount))
        while waiting:
            joined = False
            for mount in list(waiting):
                outcomes[mount] = self._join(mount, before.get(mount))
                if outcomes[mount].pose is not None:
                    waiting.remove(mount)
                    joined = True
            if not joined:
                break
        for mount, pose in self._poses.items():  # a later mount has moved the earlier ones a little
            outcomes[mount] = _with_pose(outcomes[mount], pose)
        refinement = None if self._placed is None else self._placed.refinement
        loop = refinement is not None and len(refinement.pairs) >= len(self._poses)
        return RegisteredMounts(
            self._first,
            tuple(outcomes[mount] for mount in sorted(outcomes)),
            None if refinement is None else refinement.as_dict(),
            max(pair.closure_um for pair in refinement.pairs) if refinement is not None and loop else None,
        )

    def corrections(self) -> dict[int, dict[int, RigidTransform]]:
        """Of the views of the joined mounts, by scan and the view's own number."""
        if self._placed is None:
            return {}
        placed, first_view = self._placed, 0
        found: dict[int, dict[int, RigidTransform]] = {}
        for part in _numbered([self._parts[mount] for mount in sorted(self._poses)]):
            found[part.scan_id] = {int(view) - first_view: placed.corrections[int(view)] for view in part.views}
            first_view += int(self._parts[part.mount].table.view.max()) + 1
        return found

    def _join(self, mount: int, before: RigidTransform | None) -> MountOutcome:
        """Try to join a mount to those that are."""
        points = len(self._parts[mount].table)
        if before is not None and mount not in self._picks:
            start, how = before, "kept"
            kept = self._store.mount_poses()[mount].report.get("search")
            found: Mapping[str, object] = kept if isinstance(kept, dict) else {}
        else:
            told, how = self._started(mount)
            found = told.as_dict()
            if not told.accepted:
                return MountOutcome(mount, points, None, how, told.code, told.fields, found)
            start = told.transform
        mounts = sorted([*self._poses, mount])
        parts = _numbered([self._parts[number] for number in mounts])
        placed = refine_parts(self._store, parts, self._poses | {mount: start}, progress=self._progress, cancelled=self._cancelled)
        pairs = placed.refinement.pairs
        ours = tuple(pair for pair in pairs if mount in (placed.mounts[pair.first], placed.mounts[pair.second]))
        code, fields = _doubt(ours, pairs, placed.refinement.residual_within_um)
        if code:
            return MountOutcome(mount, points, None, how, code, fields, found, ours)
        self._poses, self._placed = dict(placed.poses), placed
        return MountOutcome(mount, points, placed.poses[mount], how, found=found, pairs=ours)

    def _started(self, mount: int) -> tuple[Start, str]:
        """Where a mount lies on those that were joined, by a person's points or by a search, and which of the two."""
        fixed, fixed_towards = self._joined()
        part = self._parts[mount]
        moving = part.measured(self._store, self._store.corrections(part.scan_id)).cloud  # corrected by the registration of its scan
        towards = _towards(moving, [part], {mount: RigidTransform.identity()})
        if mount not in self._picks:
            told = self._find(
                fixed,
                moving,
                seed=self._seed,
                progress=self._progress,
                cancelled=self._cancelled,
                fixed_towards=fixed_towards,
                moving_towards=towards,
            )
            return told, "found"
        from scanner_core.mounting.picked_pose import pose_from_points

        own, others = self._picks[mount]
        picked = pose_from_points(
            fixed, moving, others, own, seed=self._seed, cancelled=self._cancelled, fixed_towards=fixed_towards, moving_towards=towards
        )
        return picked, "picked"

    def _joined(self) -> tuple[PointCloud, Array]:
        """The points of the mounts that were joined, in the frame of the first, and where their light came from."""
        parts = _numbered([self._parts[mount] for mount in sorted(self._poses)])
        corrections = self._store.corrections(parts[0].scan_id) if self._placed is None else self._placed.corrections
        motions = placed_motions(parts, self._poses, corrections)
        cloud = merged([part.measured(self._store, motions) for part in parts])
        return cloud, _towards(cloud, parts, self._poses)


def mount_parts(store: CaseStore) -> list[ScanPart]:
    """Of every mount the newest scan that has points and was not discarded, each with its own numbers of views."""
    discarded = store.value(DISCARDED, [])
    newest = {}
    for scan in store.scans():
        left_out = isinstance(discarded, list) and scan.id in discarded
        if scan.kind == "scan" and not left_out and len(scan_table(store, scan.id)):
            newest[scan.mount] = scan
    return [ScanPart(scan.id, mount, scan_table(store, scan.id), *case_rig(store, scan)) for mount, scan in sorted(newest.items())]


def _numbered(parts: Sequence[ScanPart]) -> list[ScanPart]:
    """With the views of later scans numbered on."""
    first_view, found = 0, []
    for part in parts:
        found.append(part.numbered_from(first_view))
        first_view += int(part.table.view.max()) + 1
    return found


def _towards(cloud: PointCloud, parts: Sequence[ScanPart], poses: Mapping[int, RigidTransform]) -> Array:
    """Unit vectors (n, 3) from the points of these scans to where their beam turned, in the frame of the poses."""
    assert cloud.table_deg is not None
    assert cloud.views is not None
    pivots = np.empty_like(cloud.points)
    for part in parts:
        here = np.flatnonzero(np.isin(cloud.views, part.views))
        for table_deg in np.unique(cloud.table_deg[here]):
            in_object = RigidTransform.about_z(-float(table_deg)).apply(np.array([part.rig.laser.position_mm], np.float64))
            pivots[here[cloud.table_deg[here] == table_deg]] = poses[part.mount].apply(in_object)
    towards = pivots - cloud.points
    return np.asarray(towards / np.linalg.norm(towards, axis=1, keepdims=True), np.float64)


def _doubt(ours: Sequence[PairFit], pairs: Sequence[PairFit], within_um: float) -> tuple[str, dict[str, object]]:
    """The code and fields of why a mount must not be joined; empty when it may."""
    if not ours:
        return "E-MNT-11", {}
    most_um = _AS_CLOSE * within_um + _AS_CLOSE_UM
    worst = max(ours, key=lambda pair: pair.residual_um)
    agreeing = min(pair.agreeing_fraction for pair in ours)
    if worst.residual_um > most_um or agreeing < _LEAST_AGREEING:
        return "E-MNT-12", {"residual_um": f"{worst.residual_um:.0f}", "most_um": f"{most_um:.0f}", "agree": f"{100 * agreeing:.0f}"}
    closure_um = max(pair.closure_um for pair in pairs)
    if closure_um > _MOST_CLOSURE_UM:
        return "E-MNT-13", {"closure_um": f"{closure_um:.0f}"}
    return "", {}


def _with_pose(outcome: MountOutcome, pose: RigidTransform) -> MountOutcome:
    return MountOutcome(outcome.mount, outcome.points, pose, outcome.start, found=outcome.found, pairs=outcome.pairs)
