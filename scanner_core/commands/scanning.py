"""What ``demo``, ``scan`` and ``verify`` share: the rig as asked for, the specimen on the table, the run with its progress, and the JSON of it."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.recording import RIG, Recorded, recorded, recorded_rig
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import ScanState
from scanner_core.case.recovery import Interruption
from scanner_core.case.store import CaseStore
from scanner_core.commands.console import Console
from scanner_core.devices.aim_settings import aim_path
from scanner_core.devices.rig import PRESETS as SHIPPED_RIGS
from scanner_core.devices.rig import RigConfig, load_rig_or_preset
from scanner_core.errors import CalibrationError, UsageError
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.optics.calibration_age import AgeState, calibration_age
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.faults import parse_fault
from scanner_core.virtual.host_faults import CaseLocked
from scanner_core.virtual.presets import GEOMETRIC_TERMS, PRESETS
from scanner_core.virtual.specimens import Specimen, check_fits, load_specimen, remounted


def rig_given(given: argparse.Namespace) -> RigConfig:
    """The rig of ``--rig``, or the one of ``--replay`` with the cameras of its recording.

    Raises
    ------
    UsageError
        E-RIG-01.
    DeviceError
        E-CAM-20.
    """
    return load_rig_or_preset(given.rig) if given.replay is None else recorded_rig(Path(given.replay))


def rig_path(given: argparse.Namespace) -> str:
    """The file that describes the rig, or a preset's name."""
    return str(given.rig) if given.replay is None else str(Path(given.replay) / RIG)


def aimed_elsewhere(given: argparse.Namespace) -> str | None:
    """What is to be said where the window keeps other settings beside the rig file: commands measure with what the file itself says."""
    if given.replay is not None or given.rig in SHIPPED_RIGS or not (path := aim_path(Path(given.rig))).exists():
        return None
    return f"Note: what was set on the window's Aim page ({path}) is not used by commands; the rig file's own exposure and spot limits are."


def is_rendered(config: RigConfig) -> bool:
    """Whether the virtual bench makes images of a specimen."""
    return any(camera.driver == "virtual" for camera in (config.left, config.right))


def recording(given: argparse.Namespace, rig: OpenRig, request: PlanRequest | None = None) -> AbstractContextManager[Recorded | None]:
    """What ``--record`` asks for, while the body runs."""
    return nullcontext() if given.record is None else recorded(rig, Path(given.record).resolve(), request)


def recording_warnings(console: Console, told: Recorded | None) -> list[str]:
    """What is to be said of a recording after a measurement that came to its end; it is said."""
    warnings = [] if told is None else told.warnings()
    for warning in warnings:
        console.say(f"Warning: {warning}")
    return warnings


def calibrated_rig(given: argparse.Namespace) -> tuple[RigConfig, StereoCalibration]:
    """The rig to measure with, as it was asked for, and its calibration.

    Raises
    ------
    UsageError
        E-RIG-01; E-USE-01, among others for ``--without`` a term that makes other cameras than were calibrated.
    CalibrationError
        E-CAL-02.
    """
    config = rig_given(given)
    other_cameras = [term for term in GEOMETRIC_TERMS if term in given.without]
    if config.virtual is not None and other_cameras:
        raise UsageError(
            "E-USE-01",
            what=f"Without {' and '.join(other_cameras)} the cameras are others than those that were calibrated",
            do=f"put without = {json.dumps(other_cameras)} into the table [image_model] of a rig file, calibrate that rig, and measure with it",
        )
    config = without_terms(config, given.without)
    if config.calibration is None:
        raise CalibrationError("E-CAL-02")
    return config, config.calibration


def without_terms(config: RigConfig, terms: Sequence[str]) -> RigConfig:
    """The virtual rig with terms of its image model switched off; other cameras have no calibration yet.

    Raises
    ------
    UsageError
        E-USE-01 when there is no such term, or the image model of the rig file makes no rig.
    """
    if config.virtual is None:
        if terms:
            raise UsageError("E-USE-01", what="Only the virtual rig's image model has terms to switch off", do="leave --without away")
        return config
    if config.virtual in PRESETS:  # what is wrong here is said before anything is written or opened
        PRESETS[config.virtual].changed(config.image_model).without(*terms)
    changed = config.without(terms)
    return changed.with_calibration(None) if set(terms) & set(GEOMETRIC_TERMS) else changed


def specimen_on_table(given: argparse.Namespace, rig: RigConfig) -> Specimen:
    """The specimen that was asked for; refused when it is larger than what both cameras see."""
    specimen = load_specimen(given.specimen, treated=getattr(given, "treated", False))
    if (pose := getattr(given, "pose", None)) is not None:
        specimen = remounted(specimen, pose)
    check_fits(specimen, rig.volume)
    return specimen


