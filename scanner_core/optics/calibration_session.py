"""A calibration from start to end: board in the volume, known length, board on the table, judgement.

Somebody has to show the board: a person who is prompted, or the virtual bench.  Both are a :class:`BoardOperator`.
Every look at the board is told (:class:`~scanner_core.optics.board_watch.BoardWatch`), so that the person sees at once what
is wrong and what is still wanted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.camera import Camera
from scanner_core.devices.motion import MotionController
from scanner_core.errors import CalibrationError, DeviceTimeoutError
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress
from scanner_core.optics.board import CharucoTarget, LengthBar
from scanner_core.optics.board_coverage import CoverageSoFar, judge, moved_px
from scanner_core.optics.board_detection import detect_board
from scanner_core.optics.board_exposure import BoardExposure
from scanner_core.optics.board_watch import BoardWatch, CameraSighting, OnBoardWatch, Phase, ViewVerdict, sighting
from scanner_core.optics.calibration import VALID_DAYS, ScaleReference, StereoCalibration
from scanner_core.optics.calibration_change import compare_calibrations
from scanner_core.optics.calibration_modes import joint_modes, stereo_steps
from scanner_core.optics.calibration_result import CalibrationResult
from scanner_core.optics.length_scale import MAX_RATIO, UNVERIFIED_PPM, BarScale, scale_by_bar
from scanner_core.optics.stereo_calibration import MIN_VIEWS, StereoCalibrationFit, calibrate_stereo
from scanner_core.optics.stereo_view import StereoView
from scanner_core.optics.turntable_calibration import TableView, calibrate_turntable

VIEWS = 25
"""Twenty for the fit and five held out: more views improve it little."""
BAR_VIEWS = 8
"""Four that set the scale and four that judge it."""
TABLE_ANGLES = 12
STILL_PX = 0.3
"""Two looks at a board that differ by less in the median show it at rest."""
LYING_LOOKS = 8
"""Looks for which a person's board must lie still on the table: a hand does not keep it so."""
PATIENCE_LOOKS = 3000
"""Looks without a view before a person is given up."""
SETTLING_LOOKS = 20
"""Looks for which a board on a table that has turned may tremble, where nobody says that it rests."""

_MISSED_FRAMES = 2
"""Frames in a row that may fail to come."""
_SHOW, _BAR, _FIT, _TABLE = 0.50, 0.68, 0.72, 1.0
"""Parts of the whole at which showing the board, showing the bar, fitting and turning the table end."""


