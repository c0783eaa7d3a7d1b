"""Which places of a laser line a person's choice leaves: narrower volumes, and views left out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from scanner_core.acquisition.line_engine import FLOOR_PX
from scanner_core.case.observation import MEASURED
from scanner_core.case.store import CaseStore
from scanner_core.case.stripes import StripeTable
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.stripe_matching import StripeMatcher

_GATES = ("volume_radius_mm", "volume_height_mm", "table_mm")


def gated_places(
    store: CaseStore, scan_id: int, rig: RigConfig, calibration: StereoCalibration, gates: Mapping[str, float], without_views: Sequence[int]
) -> tuple[StripeTable, Counter[str]]:
    """The places that pass, and all verdicts.  What was rejected while scanning is no pair, so that no gate takes it in again.

    Raises
    ------
    UsageError
        E-USE-01 for a gate that spots alone have, or a view that the scan lacks.
    """
    table, verdicts = store.stripe_points(scan_id), Counter(store.verdict_counts(scan_id))
    if other := [name for name in gates if name not in _GATES]:
        raise UsageError("E-USE-01", what=f"The gate '{other[0]}' is one of laser spots, and scan {scan_id} was made by a line", do="leave it away")
    if missing := [view for view in without_views if view not in set(table.view.tolist())]:
        known = sorted(set(table.view.tolist()))
        raise UsageError("E-USE-01", what=f"Scan {scan_id} of the case has no view {missing[0]}", do=f"choose from {known}")
    points = np.empty((len(table), 3))
    if gates:
        located, _ = StripeMatcher(calibration, FLOOR_PX).located(table.pairs)
        for table_deg in np.unique(table.table_deg):
            here = table.table_deg == table_deg
            points[here] = calibration.rig_to_object(float(table_deg)).apply(located[here])
    kept = np.ones(len(table), np.bool_)
    inside = np.hypot(points[:, 0], points[:, 1]) <= gates.get("volume_radius_mm", np.inf) if gates else kept
    low = points[:, 2] <= gates.get("volume_height_mm", np.inf) if gates else kept
    above = points[:, 2] >= gates.get("table_mm", -np.inf) if gates else kept
    for reason, passes in (("outside_volume", inside & low), ("table", above), ("left_out", ~np.isin(table.view, without_views))):
        lost = int((kept & ~passes).sum())
        verdicts[reason] += lost
        verdicts[MEASURED] -= lost
        kept &= passes
    return table.select(kept), Counter({name: count for name, count in verdicts.items() if count > 0})
