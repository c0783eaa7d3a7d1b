"""Watches the views of a scan: does each lie on the surface that the earlier ones have shown, and does the turn close?

A camera that moved along the epipolar lines leaves no epipolar residual, and lost steps of the table none either; both
move whole views.  The motion of a view against the merged earlier ones is compared with its uncertainty: the points'
scatter and, in quadrature, a part of what the calibration leaves (half its held-out error: two views see the same place
at different places of the volume, but not at opposite ends of it), because that never averages out.

A view in which a step shows may hold points from before and after, so the next one measures it.  From then on views are
brought back before they are compared, so that one cause is named once.  The step may stay with
the cameras (their view of the table is shifted alike at every angle) or with the object (it is shifted alike in its own
frame): the first view in which the two differ tells them apart.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.jump import locate_jump
from scanner_core.acquisition.view_motion import MIN_POINTS, ViewMotion, paired_motion, view_motion
from scanner_core.geometry.local_surface import reference_surface
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]
Cause = Literal["unknown", "camera", "object", "table"]

SIGNIFICANT = 45.0
"""Chi-square of a motion that is named: exceeded by chance once in 2e7 views for six directions."""
LEAST_SHIFT_UM = 20.0
TURN_SIGMAS = 5.0
"""A turn about the table's axis is named from so many standard uncertainties on."""
LEAST_TURN_DEG = 0.01
_OF_HELD_OUT = 0.5
_BROUGHT_BACK = 0.2
"""A step is known to a fifth of itself, which later views inherit."""
_CLOSURE_SIGMAS = 4.0
"""Of a turn at the end: there is one in a scan."""
_WORST_TURN_DEG = 0.2
"""A closure that is known no better says nothing."""
_CLOSURE_SYSTEMATIC_MM = 1e-3
"""Between two measurements of the same surface at the same table angle."""
_EXPLAINED = 0.9
_ROUND_MM = 2.0
_ENOUGH = 6000
"""Points of the earlier surface; more cost time and tell no more."""
_CLOSURE_EXPLAINED = 0.6
_DECIDED = 9.0
"""Difference of chi-square between two explanations that decides."""


@dataclass(frozen=True, slots=True)
class ViewStep:
    """A view that does not lie where the earlier ones say.

    Attributes
    ----------
    view, table_deg : the first that is affected
    shift_mm : (3,) of the view's middle, as seen by the cameras (table frame: +x towards them, +z up)
    turn_deg : about the table's axis, of the object against its reading; 0 unless the cause is ``table``
    significance : chi-square
    cause : ``table`` when a turn about the axis explains it all; ``camera`` or ``object`` once a later view has told
    """

    view: int
    table_deg: float
    shift_mm: tuple[float, float, float]
    turn_deg: float
    significance: float
    cause: Cause

    @property
    def shift_um(self) -> float:
        return 1e3 * float(np.linalg.norm(self.shift_mm))


@dataclass(frozen=True, slots=True)
class Closure:
    """The first table position measured again after the turn.

    Attributes
    ----------
    points : that were compared
    judged : whether the object tells a turn about the table's axis; `reason` says why not
    turn_deg, turn_uncertainty_deg : of the object against its first reading; NaN when not judged
    shift_um : of the middle of the points
    closes : nothing has moved, as far as this object tells
    lost_steps : it does not, and a turn of the table explains it
    jumped_at_deg : table angle of the first view beyond the jump, the likeliest; None when none stands out
    jumped_between_deg : the first and the last angle that may be it
    """

    points: int
    judged: bool
    turn_deg: float = float("nan")
    turn_uncertainty_deg: float = float("nan")
    shift_um: float = float("nan")
    closes: bool = True
    lost_steps: bool = False
    jumped_at_deg: float | None = None
    jumped_between_deg: tuple[float, float] | None = None
    reason: str = ""

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        told: dict[str, object] = {"points": self.points, "judged": self.judged, "closes": self.closes, "lost_steps": self.lost_steps}
        if self.judged:
            told |= {"turn_deg": round(self.turn_deg, 4), "turn_uncertainty_deg": round(self.turn_uncertainty_deg, 4)}
        told |= {"shift_um": None if np.isnan(self.shift_um) else round(self.shift_um, 1), "jumped_at_deg": self.jumped_at_deg}
        if self.reason:
            told["reason"] = self.reason
        return told | {"jumped_between_deg": None if self.jumped_between_deg is None else list(self.jumped_between_deg)}


