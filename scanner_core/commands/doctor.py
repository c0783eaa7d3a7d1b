"""``impronta doctor``: every check of the rig and of the machine, each with one sentence and its remedy."""

from __future__ import annotations

import argparse
from dataclasses import asdict

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands.console import Console
from scanner_core.commissioning.calibration_check import check_calibration
from scanner_core.commissioning.machine import check_machine
from scanner_core.commissioning.rig_check import RigCheck, check_rig
from scanner_core.devices.check import Check
from scanner_core.devices.rig import load_rig_or_preset
from scanner_core.errors import ImprontaError
from scanner_core.virtual.specimens import load_specimen


def run(given: argparse.Namespace, console: Console) -> int:
    config = load_rig_or_preset(given.rig)
    checks = [*check_machine(), check_calibration(config)]
    controller: dict[str, object] = {"port": config.controller.port, "transcript": []}
    cameras: list[dict[str, object]] = []
    try:
        specimen = load_specimen("sphere") if config.virtual else None
        with open_rig(config, specimen) as rig:

            def told(made: RigCheck) -> None:
                checks.append(made.check)
                if made.check.name.startswith("camera "):
                    cameras.append(dict(made.values))

            check_rig(rig, progress=lambda at: console.progress(at.phase, at.fraction), cancelled=lambda: False, on_check=told)
            controller = rig.motion.description()
    except ImprontaError as error:
        checks.append(Check("controller handshake" if error.code.startswith("E-MOT") else "open the rig", "fail", error.message, error.hint))
    values = {"rig": config.name, "checks": [asdict(check) for check in checks], "controller": controller, "cameras": cameras}
    marks = {"pass": "ok  ", "warn": "warn", "fail": "FAIL"}
    lines = [f"{marks[check.verdict]}  {check.name}: {check.detail}" + (f" {check.remedy}" if check.verdict != "pass" else "") for check in checks]
    console.result(values, lines)
    return 1 if any(check.verdict == "fail" for check in checks) else 0
