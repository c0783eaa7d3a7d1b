"""The points of a case computed anew, as a person chose it; or only without some of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from scanner_core.case.store import CaseStore
    from scanner_core.devices.rig import RigConfig
    from scanner_core.geometry.point_cloud import PointCloud


@dataclass(frozen=True, slots=True, eq=False)
class CutPoints:
    """The points of a case that are left and those that were taken out, None for none; what they are computed from, and the case's choice."""

    cloud: PointCloud
    taken_out: PointCloud | None
    source: dict[str, object]
    processing: dict[str, object]


def compute_anew(store: CaseStore, rig: RigConfig | None, gates: dict[str, float]) -> None:
    """With the calibration of `rig`, or as scanned, and with gates by their names; a choice that leaves nothing raises, and is not kept."""
    from scanner_core.case.processing import Gates, chosen_processing, keep_processing, process_case

    calibration = None if rig is None else rig.calibration
    identity = None if calibration is None else calibration.identity()
    before = chosen_processing(store)
    kept = {name: value for name, value in before.gates.given().items() if name not in ("least_peak_dn", "epipolar_sigmas")}
    processing = replace(before, calibration=identity, gates=Gates(**(kept | gates)))
    process_case(store, processing, calibration)
    keep_processing(store, processing, rig)


def cut_points(store: CaseStore, now: CutPoints, out: NDArray[np.bool_], words: str) -> CutPoints:
    """Leave those of all points out that a mask tells, an edit of the case; E-CASE-05 when none would be left, and nothing is changed."""
    from scanner_core.case.edits import PROCESSING
    from scanner_core.case.processing import chosen_processing
    from scanner_core.case.removed_points import together
    from scanner_core.errors import CaseError

    if out.all():
        raise CaseError("E-CASE-05", path=store.path, what="points", do="leave some of them")
    chosen = chosen_processing(store)
    whole = together(now.cloud, now.taken_out)
    processing = replace(chosen, removed=chosen.removed.within(whole, out))
    store.edit(PROCESSING, processing.as_dict(), words)
    return _cut(now, processing.as_dict())


def recut_points(now: CutPoints, choice: object) -> CutPoints | None:
    """The points after a choice of the case was undone or done again, where only the points taken out differ; otherwise None."""
    choice = choice if isinstance(choice, dict) else {}
    if _but_removed(choice) != _but_removed(now.processing):
        return None
    return _cut(now, choice)


def _but_removed(choice: dict[str, Any]) -> dict[str, Any]:
    """What else is chosen; as scanned is the same as nothing."""
    return {key: value for key, value in choice.items() if key != "removed" and value}


def _cut(now: CutPoints, choice: dict[str, Any]) -> CutPoints:
    from scanner_core.case.removed_points import RemovedPoints, parted, source_without, together

    removed = RemovedPoints.from_dict(choice["removed"]) if "removed" in choice else RemovedPoints()
    cloud, taken_out = parted(together(now.cloud, now.taken_out), removed)
    return CutPoints(cloud, taken_out, source_without(now.source, removed, cloud, taken_out), choice)
