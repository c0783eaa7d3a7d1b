"""The points of a case computed anew, as a person chose it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scanner_core.case.store import CaseStore
    from scanner_core.devices.rig import RigConfig


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
