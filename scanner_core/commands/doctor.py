"""``impronta doctor``: what is plugged in, and every check of the rig and of the machine, each with one sentence and its remedy.

With a rig file it checks that rig; with ``--find`` it asks every port and every camera of the machine; with neither it does both,
on the virtual rig.  With ``--out`` it writes a rig file for what it found, after it has checked that rig by what the cameras see.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from scanner_core.clock import ScaledClock
from scanner_core.commands.console import Console
from scanner_core.commissioning.device_checks import check_devices, found_values
from scanner_core.commissioning.found_devices import FoundDevices, find_devices
from scanner_core.devices.check import Check
from scanner_core.devices.discovery import SerialPort, serial_ports
from scanner_core.errors import DeviceError, ImprontaError
from scanner_core.files import check_free
from scanner_core.jobs.progress import Progress

if TYPE_CHECKING:  # what takes a second to import waits until the devices have been asked
    from scanner_core.commissioning.rig_check import RigCheck
    from scanner_core.commissioning.rig_findings import RigFindings
    from scanner_core.devices.rig import RigConfig
    from scanner_core.virtual.fault import Fault
    from scanner_core.virtual.specimens import Specimen

_DEFAULT = "bench"
_SPECIMEN = "sphere"
_MARKS = {"pass": "ok  ", "warn": "warn", "fail": "FAIL"}


@dataclass(slots=True)
class _Report:
    """What is told in the end; a check is told as soon as it is made."""

    console: Console
    checks: list[Check] = field(default_factory=list)
    controller: dict[str, object] = field(default_factory=dict)
    cameras: list[dict[str, object]] = field(default_factory=list)
    more: dict[str, object] = field(default_factory=dict)

    def tell(self, *checks: Check) -> None:
        for check in checks:
            self.checks.append(check)
            self.console.line(f"{_MARKS[check.verdict]}  {check.name}: {check.detail} {check.remedy}".rstrip())


def run(given: argparse.Namespace, console: Console) -> int:
    if given.out is not None:
        check_free(given.out, given.force)
    only_find = given.find or given.out is not None
    report = _Report(console)
    found = _find(given, console, report) if only_find or given.rig is None else None

    from scanner_core.commissioning.machine import check_machine

    if found is not None:
        report.tell(*check_devices(found, needed=only_find))
    report.tell(*check_machine())
    if found is not None and only_find:
        controller = found.controller()
        report.controller = {"port": "" if controller is None else controller.port.url, "transcript": []}
        if given.out is not None:
            _write(given, console, found, report)
    else:
        _check_given(given, console, report)
    values = {"checks": [asdict(check) for check in report.checks], "controller": report.controller, "cameras": report.cameras, **report.more}
    console.result(values, [])
    return 1 if any(check.verdict == "fail" for check in report.checks) else 0


def arguments(rig: str | None) -> argparse.Namespace:
    """What :func:`run` is given for one rig and nothing else; None finds devices."""
    lists: dict[str, list[str]] = {"port": [], "camera": [], "fault": [], "without": []}
    return argparse.Namespace(rig=rig, specimen=_SPECIMEN, speed="max", seed=0, find=False, out=None, thumbnails=None, force=False, **lists)


def _find(given: argparse.Namespace, console: Console, report: _Report) -> FoundDevices:
    ports = [SerialPort(url, "") for url in given.port] or serial_ports()
    found = find_devices(ScaledClock(), progress=_shown(console), cancelled=lambda: False, ports=ports, streams=given.camera)

    from scanner_core.commissioning.thumbnails import picture_name, write_picture

    report.more["found"] = found_values(found)
    for camera in found.cameras:
        if given.thumbnails is not None and camera.thumbnail is not None:
            write_picture(Path(given.thumbnails) / picture_name(camera.driver, camera.id), camera.thumbnail, force=given.force)
    return found


def _write(given: argparse.Namespace, console: Console, found: FoundDevices, report: _Report) -> None:
    """A rig of what was found, checked by what its cameras see."""
    from scanner_core.commissioning.proposed_rig import corrected_rig, propose_rig, write_rig
    from scanner_core.devices.rig import load_rig_or_preset

    controller, cameras = found.controller(), found.usable_cameras()
    if controller is None or len(cameras) < 2:
        error = DeviceError("E-RIG-03", controller="no controller" if controller is None else "a controller", cameras=len(cameras))
        report.tell(Check("rig file", "fail", error.message, error.hint))
        return
    config = propose_rig(load_rig_or_preset(given.rig or _DEFAULT), controller, cameras[0], cameras[1])
    findings = _check(given, console, config, report)
    if findings is None:
        report.tell(Check("rig file", "fail", "none was written, because the rig could not be checked.", "Repair what failed, then try again."))
        return
    write_rig(Path(given.out), corrected_rig(config, findings), force=given.force)
    report.tell(Check("rig file", "pass", f"{given.out} was written; correct its limits for your mechanics, then calibrate."))
    report.more["out"] = str(given.out)


def _check_given(given: argparse.Namespace, console: Console, report: _Report) -> None:
    """The rig that was named, or the virtual one."""
    from scanner_core.commissioning.calibration_check import check_calibration
    from scanner_core.devices.rig import load_rig_or_preset

    config = load_rig_or_preset(given.rig or _DEFAULT).without(given.without)
    report.more["rig"] = config.name
    report.controller = {"port": config.controller.port, "transcript": []}
    report.tell(check_calibration(config))
    _check(given, console, config, report)


def _check(given: argparse.Namespace, console: Console, config: RigConfig, report: _Report) -> RigFindings | None:
    """Open the rig and check it; a rig that does not open is a line."""
    from scanner_core.acquisition.rig_session import open_rig

    def told(made: RigCheck) -> None:
        report.tell(made.check)
        if made.check.name.startswith("camera "):
            report.cameras.append(dict(made.values))
        for name, image in made.pictures.items():
            if given.thumbnails is not None:
                from scanner_core.commissioning.thumbnails import picture_name, write_picture

                write_picture(Path(given.thumbnails) / picture_name(made.check.name, name), image, force=given.force)

    faults: list[Fault] = []
    if given.fault:
        from scanner_core.virtual.faults import parse_fault

        faults = [parse_fault(text) for text in given.fault]
    try:
        with open_rig(config, _specimen(given, config), given.speed, given.seed, faults) as rig:
            from scanner_core.commissioning.rig_check import check_rig

            findings = check_rig(rig, progress=_shown(console), cancelled=lambda: False, on_check=told)
            report.controller = rig.motion.description()
            return findings
    except ImprontaError as error:
        report.tell(Check("controller handshake" if error.code.startswith("E-MOT") else "open the rig", "fail", error.message, error.hint))
        return None


def _specimen(given: argparse.Namespace, config: RigConfig) -> Specimen | None:
    """What stands on the virtual rig's table."""
    if config.virtual is None:
        return None
    from scanner_core.virtual.specimens import load_specimen

    return load_specimen(given.specimen)


def _shown(console: Console) -> Callable[[Progress], None]:
    return lambda at: console.progress(at.phase, at.fraction)
