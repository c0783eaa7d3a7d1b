"""``impronta calibrate``: stereo and turntable axis from ChArUco views."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.acquisition.calibrating import calibrate_rig
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands.calibration_report import calibration_json, calibration_summary
from scanner_core.commands.console import Console
from scanner_core.devices.rig import dump_rig, load_rig_or_preset
from scanner_core.files import check_free, replaced_when_whole


def run(given: argparse.Namespace, console: Console) -> int:
    config = load_rig_or_preset(given.rig)
    out = None if given.out is None else Path(given.out).resolve()
    if out is not None:
        check_free(out, given.force)
    with open_rig(config, None, "max", given.seed) as rig:
        calibration = calibrate_rig(rig, progress=lambda told: console.progress("calibrate", told.fraction, told.seconds_left))
    lines = [calibration_summary(calibration)]
    if out is not None:
        with replaced_when_whole(out, given.force) as partial:
            partial.write_text(dump_rig(config.with_calibration(calibration)), encoding="utf-8")
        lines.append(f"Written to {out}.")
    console.result(calibration_json(calibration) | {"rig": None if out is None else str(out)}, lines)
    return 0
