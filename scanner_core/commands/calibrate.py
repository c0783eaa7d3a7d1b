"""``impronta calibrate``: stereo, scale and turntable axis from ChArUco views and a known length."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from scanner_core.acquisition.calibrating import calibrate_rig, default_settings
from scanner_core.acquisition.recording import check_recordable
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commands.by_hand import Prompter
from scanner_core.commands.calibration_report import calibration_json, calibration_summary, result_json, result_summary
from scanner_core.commands.console import Console
from scanner_core.commands.scanning import recording, recording_warnings, rig_given, rig_path
from scanner_core.devices.rig import recalibrated, rig_text
from scanner_core.errors import UsageError
from scanner_core.files import check_free, replaced_when_whole
from scanner_core.optics.board import DEFAULT_BAR, DEFAULT_TARGET, CharucoTarget
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.calibration_session import CalibrationSettings, Person


def run(given: argparse.Namespace, console: Console) -> int:
    text = rig_text(rig_path(given))
    config = rig_given(given)
    if given.record is not None:
        check_recordable(Path(given.record).resolve())
    out = None if given.out is None else Path(given.out).resolve()
    if out is not None:
        check_free(out, given.force)
    with open_rig(config, None, "max", given.seed) as rig:
        target, settings = target_given(given), settings_given(given, rig)
        with recording(given, rig) as told:
            result = _calibrated(rig, console, target, settings)
    lines = [calibration_summary(result.calibration), *result_summary(result)]
    values = calibration_json(result.calibration) | result_json(result)
    values["warnings"] = [*result.warnings(), *recording_warnings(console, told)]
    if told is not None:
        lines.append(told.summary())
    if out is not None:
        with replaced_when_whole(out, given.force) as partial:
            partial.write_text(recalibrated(text, result.calibration), encoding="utf-8")
        lines.append(f"Written to {out}.")
    console.result(values | {"rig": None if out is None else str(out)}, lines)
    return 0


def _calibrated(rig: OpenRig, console: Console, target: CharucoTarget, settings: CalibrationSettings) -> CalibrationResult:
    if rig.bench is not None or rig.replayed:
        return calibrate_rig(
            rig,
            target=target,
            settings=settings,
            progress=lambda told: console.progress("calibrate", told.fraction, told.seconds_left),
        )
    asks = Prompter(console)
    asks.begin(settings)
    return calibrate_rig(rig, Person(asks.say), target=target, settings=settings, progress=asks.progress, watch=asks.watch)


def target_given(given: argparse.Namespace) -> CharucoTarget:
    """The board, with the size of its squares as given."""
    share = DEFAULT_TARGET.marker_mm / DEFAULT_TARGET.square_mm
    square_mm = DEFAULT_TARGET.square_mm if given.square_mm is None else given.square_mm
    return replace(DEFAULT_TARGET, square_mm=square_mm, marker_mm=share * square_mm)


def settings_given(given: argparse.Namespace, rig: OpenRig) -> CalibrationSettings:
    """The rig's own way, changed by what was given."""
    if given.no_length and given.length_mm is not None:
        raise UsageError("E-USE-01", what="--length-mm and --no-length exclude each other", do="give one of them")
    settings = default_settings(rig)
    if given.no_length or given.print_width_mm is not None:
        settings = replace(settings, bar=None, measured_width_mm=given.print_width_mm)
    if given.length_mm is not None:
        settings = replace(settings, bar=replace(settings.bar or DEFAULT_BAR, length_mm=given.length_mm))
    return replace(settings, valid_days=given.valid_days or settings.valid_days, board_thickness_mm=given.thickness_mm)
