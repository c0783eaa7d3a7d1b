"""What the command line says of how a case's points are computed."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.case.processing import GATES, PROCESSING, Gates, ProcessedCase, Processing, chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig, dump_rig, load_rig_or_preset
from scanner_core.errors import CalibrationError, UsageError


def processed_as_asked(store: CaseStore, given: argparse.Namespace) -> ProcessedCase:
    """The points by the options; without any of them by what the case holds.

    Once there are points the choice is kept in the case, and with it a calibration that the case did not know.

    Raises
    ------
    UsageError
        E-USE-01 for a gate that makes no sense; E-RIG-01 for a rig file that cannot be used.
    CalibrationError
        E-CAL-02 for a rig without a calibration.
    """
    changed = bool(given.calibration or given.gate or given.without_view or given.scan)
    if given.as_scanned and changed:
        raise UsageError("E-USE-01", what="--as-scanned is said together with a change", do="leave one of the two away")
    if not (given.as_scanned or changed):
        return process_case(store, chosen_processing(store))
    if given.calibration in store.calibration_ids() and not Path(given.calibration).exists():
        rig, identity = None, given.calibration
    else:
        rig = _calibrated(given.calibration)
        identity = None if rig is None or rig.calibration is None else rig.calibration.identity()
    processing = Processing(identity, _gates(given.gate), tuple(sorted(set(given.without_view))), tuple(sorted(set(given.scan))))
    processed = process_case(store, processing, None if rig is None else rig.calibration)
    if rig is not None and identity is not None:
        store.put_calibration(identity, dump_rig(rig))
    if processing != chosen_processing(store):
        store.edit(PROCESSING, processing.as_dict(), "Points computed anew")
    return processed


def _calibrated(name: str | None) -> RigConfig | None:
    rig = None if name is None else load_rig_or_preset(name)
    if rig is not None and rig.calibration is None:
        raise CalibrationError("E-CAL-02")
    return rig


def _gates(texts: list[str]) -> Gates:
    values: dict[str, float] = {}
    for text in texts:
        name, _, number = text.partition("=")
        if name not in GATES:
            raise UsageError("E-USE-01", what=f"There is no gate '{name}'", do=f"choose from {', '.join(GATES)}, as NAME=NUMBER")
        try:
            values[name] = float(number)
        except ValueError:
            raise UsageError("E-USE-01", what=f"The gate '{name}' is '{number}', which is no number", do="write NAME=NUMBER") from None
    return Gates(**values)
