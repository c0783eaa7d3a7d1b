"""``impronta verify static | sphere | acceptance``: the metrological tests of a rig, with a certificate."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.commands.artefacts_by_hand import operator_at_terminal
from scanner_core.commands.console import Console
from scanner_core.commands.scanning import (
    age_warnings,
    calibrated_rig,
    faults,
    is_rendered,
    recording,
    recording_warnings,
    rig_path,
    specimen_on_table,
)
from scanner_core.commands.verifying import Bar, Conditions, Outcome, Session, part
from scanner_core.devices.rig import RigConfig
from scanner_core.metrology.acceptance import AcceptanceTest, planned_positions
from scanner_core.metrology.certificate import Occasion, acceptance_certificate, sphere_certificate, static_certificate
from scanner_core.metrology.decision import Characteristic, Verdict
from scanner_core.metrology.placing import ArtefactOperator
from scanner_core.metrology.reference_sphere import Reference, SphereTest
from scanner_core.metrology.static_spot import StaticTest
from scanner_core.metrology.static_statistics import AXES
from scanner_core.virtual.specimens import Specimen


def run(given: argparse.Namespace, console: Console) -> int:
    config, calibration = calibrated_rig(given)
    to_come = faults(given, config)
    measure = _planned(given, config)
    specimen = given.specimen if given.test == "sphere" and is_rendered(config) else None
    conditions = Conditions(tuple(given.without), tuple(given.fault), specimen, given.replay)
    warnings = age_warnings(calibration)
    session = Session.prepare(
        console, config, rig_path(given), calibration, given.test, given.seed, given.out, given.force, conditions=conditions, warnings=warnings
    )
    for warning in warnings:
        console.say(f"Warning: {warning}")
    with open_rig(config, None, given.speed, given.seed, to_come) as rig:
        try:
            with recording(given, rig) as told:
                outcome = measure(rig, operator_at_terminal(rig, console), Bar(console, given.test))
        finally:
            console.clear()
    if told is not None:
        console.say(told.summary())
        warnings += recording_warnings(console, told)
    if outcome.interrupted:
        session.keep_part(outcome)
        return 130
    session.finish(outcome)
    return 3 if outcome.verdict is Verdict.FAIL else 0


def _planned(given: argparse.Namespace, config: RigConfig) -> Callable[[OpenRig, ArtefactOperator | None, Bar], Outcome]:
    """The test that was asked for; wrong usage is refused here, before a folder is made or the rig opened."""
    if given.test == "static":
        return partial(_static, given)
    PlanRequest(given.views, given.points)
    radius = Reference(given.reference_mm, given.reference_uncertainty_mm)
    if given.test == "sphere":
        return partial(_sphere, given, radius, specimen_on_table(given, config) if is_rendered(config) else None)
    spacing = Reference(given.spacing_mm, given.spacing_uncertainty_mm)
    planned_positions(config.volume, radius, spacing, given.positions)
    return partial(_acceptance, given, radius, spacing)


# ------------------------------------------------------------------------------------------ the three tests
def _static(given: argparse.Namespace, rig: OpenRig, operator: ArtefactOperator | None, bar: Bar) -> Outcome:
    test = StaticTest(rig, given.repeats, given.places, operator)
    interrupted = False
    try:
        result = test.run(lambda count: bar.add(count, given.repeats))
    except KeyboardInterrupt:
        interrupted = True
        result = part(test.result)
    sd = [float(value) for value in result.sd_um]
    figures = dict(zip(("sd_x", "sd_y", "sd_z"), sd, strict=True)) | {
        "resolution": result.resolution_um,
        "repeatability": result.repeatability_um,
        "drift": result.drift_length_um,
    }
    spread = dict(zip(("sd_x", "sd_y", "sd_z"), (2 * result.sd_uncertainty_um).tolist(), strict=True))
    words = ", ".join(f"{axis} {value:.2f}" for axis, value in zip(AXES, sd, strict=True))
    summary = [
        f"Static spot, {result.repeats} of {result.planned} repeats at {result.places} places: "
        f"standard deviation {words} um (x depth, y vertical, z lateral).",
        f"Resolution {result.resolution_um:.2f} um, repeatability (4 s) {result.repeatability_um:.1f} um, "
        f"drift {result.drift_length_um:.2f} um over {result.duration_s:.0f} s.",
    ]
    return Outcome(result.as_dict(), summary, figures, spread, {}, None, (), partial(static_certificate, result), interrupted)


def _sphere(
    given: argparse.Namespace, reference: Reference, specimen: Specimen | None, rig: OpenRig, operator: ArtefactOperator | None, bar: Bar
) -> Outcome:
    test = SphereTest(rig, reference, given.points, given.views, operator, specimen=specimen)
    interrupted = False
    try:
        result = test.run(given.acquisitions, bar.to)
    except KeyboardInterrupt:
        interrupted = True
        result = part(test.result, len(test.done))
    summary = [
        f"Reference sphere, {len(result.acquisitions)} acquisitions: mean radius {result.mean_radius_mm:.4f} mm "
        f"(u {1e3 * result.mean_radius_uncertainty_mm:.1f} um) against {result.reference.value_mm:.4f} mm, "
        f"residual {result.residual_rms_um:.1f} um rms, D95 {result.dispersion_um:.1f} um, coverage to {result.coverage_deg:.0f} deg from the top.",
        *_decided(result.characteristics(), result.verdict),
    ]
    if not result.covered and result.verdict is Verdict.UNDECIDED:
        summary.append("The coverage is below what is required, so nothing is proved.")
    parameters = (("Views", f"{given.views} per acquisition"), ("Asked for", f"{given.points} points per acquisition"))
    write = partial(sphere_certificate, result)
    return _judged(result.as_dict(), summary, result.characteristics(), result.verdict, parameters, write, interrupted)


def _acceptance(
    given: argparse.Namespace, radius: Reference, spacing: Reference, rig: OpenRig, operator: ArtefactOperator | None, bar: Bar
) -> Outcome:
    test = AcceptanceTest(rig, radius, spacing, given.points, given.views, operator)
    interrupted = False
    try:
        result = test.run(given.positions, bar.to)
    except KeyboardInterrupt:
        interrupted = True
        result = part(test.result, len(test.done))
    summary = [
        f"Acceptance, {len(result.bars)} positions of the ball bar, {len(result.spheres)} places of a sphere, "
        f"at least {100 * result.coverage_fraction:.0f} % of every sphere covered.",
        *_decided(result.characteristics(), result.verdict),
        *result.notes(),
    ]
    if not result.complete and result.verdict is Verdict.UNDECIDED:
        summary.append("Positions or coverage are less than what is required, so nothing is proved.")
    parameters = (("Views", f"{given.views} per position"), ("Asked for", f"{given.points} points per position"))
    write = partial(acceptance_certificate, result)
    return _judged(result.as_dict(), summary, result.characteristics(), result.verdict, parameters, write, interrupted)


def _judged(
    values: dict[str, object],
    summary: list[str],
    characteristics: tuple[Characteristic, ...],
    verdict: Verdict,
    parameters: tuple[tuple[str, str], ...],
    write: Callable[[Occasion, Path], None],
    interrupted: bool,
) -> Outcome:
    figures = {c.name: c.value_um for c in characteristics}
    uncertainties = {c.name: c.expanded_uncertainty_um for c in characteristics}
    limits = {c.name: c.limit_um for c in characteristics}
    return Outcome(values, summary, figures, uncertainties, limits, verdict, parameters, write, interrupted)


def _decided(characteristics: tuple[Characteristic, ...], verdict: Verdict) -> list[str]:
    lines = []
    for c in characteristics:
        lines.append(f"  {c.words}: {c.value_um:.1f} um, U {c.expanded_uncertainty_um:.1f} um, limit {c.limit_um:g} um: {c.verdict.value}.")
    return [*lines, f"Verdict: {verdict.value}."]