def faults(given: argparse.Namespace, config: RigConfig) -> list[Fault]:
    """What ``--fault`` lets go wrong on the virtual rig; E-USE-01 on hardware and on recordings."""
    if given.fault and not is_rendered(config):
        raise UsageError("E-USE-01", what="Faults happen on the virtual rig only", do="leave --fault away")
    return [parse_fault(text) for text in given.fault]


def case_as_found(path: Path, to_come: Sequence[Fault]) -> AbstractContextManager[None]:
    """An existing case as it is found: open in another program where ``case_locked`` is to happen from the first moment on."""
    locked = any(isinstance(fault, CaseLocked) and fault.at_s == 0.0 for fault in to_come)
    return CaseLocked.held(path) if locked and path.exists() else nullcontext()


def age_warnings(calibration: StereoCalibration) -> list[str]:
    """What is to be said before anything is measured with a calibration: that it has expired."""
    try:
        age = calibration_age(calibration)
    except ValueError:
        return ["The calibration's date cannot be read, so that nobody knows whether it expired; calibrate anew ('impronta calibrate')."]
    if age.state is not AgeState.EXPIRED:
        return []
    return [f"The calibration is not valid any more: {age.words().lower().rstrip('.')}; calibrate anew ('impronta calibrate')."]


def sized_for(request: PlanRequest, specimen: Specimen | None) -> PlanRequest:
    """The request with the object's size filled in where nobody stated one."""
    if specimen is None or request.object_radius_mm is not None:
        return request
    return replace(request, object_radius_mm=specimen.radius_mm, object_height_mm=specimen.height_mm)


def run_scan(
    console: Console,
    rig: OpenRig,
    request: PlanRequest,
    store: CaseStore,
    interrupted: Interruption | None = None,
    begun: Callable[[], None] = lambda: None,
    mount: int = 0,
) -> ScanResult:
    """Run a scan, or the rest of one, to its end, also when Ctrl-C ends it; the result says how it ended.

    `begun` is called, maybe more than once, when the case holds points of it; `mount` is how the object stands, for a new scan.
    """
    rig.concern(store)
    runner = ScanRunner(rig, request, store, mount=mount, interruption=interrupted)
    runner.start()
    told: set[str] = set()
    while True:
        try:
            try:
                while not runner.join(0.1):
                    if runner.status().counts.measured:
                        begun()
                    _show(console, runner)
                    _warn(console, runner, told)
                break
            except KeyboardInterrupt:
                runner.cancel()  # first: a terminal that was closed takes no sentence any more
                console.say("Stopping: the laser is off, what was measured is kept.")
        except KeyboardInterrupt:
            continue  # an impatient second one; the end of the scan is waited for all the same
    console.clear()
    _warn(console, runner, told)
    if runner.result is None:
        raise RuntimeError("a scan ended without a result")
    if begins(runner.result):
        begun()
    return runner.result


def finding_warnings(result: ScanResult) -> list[str]:
    """What was noticed on the way and makes points doubtful."""
    return [f"{finding.sentence} [{finding.code}]" for finding in result.health.findings if finding.severity == "warning"]


def begins(result: ScanResult) -> bool:
    """Whether anything was measured, be it in the coarse pass."""
    return bool(result.counts.measured or result.located.measured)


