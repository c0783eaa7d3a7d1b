"""``impronta doctor``: every check of the rig and of the machine, each with one sentence and its remedy."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import tempfile
from dataclasses import asdict
from importlib import metadata
from pathlib import Path

from scanner_core.acquisition.exposing import light, propose_for_rig, typical_places
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commands.console import Console
from scanner_core.devices.camera import Camera
from scanner_core.devices.check import Check
from scanner_core.devices.rig import RigConfig, load_rig_or_preset
from scanner_core.errors import ImprontaError
from scanner_core.optics.auto_exposure import FULL_SCALE_DN, HIGHEST_BACKGROUND, HIGHEST_PEAK, LOWEST_PEAK, ExposureVerdict
from scanner_core.optics.calibration_age import AgeState, calibration_age
from scanner_core.optics.spot import Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_quality import SpotGrade, judge_spot
from scanner_core.virtual.specimens import load_specimen

_LIBRARIES = ("numpy", "scipy", "opencv-contrib-python-headless", "vtk", "pyserial", "pyvista", "pyvistaqt", "PySide6_Essentials")
_DISK_GIB = 1.0


def run(given: argparse.Namespace, console: Console) -> int:
    config = load_rig_or_preset(given.rig)
    checks = [*machine_checks(), calibration_check(config)]
    controller: dict[str, object] = {"port": config.controller.port, "transcript": []}
    cameras: list[dict[str, object]] = []
    try:
        specimen = load_specimen("sphere") if config.virtual else None
        with open_rig(config, specimen) as rig:
            checks += rig.motion.self_checks()
            checks += [camera_check(camera, cameras) for camera in (rig.left, rig.right)]
            checks += [spot_check(rig), exposure_check(rig)]
            controller = rig.motion.description()
    except ImprontaError as error:
        checks.append(Check("controller handshake" if error.code.startswith("E-MOT") else "open the rig", "fail", error.message, error.hint))
    values = {"rig": config.name, "checks": [asdict(check) for check in checks], "controller": controller, "cameras": cameras}
    marks = {"pass": "ok  ", "warn": "warn", "fail": "FAIL"}
    lines = [f"{marks[check.verdict]}  {check.name}: {check.detail}" + (f" {check.remedy}" if check.verdict != "pass" else "") for check in checks]
    console.result(values, lines)
    return 1 if any(check.verdict == "fail" for check in checks) else 0


def machine_checks() -> list[Check]:
    """Python, libraries, disk, processors."""
    version = ".".join(map(str, sys.version_info[:3]))
    checks = [Check("Python", "pass" if sys.version_info >= (3, 11) else "fail", f"version {version}.", "Install Python 3.11 or newer.")]
    missing, found = [], []
    for name in _LIBRARIES:
        try:
            found.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            missing.append(name)
    if missing:
        checks.append(Check("libraries", "fail", f"{', '.join(missing)} not installed.", "Run packaging/start.py again."))
    else:
        checks.append(Check("libraries", "pass", ", ".join(found) + "."))
    folder = Path.cwd()
    free_gib = shutil.disk_usage(folder).free / 2**30
    checks.append(
        Check("disk", "pass" if free_gib > _DISK_GIB else "warn", f"{free_gib:.1f} GiB free in this folder.", "Free some space before you scan.")
    )
    try:
        with tempfile.NamedTemporaryFile(dir=folder):
            checks.append(Check("permission", "pass", "files can be written in the current folder."))
    except OSError as fault:
        checks.append(Check("permission", "warn", f"the current folder cannot be written ({fault.strerror}).", "Give --out a folder of your own."))
    cores = os.cpu_count() or 1
    checks.append(Check("processors", "pass" if cores >= 2 else "warn", f"{cores}.", "Scanning and the window share one processor: expect delays."))
    return checks


def calibration_check(config: RigConfig) -> Check:
    """Whether the rig can measure."""
    if config.calibration is None:
        return Check("calibration", "fail", "the rig has none.", "Run 'impronta calibrate' or the Rig page.")
    calibration = config.calibration
    told = f"of {calibration.date}, held-out corners {calibration.held_out_rms_um:.1f} um rms."
    try:
        age = calibration_age(calibration)
    except ValueError:
        return Check("calibration", "warn", f"{told} Its date cannot be read.", "Calibrate anew ('impronta calibrate').")
    if calibration.scale is not None and not calibration.scale.verified:
        return Check("calibration", "warn", f"{told} {age.words()} Its scale is not verified.", "Calibrate with a length bar.")
    return Check("calibration", "pass" if age.state is AgeState.VALID else "warn", f"{told} {age.words()}", "Calibrate anew ('impronta calibrate').")


def camera_check(camera: Camera, cameras: list[dict[str, object]]) -> Check:
    """One frame; `cameras` gets the JSON."""
    frame = camera.grab()
    width, height = camera.size_px
    mean, peak = float(frame.image.mean()), int(frame.image.max())
    cameras.append({"name": camera.name, "size_px": [width, height], "rate_hz": camera.rate_hz, "mean_dn": round(mean, 2), "peak_dn": peak})
    if frame.image.shape != (height, width):
        return Check(f"camera {camera.name}", "fail", f"frames are {frame.image.shape[::-1]}, not {width} x {height}.", "Correct the rig file.")
    if mean > 0.3 * 255:
        return Check(f"camera {camera.name}", "warn", f"the background is bright ({mean:.0f} of 255).", "Shield the rig from ambient light.")
    return Check(f"camera {camera.name}", "pass", f"{width} x {height}, {camera.rate_hz:g} frames/s, background {mean:.1f} of 255.")


def spot_check(rig: OpenRig) -> Check:
    """The laser as both cameras see it, and whether its spot can be measured well; left off."""
    detector = SpotDetector(rig.config.spot)
    seen: dict[str, Spot | SpotMiss] = {}
    try:
        places = typical_places(rig, detector)
        for camera in (rig.left, rig.right):
            light(rig, places[camera.name])
            seen[camera.name] = detector.detect(camera.grab().image)
    finally:
        rig.motion.laser(False)
    after = [detector.detect(camera.grab().image) for camera in (rig.left, rig.right)]
    if any(isinstance(spot, Spot) for spot in after):
        return Check("laser seen", "fail", "a spot stays after the laser was switched off.", "Disconnect the laser and check its driver.")
    shown = "; ".join(f"{name} {_spot_words(spot)}" for name, spot in seen.items())
    judged = {name: judge_spot(spot, detector.parameters) for name, spot in seen.items()}
    advised: dict[str, list[str]] = {}
    for name, quality in judged.items():
        if quality.grade is not SpotGrade.GOOD:
            advised.setdefault(quality.advice, []).append(name)
    remedy = " ".join(f"Camera {' and '.join(names)}: {advice}" for advice, names in advised.items())
    return Check("laser seen", "warn" if remedy else "pass", f"{shown}; dark after switching off.", remedy)


def _spot_words(seen: Spot | SpotMiss) -> str:
    if isinstance(seen, SpotMiss):
        return "no spot"
    return f"sigma {seen.sigma_x_px:.2f} x {seen.sigma_y_px:.2f} px, peak {100 * seen.peak_dn / FULL_SCALE_DN:.0f} %"


def exposure_check(rig: OpenRig) -> Check:
    """Peak and background at the rig file's exposure and gain, and what they should be; cameras left as they were, laser off."""
    shown, remedies = [], []
    for name, result in propose_for_rig(rig).items():
        now, best = result.readings[0], result.readings[-1]
        shown.append(f"{name} peak {100 * now.peak_dn / FULL_SCALE_DN:.0f} %, background {100 * now.background_dn / FULL_SCALE_DN:.1f} %")
        if result.verdict is not ExposureVerdict.GOOD:
            remedies.append(f"Camera {name}: {result.verdict.advice}")
        elif len(result.readings) > 1:
            remedies.append(f"In the rig file, [camera.{name}]: exposure_ms = {best.exposure_ms:.2f}, gain_db = {best.gain_db:.1f}.")
    wanted = f"{100 * LOWEST_PEAK:.0f} to {100 * HIGHEST_PEAK:.0f} % and below {100 * HIGHEST_BACKGROUND:.0f} % are wanted"
    return Check("exposure", "warn" if remedies else "pass", f"{'; '.join(shown)} ({wanted}).", " ".join(remedies))
