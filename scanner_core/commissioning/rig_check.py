"""Does a rig do what it is told?  Judged by what its cameras see.

Of the machine and of the calibration's age :func:`~scanner_core.commissioning.machine.check_machine` and
:func:`~scanner_core.commissioning.calibration_check.check_calibration` tell: they need no open rig.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.exposing import propose_for_rig
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commissioning.axis_checks import check_beam_axis, check_table, unjudged_table
from scanner_core.commissioning.beam_axes import AxisMotion, measure_axis
from scanner_core.commissioning.camera_checks import check_camera
from scanner_core.commissioning.difference import picture
from scanner_core.commissioning.frame_rates import check_rate, measure_rates
from scanner_core.commissioning.laser_seen import LaserSeen, see_laser
from scanner_core.commissioning.object_turn import measure_table_by_object
from scanner_core.commissioning.rig_findings import AxisFinding, CameraFinding, RigFindings
from scanner_core.commissioning.sides import exchanged, pairs_of
from scanner_core.commissioning.sighting import Place, sight
from scanner_core.commissioning.skew_check import check_skew
from scanner_core.commissioning.spot_checks import check_spot, judge_exposure
from scanner_core.commissioning.table_turn import board_in_sight, measure_table
from scanner_core.commissioning.trigger_skew import measure_skew
from scanner_core.devices.check import Check
from scanner_core.errors import DeviceError
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.optics.auto_exposure import ExposureVerdict
from scanner_core.remedies import remedy_of

STEPS = ("controller", "cameras", "frame rate", "laser seen", "beam axes", "left and right", "trigger skew", "laser spot", "exposure", "table")
"""Phases of the progress in their order; ``done`` follows.  A step that fails gives a check of its name."""
_REST = "rest of the rig"
LINES = (
    *("controller handshake", "controller move", "controller laser", "controller laser left off"),
    *("camera left", "camera right", "frame rate left", "frame rate right"),
    *("beam axis x", "beam axis y"),
    *STEPS,
    _REST,
)
"""Names of all the checks that can be told, for whoever translates them."""
_GRID_DEG = (-1.8, -0.9, 0.0, 0.9, 1.8)


@dataclass(frozen=True, slots=True, eq=False)
class RigCheck:
    """One check's outcome and what was seen.

    Attributes
    ----------
    check : the line
    pictures : (h, w) uint8 by name: ``left`` and ``right``, or ``left dark``, ``left lit``, ``left difference`` and so on
    values : for JSON
    spots_px : where in a picture the spot was found, (x, y), by the picture's name
    """

    check: Check
    pictures: Mapping[str, NDArray[np.uint8]] = field(default_factory=dict)
    values: Mapping[str, object] = field(default_factory=dict)
    spots_px: Mapping[str, tuple[float, float]] = field(default_factory=dict)


OnRigCheck = Callable[[RigCheck], None]


def check_rig(rig: OpenRig, *, progress: OnProgress, cancelled: IsCancelled, on_check: OnRigCheck) -> RigFindings:
    """Every check of an open rig, each told by `on_check` when it is made; the laser is off after each, whatever happens.

    A device that fails ends the checks with its line and one for what was not checked, not with an error.

    Raises
    ------
    Cancelled
        The laser is off.
    """
    run = _Run(rig, cancelled, on_check)
    made = (run.controller, run.cameras, run.rates, run.laser, run.beam, run.sides, run.skew, run.spot, run.exposure, run.table)
    for number, (name, step) in enumerate(zip(STEPS, made, strict=True)):
        if cancelled():
            raise Cancelled
        progress(Progress(name, number / len(STEPS)))
        try:
            step()
        except DeviceError as error:
            on_check(RigCheck(Check(name, "fail", error.message, remedy_of(error))))
            run.failed = True
        finally:
            _darken(rig)
        if run.failed:
            rest = ", ".join(STEPS[number + 1 :])
            if rest:
                on_check(RigCheck(Check(_REST, "warn", f"not checked: {rest}.", "Repair what failed, then check again.")))
            break
    progress(Progress("done", 1.0))
    return run.findings


def _darken(rig: OpenRig) -> None:
    try:
        rig.motion.laser(False)
    except DeviceError:  # the controller failed, and its driver has reset it; once more does no harm
        with suppress(DeviceError):
            rig.motion.stop()


class _Run:
    """The checks of one rig in their order, and what they have found so far."""

    def __init__(self, rig: OpenRig, cancelled: IsCancelled, on_check: OnRigCheck) -> None:
        self._rig, self._cancelled, self._tell = rig, cancelled, on_check
        self.findings = RigFindings({"left": CameraFinding(), "right": CameraFinding()})
        self.failed = False
        self._seen: LaserSeen | None = None
        self._motions: list[AxisMotion] = []

    # ------------------------------------------------------------------------------------------ devices
    def controller(self) -> None:
        for check in self._rig.motion.self_checks():
            self._tell(RigCheck(check))

    def cameras(self) -> None:
        for camera in (self._rig.left, self._rig.right):
            try:
                check, values, image = check_camera(camera)
            except DeviceError as error:  # the other camera is looked at all the same
                self._tell(RigCheck(Check(f"camera {camera.name}", "fail", error.message, remedy_of(error)), values={"name": camera.name}))
                self.failed = True
                continue
            self._tell(RigCheck(check, {camera.name: image}, values))

    def rates(self) -> None:
        for name, rate in measure_rates(self._rig, self._cancelled).items():
            self._tell(RigCheck(check_rate(name, rate)))
            self._camera(name, replace(self._found(name), rate_hz=rate.rate_hz, wanted_hz=rate.wanted_hz, dropped=rate.missing))

    # ------------------------------------------------------------------------------------------ laser and beam
    def laser(self) -> None:
        self._seen = seen = see_laser(self._rig, self._cancelled)
        kinds = ("lit", "difference")
        places = {f"{name} {kind}": (spot.x_px, spot.y_px) for name, spot in seen.sighting.spots.items() for kind in kinds if spot is not None}
        self._tell(RigCheck(seen.check, seen.pictures, spots_px=places))
        self.findings = replace(self.findings, laser_left_off=seen.left_off)
        for name, spot in seen.sighting.spots.items():
            self._camera(name, replace(self._found(name), laser_seen=spot is not None, background_dn=float(seen.dark[name].mean())))
            if spot is not None:
                self._camera(name, replace(self._found(name), spot_px=(spot.x_px, spot.y_px), spot_dn=spot.peak_dn))

    def beam(self) -> None:
        seen = self._seen
        if seen is None or seen.sighting.count == 0:
            return
        for axis in ("x", "y"):
            motion = measure_axis(self._rig, seen.dark, axis, seen.sighting.place, self._cancelled)
            self._motions.append(motion)
            ends = [s for s in (motion.sightings[0], motion.sightings[-1])] if motion.sightings else []
            pictures = {f"{name} {end}": picture(s.lit[name]) for end, s in zip(("low", "high"), ends, strict=False) for name in s.lit}
            places = {
                f"{name} {end}": (spot.x_px, spot.y_px)
                for end, s in zip(("low", "high"), ends, strict=False)
                for name, spot in s.spots.items()
                if spot is not None
            }
            self._tell(RigCheck(check_beam_axis(motion), pictures, spots_px=places))
            self._axis(motion.finding)

    def sides(self) -> None:
        seen = self._seen
        if seen is None or not seen.sighting.seen_by_both:
            return
        sightings = [sighting for motion in self._motions for sighting in motion.sightings]
        if self._rig.calibration is None:
            x_deg, y_deg = seen.sighting.place
            for dx, dy in itertools.product(_GRID_DEG, _GRID_DEG):
                if self._cancelled():
                    raise Cancelled
                sightings.append(sight(self._rig, seen.dark, self._within((x_deg + dx, y_deg + dy)), 1))
        told = exchanged(*pairs_of(sightings), self._rig.left.size_px, self._rig.calibration)
        self.findings = replace(self.findings, exchanged=told)
        name, remedy = "left and right", "Exchange the two cameras in the rig file, then calibrate."
        if told is None:
            detail = "which camera stands to the left cannot be told from this object."
            self._tell(RigCheck(Check(name, "warn", detail, "Cover one lens with your hand and see which picture darkens.")))
        elif told:
            self._tell(RigCheck(Check(name, "fail", "the cameras are exchanged: the one called left stands to the right.", remedy)))
        else:
            self._tell(RigCheck(Check(name, "pass", "each camera stands on the side that it is named after.")))

    def skew(self) -> None:
        seen = self._seen
        if seen is None or not seen.sighting.seen_by_both:
            return
        skew = measure_skew(self._rig, seen.sighting.place, self._cancelled)
        self._tell(RigCheck(check_skew(skew, self._rig.config)))
        if skew is not None:
            self.findings = replace(self.findings, skew_ms=skew.skew_ms, skew_uncertainty_ms=skew.uncertainty_ms)

    def spot(self) -> None:
        self._tell(RigCheck(check_spot(self._rig)))

    def exposure(self) -> None:
        results = propose_for_rig(self._rig)
        self._tell(RigCheck(judge_exposure(results)))
        for name, result in results.items():
            best = result.readings[-1]
            if result.verdict is ExposureVerdict.GOOD and best.exposure_ms > 0:
                self._camera(name, replace(self._found(name), exposure_ms=best.exposure_ms, gain_db=best.gain_db))

    # ------------------------------------------------------------------------------------------ table
    def table(self) -> None:
        if board_in_sight(self._rig):
            finding, means = measure_table(self._rig, self._cancelled), "the board on it"
        elif self._seen is not None and self._seen.sighting.seen_by_both and self._rig.calibration is not None:
            finding, means = measure_table_by_object(self._rig, self._seen.sighting.place, self._cancelled), "the object on it"
        else:
            finding, means = None, ""
        self._tell(RigCheck(unjudged_table(means) if finding is None else check_table(finding, means)))
        if finding is not None:
            self._axis(finding)

    # ------------------------------------------------------------------------------------------ inside
    def _within(self, place: Place) -> Place:
        (x_low, x_high), (y_low, y_high) = self._rig.config.limits.x_deg, self._rig.config.limits.y_deg
        return min(max(place[0], x_low), x_high), min(max(place[1], y_low), y_high)

    def _axis(self, finding: AxisFinding) -> None:
        self.findings = replace(self.findings, axes={**self.findings.axes, finding.axis: finding})

    def _found(self, name: str) -> CameraFinding:
        return self.findings.cameras[name]

    def _camera(self, name: str, finding: CameraFinding) -> None:
        self.findings = replace(self.findings, cameras={**self.findings.cameras, name: finding})