def scan_json(result: ScanResult, rate_hz: float, case: str) -> dict[str, object]:
    """The JSON of ``scan``.

    Beside the counts over the plan's trigger ids (``planned = measured + sum(rejected) + skipped``) and those of ``locating``:

    - ``repeated_views`` were measured once more, because they were weak; ``weak_views`` gave far fewer points than their neighbours and
      stayed so: numbers, from 1 on;
    - ``closure_um``: by how much the first view lay beside itself when it was measured again after the turn, null where it was not;
    - ``seconds`` on the wall and ``rig_seconds`` on the rig's clock, both without the registration at the end.  Simulated time at
      speed ``max`` stands still while a pass is computed; on a rig that keeps real time ``rig_seconds`` hold ``computing_seconds``.
    - ``marks`` where the rig has them, ``resumed`` (``points_before``) of a resumed scan, ``error`` (``code``, ``sentence``) of a failed one;
    - of an error-driven scan ``until_um``, ``passes``, ``passes_end``, ``computing_seconds``, ``coverage``, ``remount`` and ``not_steered``:
      see :meth:`~scanner_core.acquisition.passes.SteeringResult.as_dict`.

    Parameters
    ----------
    rate_hz : the cameras' frame rate
    case : where the points are kept
    """
    counts = result.counts
    registration = result.views.registration if result.views is not None else None
    values: dict[str, object] = {
        "laser": result.laser,
        "finish_reason": result.finish_reason.value,
        "views": result.views_planned,
        "planned": counts.planned,
        "measured": counts.measured,
        "rejected": counts.rejected,
        "skipped": counts.skipped,
        "points": counts.measured,
        "locating": {
            "planned": result.located.planned,
            "measured": result.located.measured,
            "rejected": result.located.rejected,
            "skipped": result.located.skipped,
        },
        "rate_hz": round(result.exposures / result.wall_s, 1),
        "seconds": round(result.wall_s, 2),
        "rig_seconds": round(result.rig_s, 2),
        "realtime_factor": round(result.exposures / result.wall_s / rate_hz, 2),
        "case": case,
        "registration": None if registration is None else registration.as_dict(),
        "repeated_views": [view + 1 for view in result.repeated_views],
        "weak_views": [view + 1 for view in result.weak_views],
        "closure_um": None if result.closure_um is None else round(result.closure_um, 1),
        "health": result.health.as_dict(),
    }
    if result.marks is not None:
        values["marks"] = result.marks.as_dict()
    if result.steering is not None:
        values |= result.steering.as_dict()
    if result.resumed is not None:
        values["resumed"] = {"points_before": result.resumed}
    if result.error is not None:
        values["error"] = {"code": result.error.code, "sentence": str(result.error)}
    return values


def scan_summary(result: ScanResult) -> list[str]:
    """The same in words."""
    counts = result.counts
    rejected = ", ".join(f"{name} {count}" for name, count in counts.rejected.items()) or "none"
    what = "planned measurements" if result.laser == "spot" else f"places of the line in {result.exposures} pairs of frames"
    lines = [
        f"Scan {result.finish_reason.value}: {counts.measured} points of {counts.planned} {what}, "
        f"{sum(counts.rejected.values())} rejected ({rejected}), {counts.skipped} skipped.",
    ]
    if result.resumed is not None:
        lines.append(f"{result.resumed} of the points were there before the interruption.")
    if result.steering is not None:
        lines += result.steering.summary()
    if result.views is not None:
        said = result.views.registration
        if said.applied:
            lines.append(f"Views registered: residual {said.residual_before_um:.1f} um before, {said.residual_after_um:.1f} um after the refinement.")
        elif result.views_planned > 1:
            lines.append(f"Views brought together by the turntable's axis, residual {said.residual_before_um:.1f} um; not refined: {said.reason}.")
    if result.repeated_views:
        lines.append(f"Views that were weak and measured once more: {_numbers(result.repeated_views)}.")
    if result.weak_views:
        lines.append(f"Views that gave far fewer points than their neighbours: {_numbers(result.weak_views)}.")
    if result.closure_um is not None:
        lines.append(f"After the turn the first view lies {result.closure_um:.1f} um beside itself.")
    if result.marks is not None:
        lines.append(f"Marks on the table's rim: {result.marks.words()}.")
    lines += [f"{'Warning' if found.severity == 'warning' else 'Note'}: {found.sentence} [{found.code}]" for found in result.health.findings]
    return lines


def _numbers(views: Sequence[int]) -> str:
    return ", ".join(str(view + 1) for view in views)


def _warn(console: Console, runner: ScanRunner, told: set[str]) -> None:
    """Say at once what the health monitor notices, each cause once; the summary gives the final figures."""
    for finding in runner.status().findings:
        if finding.code not in told and finding.severity == "warning":
            told.add(finding.code)
            console.clear()
            console.say(f"{finding.sentence} [{finding.code}]")


def _show(console: Console, runner: ScanRunner) -> None:
    status = runner.status()
    if status.state is ScanState.PREPARING:
        done = status.counts.measured + sum(status.counts.rejected.values())
        console.progress("locate", done / max(status.counts.planned, 1), None, f"view {status.view + 1} of {status.views}")
    elif status.state is ScanState.SCANNING:
        left = status.seconds_left
        fraction = 0.0 if left is None else status.seconds / max(status.seconds + left, 1e-9)
        steering = status.steering
        phase = "scan" if steering is None else "compute" if steering.computing else f"pass {steering.number}"
        told = f"{status.counts.measured} points, view {status.view + 1} of {status.views}"
        if steering is not None and steering.within is not None:
            told += f", {100 * steering.within:.0f} % within {steering.wanted_um:g} um"
        console.progress(phase, fraction, left, told)
    elif status.state is ScanState.FINISHING:
        console.progress("register", 1.0, None, "")
