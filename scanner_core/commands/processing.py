"""What the command line says of how a case's points are computed."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

from scanner_core.case.edits import PROCESSING
from scanner_core.case.processing import GATES, Gates, ProcessedCase, Processing, chosen_processing, keep_processing, process_case
from scanner_core.case.removed_points import RemovedPoints
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import RigConfig, load_rig_or_preset
from scanner_core.errors import CalibrationError, CaseFormatError, UsageError


@dataclass(frozen=True, slots=True)
class AskedProcessing:
    """What the options say, and the rig whose calibration the case does not hold yet."""

    processing: Processing
    rig: RigConfig | None

    def points(self, store: CaseStore) -> ProcessedCase:
        return process_case(store, self.processing, None if self.rig is None else self.rig.calibration)

    def keep(self, store: CaseStore) -> None:
        """Let the case have this choice."""
        if store.value(PROCESSING, Processing().as_dict()) != self.processing.as_dict():  # also where that is damaged
            keep_processing(store, self.processing, self.rig)


def asked_processing(store: CaseStore, given: argparse.Namespace) -> AskedProcessing:
    """The processing of the options; without any of them what the case holds.

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
        return AskedProcessing(chosen_processing(store), None)
    if given.calibration in store.calibration_ids() and not Path(given.calibration).exists():
        rig, identity = None, given.calibration
    else:
        rig = _calibrated(given.calibration)
        identity = None if rig is None or rig.calibration is None else rig.calibration.identity()
    views, scans = (tuple(sorted(set(numbers))) for numbers in (given.without_view, given.scan))
    return AskedProcessing(Processing(identity, _gates(given.gate), views, scans, _removed(store)), rig)


def _removed(store: CaseStore) -> RemovedPoints:
    """What a person took out stays so whatever the points are computed with; nothing where the case's choice is damaged, which this one replaces."""
    try:
        return chosen_processing(store).removed
    except CaseFormatError:
        return RemovedPoints()


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