class BoardOperator(Protocol):
    """Who shows board and bar.

    `by_hand` False: every call returns when the thing is at rest, and what the cameras see then is the view.
    `by_hand` True: the call asks a person and returns at once; a view is taken by itself as soon as the board is at rest and
    differs from all earlier ones.
    """

    @property
    def by_hand(self) -> bool: ...

    def show(self, index: int, count: int) -> None:
        """Hold the board into the volume, at a place and tilt of its own for every `index` from 0 to `count` - 1."""
        ...

    def show_bar(self, index: int, count: int) -> None:
        """Hold the length bar into the volume, likewise; both of its ends in sight of both cameras."""
        ...

    def lay_on_table(self) -> None:
        """Lay the board flat on the table, face up, about its middle."""
        ...

    def remove(self) -> None:
        """Take away what is there."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Person:
    """A board operator who is asked by `say`, a sentence at a time."""

    say: Callable[[str], None]
    by_hand: bool = True

    def show(self, index: int, count: int) -> None:
        self.say(f"Hold the board into the volume, tilted otherwise than before, and keep it still ({index + 1} of {count}).")

    def show_bar(self, index: int, count: int) -> None:
        self.say(f"Hold the length bar into the volume, both ends in sight, and keep it still ({index + 1} of {count}).")

    def lay_on_table(self) -> None:
        self.say("Lay the board flat on the table, face up, about its middle, and take your hands away.")

    def remove(self) -> None:
        self.say("Take the board away.")


@dataclass(frozen=True, slots=True)
class CalibrationSettings:
    """What a calibration goes by.

    Attributes
    ----------
    bar : the certified length, or None when there is none
    measured_width_mm, measured_uncertainty_mm : the print's whole row of squares, outer edge to outer edge, by a caliper (the
        page says so), or None; it sets the scale when there is no bar
    views, bar_views, table_angles : how often board and bar are shown, and at how many angles the table is stopped
    board_thickness_mm : from the table's surface to the printed face
    valid_days : how long the calibration may be used
    """

    bar: LengthBar | None = None
    measured_width_mm: float | None = None
    measured_uncertainty_mm: float = 0.05
    views: int = VIEWS
    bar_views: int = BAR_VIEWS
    table_angles: int = TABLE_ANGLES
    board_thickness_mm: float = 0.0
    valid_days: float = VALID_DAYS


def run_calibration(
    left: Camera,
    right: Camera,
    motion: MotionController,
    operator: BoardOperator,
    target: CharucoTarget,
    settings: CalibrationSettings | None = None,
    *,
    date: str,
    previous: StereoCalibration | None = None,
    progress: OnProgress | None = None,
    watch: OnBoardWatch | None = None,
    cancelled: IsCancelled | None = None,
) -> CalibrationResult:
    """Calibrate a rig: both cameras, their scale and the turntable's axis.

    The laser stays off.  The table ends where it began.

    Parameters
    ----------
    target : the board as it was drawn
    date : ISO 8601, kept with the result
    previous : the calibration in use, which the new one is compared with
    watch : is told every look at the board

    Raises
    ------
    CalibrationError
        E-CAL-01 when there is no calibration, E-CAL-03 when it was not accepted, each with the reason; E-CAL-04 wrong squares,
        E-CAL-05 exchanged cameras.
    DeviceError
        From the cameras or the controller.
    Cancelled
        When `cancelled` said so.
    """
    session = _Session(left, right, operator, target, settings or CalibrationSettings(), previous, progress, watch, cancelled)
    motion.laser(False)
    try:
        fit, scale = session.show_board(), None
        if session.settings.bar is not None:
            scale = session.show_bar(fit, session.settings.bar)
        laid = session.turn_table(motion)
    finally:
        session.end()
    return session.result(fit, scale, laid, date)


@dataclass(frozen=True, slots=True, eq=False)
class _Shown:
    """What is before the cameras, and which of its corners both must see (none in particular when empty)."""

    target: CharucoTarget
    phase: Phase
    rest_looks: int = 1
    """How many looks must find it where the one before did, when a person shows it."""
    needed: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64))


class _Session:
    """The steps, and what they have in common."""

    def __init__(
        self,
        left: Camera,
        right: Camera,
        operator: BoardOperator,
        target: CharucoTarget,
        settings: CalibrationSettings,
        previous: StereoCalibration | None,
        progress: OnProgress | None,
        watch: OnBoardWatch | None,
        cancelled: IsCancelled | None,
    ) -> None:
        self._cameras, self._operator, self._target, self.settings, self._previous = (left, right), operator, target, settings, previous
        self._tell, self._watch, self._cancelled = progress, watch, cancelled
        self._misses: Counter[str] = Counter()
        self._covered = CoverageSoFar(target, left.size_px, settings.views, None if previous is None else previous.left)
        self._exposure = BoardExposure(self._cameras) if operator.by_hand else None

    def end(self) -> None:
        """Nothing more is looked at: the board may be taken away, and the cameras are as they were."""
        try:
            self._operator.remove()
        finally:
            if self._exposure is not None:
                self._exposure.restore()

    # ------------------------------------------------------------------------------------------ steps
    def show_board(self) -> StereoCalibrationFit:
        """The board held into the volume, and the cameras fitted to it."""
        for index in range(self.settings.views):
            self._go_on(_SHOW * index / self.settings.views)
            self._operator.show(index, self.settings.views)
            self._take(_Shown(self._target, Phase.BOARD), index, self.settings.views, self._covered.views)
        self._go_on(_SHOW)
        views = self._covered.views
        if len(views) < MIN_VIEWS and self._misses[ViewVerdict.TOO_SIMILAR.value] > self.settings.views // 2:
            raise CalibrationError("E-CAL-01", reason=f"the board was never moved: {len(views)} of {self.settings.views} views differ")
        try:
            return calibrate_stereo(views, self._cameras[0].size_px, self._target)
        except CalibrationError as fault:
            raise self._with_misses(fault) from fault

    def show_bar(self, fit: StereoCalibrationFit, bar: LengthBar) -> BarScale:
        """The known length held into the volume."""
        self._misses.clear()
        views: list[StereoView] = []
        for index in range(self.settings.bar_views):
            self._go_on(_SHOW + (_BAR - _SHOW) * index / self.settings.bar_views)
            self._operator.show_bar(index, self.settings.bar_views)
            self._take(_Shown(bar.plate, Phase.BAR, needed=np.concatenate(bar.groups())), index, self.settings.bar_views, views)
        try:
            return scale_by_bar(fit, views, bar, self._target)
        except CalibrationError as fault:
            raise self._with_misses(fault) from fault

    def turn_table(self, motion: MotionController) -> list[TableView]:
        """The board on the table at all angles."""
        self._operator.lay_on_table()
        self._misses.clear()
        began_deg = motion.status().table_deg
        laid: list[TableView] = []
        for index in range(self.settings.table_angles):
            self._go_on(_FIT + (_TABLE - _FIT) * index / self.settings.table_angles)
            motion.rotate_to(began_deg + 360.0 * index / self.settings.table_angles)
            # The first view awaits a board that is not where a hand has held it, and that lies still for a while.
            taken = list(self._covered.views) if self._operator.by_hand and index == 0 else []
            known = len(taken)
            lying = _Shown(self._target, Phase.TABLE, LYING_LOOKS)
            shown = lying if index == 0 else _Shown(self._target, Phase.TABLE)
            self._take(shown, index, self.settings.table_angles, taken, turned=index > 0)
            laid += [TableView(motion.status().table_deg, view) for view in taken[known:]]
        motion.rotate_to(began_deg)
        return laid

    def result(self, fit: StereoCalibrationFit, scale: BarScale | None, laid: list[TableView], date: str) -> CalibrationResult:
        """Scale, axis, uncertainty, and what has changed."""
        settings = self.settings
        factor, reference = (scale.factor, scale.reference) if scale is not None else self._scale_of_print()
        fit = fit.scaled(factor)
        steps = stereo_steps(fit, [] if scale is None else scale.fitted, settings.bar)
        try:
            axis = calibrate_turntable(fit, laid, self._target, board_thickness_mm=settings.board_thickness_mm, steps=steps)
        except CalibrationError as fault:
            raise self._with_misses(fault) from fault
        calibration = replace(fit.with_turntable(axis.axis, date), scale=reference, valid_days=settings.valid_days)
        calibration = replace(calibration, modes=joint_modes(calibration, steps, axis, reference.uncertainty_ppm))
        change = None if self._previous is None else compare_calibrations(self._previous, calibration)
        if self._tell is not None:
            self._tell(Progress("calibrate", 1.0))
        return CalibrationResult(calibration, fit, axis, change)

    def _scale_of_print(self) -> tuple[float, ScaleReference]:
        measured_mm = self.settings.measured_width_mm
        if measured_mm is None:
            return 1.0, ScaleReference("none", 0.0, UNVERIFIED_PPM, 1.0)
        factor = measured_mm / self._target.size_mm[0]
        if abs(factor - 1) > MAX_RATIO:
            reason = f"the print measures {measured_mm:.2f} mm where {self._target.size_mm[0]:.2f} mm was drawn; give the size of its squares"
            raise CalibrationError("E-CAL-01", reason=reason)
        return factor, ScaleReference("print", measured_mm, 1e6 * self.settings.measured_uncertainty_mm / measured_mm, factor)

    # ------------------------------------------------------------------------------------------ looks
    def _go_on(self, fraction: float) -> None:
        if self._cancelled is not None and self._cancelled():
            raise Cancelled
        if self._tell is not None:
            self._tell(Progress("calibrate", fraction))

    def _take(self, what: _Shown, index: int, count: int, taken: list[StereoView], *, turned: bool = False) -> None:
        """Add a view to `taken`; where a person shows the board it is awaited until it is new and at rest, anything else is looked at once.

        A person is given up after :data:`PATIENCE_LOOKS` (E-CAL-01).  A board that the table has `turned` is nobody's to bring: where it
        does not come to rest in sight, that angle is left out.
        """
        waits = self._operator.by_hand
        before: StereoView | None = None
        still = 0
        for _ in range((SETTLING_LOOKS if turned else PATIENCE_LOOKS) if waits else 1):
            left, right = (detect_board(self._look(camera), what.target) for camera in (0, 1))
            judged = judge(left, right, taken, self._cameras[0].size_px[0], what.needed)
            view = judged if isinstance(judged, StereoView) else None
            verdict = ViewVerdict.TAKEN if view is not None else judged
            if view is not None and waits:
                still = still + 1 if before is not None and moved_px(view, before) < STILL_PX else 0
                verdict = ViewVerdict.TAKEN if still >= what.rest_looks else ViewVerdict.MOVING
            before = view
            if view is not None and verdict is ViewVerdict.TAKEN:
                taken.append(view)
            if self._watch is not None and isinstance(verdict, ViewVerdict):
                self._watch(self._watched(what.phase, index, count, sighting(left), sighting(right), verdict))
            if verdict is ViewVerdict.TAKEN:
                return
            if waits and self._cancelled is not None and self._cancelled():
                raise Cancelled
        if waits and not turned:
            raise CalibrationError("E-CAL-01", reason="no new view of the board at rest for a long time")
        self._misses.update({seen.reason.value for seen in (sighting(left), sighting(right)) if seen.reason is not None})
        if isinstance(verdict, ViewVerdict) and verdict is not ViewVerdict.MISSED:
            self._misses[verdict.value] += 1

    def _look(self, camera: int) -> NDArray[np.uint8]:
        """A frame; what a person has shown so far is worth asking a camera again that has missed one."""
        for _ in range(_MISSED_FRAMES if self._operator.by_hand else 0):
            with suppress(DeviceTimeoutError):
                image = self._cameras[camera].grab().image
                break
        else:
            image = self._cameras[camera].grab().image
        if self._exposure is not None:
            self._exposure.adapt(camera, image)
        return image

    def _watched(self, phase: Phase, index: int, count: int, left: CameraSighting, right: CameraSighting, verdict: ViewVerdict) -> BoardWatch:
        tilt_deg, distance_mm = self._covered.spread()
        wishes = self._covered.wishes(tilt_deg, distance_mm) if phase is Phase.BOARD else ()
        grids = self._covered.grid("left"), self._covered.grid("right")
        return BoardWatch(phase, index, count, left, right, verdict, *grids, tilt_deg, distance_mm, wishes)

    def _with_misses(self, fault: CalibrationError) -> CalibrationError:
        """The same refusal, telling also why views were not used."""
        if not self._misses:
            return fault
        why = ", ".join(f"{count} views {reason.replace('_', ' ')}" for reason, count in self._misses.most_common())
        return CalibrationError(fault.code, details=fault.details, reason=f"{fault.fields['reason']} ({why})")
