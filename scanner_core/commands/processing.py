"""What the command line says of how a case's points are computed."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.case.processing import GATES, Gates, Processing, chosen_processing
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import dump_rig, load_rig_or_preset
from scanner_core.errors import CalibrationError, UsageError


def asked_processing(store: CaseStore, given: argparse.Namespace) -> Processing:
    """The processing of the options; without any of them what the case holds.

    A calibration that the case does not know is taken into it.

    Raises
    ------
    UsageError
        E-USE-01 for a gate that makes no sense; E-RIG-01 for a rig file that cannot be used.
    CalibrationError
        E-CAL-02 for a rig without a calibration.
    """
    if given.as_scanned:
        if given.calibration or given.gate or given.without_view or given.scan:
            raise UsageError("E-USE-01", what="--as-scanned is said together with a change", do="leave one of the two away")
        return Processing()
    if not (given.calibration or given.gate or given.without_view or given.scan):
        return chosen_processing(store)
    calibration = None if given.calibration is None else _kept(store, given.calibration)
    return Processing(calibration, _gates(given.gate), tuple(sorted(set(given.without_view))), tuple(sorted(set(given.scan))))


def _kept(store: CaseStore, name: str) -> str:
    """The identity of a rig's calibration, which the case holds from now on."""
    known = name if not Path(name).exists() and name in store.calibration_ids() else None
    if known is not None:
        return known
    rig = load_rig_or_preset(name)
    if rig.calibration is None:
        raise CalibrationError("E-CAL-02")
    store.put_calibration(rig.calibration.identity(), dump_rig(rig))
    return rig.calibration.identity()


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