class ViewWatch:
    """The views of one scan in their order; points come in the object frame, mm, as the calibration gives them."""

    def __init__(self, held_out_rms_um: float) -> None:
        self._systematic_mm = _OF_HELD_OUT * 1e-3 * held_out_rms_um
        self._pending = False
        self._for_camera = 0.0
        self._points: list[Array] = []
        self._earlier: list[Array] = []
        self._moves: list[_Move] = []
        self._views: list[tuple[float, Array]] = []
        self.steps: list[ViewStep] = []
        self.compared = 0
        """Views that could be compared with earlier ones."""

    def add(self, points: Array) -> None:
        """Measured points (n, 3) of the view that is being scanned."""
        if len(points):
            self._points.append(points)

    def end_view(self, view: int, table_deg: float) -> bool:
        """The view is complete; True when :attr:`steps` changed."""
        points = np.concatenate(self._points) if self._points else np.empty((0, 3))
        self._points = []
        if len(points) < MIN_POINTS:
            return False
        self._views.append((table_deg, points))
        if not self._earlier:
            self._earlier.append(points)
            return False
        surface = reference_surface(self._near(points))
        tried = [(moves, view_motion(_moved(moves, points, table_deg), surface)) for moves in self._explanations()]
        judged = [(moves, motion) for moves, motion in tried if motion is not None]
        if not judged:
            self._earlier.append(_moved(self._moves, points, table_deg))
            return False
        self.compared += 1
        changed = len(judged) == 2 and self._weigh(judged[0][1], judged[1][1])
        self._moves, motion = judged[len(judged) == 2 and self._for_camera > 0]
        beside = motion.significance(self._systematic_mm) > SIGNIFICANT and 1e3 * float(np.linalg.norm(motion.vector_mm)) > LEAST_SHIFT_UM
        if self._pending:
            self._pending = False
            if beside:
                self._measure(motion, table_deg)
                self._earlier.append(_moved(self._moves, points, table_deg))
                return True
        elif beside:
            self._pending = changed = True
            self.steps.append(self._named(motion, view, table_deg))
            return True
        self._earlier.append(_moved(self._moves, points, table_deg))
        return changed

    def close_turn(self, points: Array, before: Array) -> Closure:
        """Compare points (n, 3) of the first table position, measured again, with the same beams' points `before` (n, 3)."""
        if not self._earlier or len(points) < MIN_POINTS:
            return Closure(len(points), False, reason="too few points were measured again")
        motion = paired_motion(points, before, reference_surface(self._near(before)))
        if motion is None:
            return Closure(len(points), False, reason="the points are too noisy for their spacing")
        shift_um = 1e3 * float(np.linalg.norm(motion.shift_mm))
        closes = motion.significance(_CLOSURE_SYSTEMATIC_MM) < SIGNIFICANT or shift_um < LEAST_SHIFT_UM
        turn = motion.turn_about_z(_CLOSURE_SYSTEMATIC_MM)
        if turn is None:
            return Closure(motion.points, False, shift_um=shift_um, closes=closes, reason="its shape looks the same from every side")
        if np.degrees(turn[1]) > _WORST_TURN_DEG:
            known = f"its shape tells a turn to {np.degrees(turn[1]):.1f} deg only"
            return Closure(motion.points, False, shift_um=shift_um, closes=closes, reason=known)
        turn_deg, uncertainty_deg = -float(np.degrees(turn[0])), float(np.degrees(turn[1]))
        lost = abs(turn_deg) > max(_CLOSURE_SIGMAS * uncertainty_deg, LEAST_TURN_DEG)
        lost = lost and motion.explained_by_turn(turn[0], _CLOSURE_SYSTEMATIC_MM) > _CLOSURE_EXPLAINED
        closes = closes and not lost
        jump = locate_jump([view for _, view in self._views], -turn[0]) if lost else None
        if jump is None:
            return Closure(motion.points, True, turn_deg, uncertainty_deg, shift_um, closes, lost)
        at, earliest, latest = (self._views[i][0] for i in (jump.view, jump.earliest, jump.latest))
        return Closure(motion.points, True, turn_deg, uncertainty_deg, shift_um, closes, lost, at, (earliest, latest))

    # ------------------------------------------------------------------------------------------ inner
    def _near(self, points: Array) -> Array:
        """What earlier views have shown round these points, thinned to what a comparison needs."""
        earlier = np.concatenate(self._earlier)
        low, high = points.min(axis=0) - _ROUND_MM, points.max(axis=0) + _ROUND_MM
        near: Array = earlier[((earlier >= low) & (earlier <= high)).all(axis=1)]
        return near[:: 1 + len(near) // _ENOUGH]

    def _explanations(self) -> list[list[_Move]]:
        """The moves so far with the last one, if nobody knows yet, kept by the object or by the cameras."""
        if self._moves and self.steps[-1].cause == "unknown" and not self._pending:
            *before, last = self._moves
            return [[*before, replace(last, with_camera=False)], [*before, replace(last, with_camera=True)]]
        return [self._moves]

    def _weigh(self, with_object: ViewMotion, with_camera: ViewMotion) -> bool:
        """One more view that fits one explanation better than the other; True when that decides."""
        self._for_camera += with_object.significance(self._systematic_mm) - with_camera.significance(self._systematic_mm)
        if abs(self._for_camera) < _DECIDED:
            return False
        self.steps[-1] = replace(self.steps[-1], cause="camera" if self._for_camera > 0 else "object")
        return True

    def _named(self, motion: ViewMotion, view: int, table_deg: float) -> ViewStep:
        x, y, z = (-RigidTransform.about_z(table_deg).rotate(motion.shift_mm)).tolist()
        turn = motion.turn_about_z(self._systematic_mm)
        cause: Cause = "unknown"
        turn_deg = 0.0
        if turn is not None and abs(turn[0]) > TURN_SIGMAS * turn[1] and motion.explained_by_turn(turn[0], self._systematic_mm) > _EXPLAINED:
            cause, turn_deg = "table", -float(np.degrees(turn[0]))
        return ViewStep(view, table_deg, (x, y, z), turn_deg, motion.significance(self._systematic_mm), cause)

    def _measure(self, motion: ViewMotion, table_deg: float) -> None:
        """The view after the first that was beside: it lies beside as a whole."""
        first, self._for_camera = self.steps[-1], 0.0
        self.steps[-1] = replace(self._named(motion, first.view, table_deg), table_deg=first.table_deg)
        self._moves = [*self._moves, _Move(motion.transform(), table_deg, with_camera=False)]
        self._systematic_mm = float(np.hypot(self._systematic_mm, _BROUGHT_BACK * np.linalg.norm(motion.shift_mm)))


@dataclass(frozen=True, slots=True, eq=False)
class _Move:
    """What brings later views back: `motion` in the object frame as it was at `table_deg`."""

    motion: RigidTransform
    table_deg: float
    with_camera: bool

    def at(self, table_deg: float) -> RigidTransform:
        """In the object frame at another angle: the same, or turned with the cameras round the object."""
        if not self.with_camera:
            return self.motion
        turn = RigidTransform.about_z(self.table_deg - table_deg)
        return turn @ self.motion @ turn.inverse()


def _moved(moves: list[_Move], points: Array, table_deg: float) -> Array:
    for move in moves:
        points = move.at(table_deg).apply(points)
    return points
