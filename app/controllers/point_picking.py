"""Three points that a person picks on each surface, in the same order, where the program does not find the alignment."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.comparison_draft import NO_PICKS, ComparisonDraft, Picks, Point
from app.controllers.surface_reading import Role
from scanner_core.geometry.rigid import RigidTransform

POINTS = 3


class PointPicking(QObject):
    """The points are part of the choice, and so undone one by one; the third pair starts the comparison anew."""

    changed = Signal()

    def __init__(self, background: Background, draft: ComparisonDraft, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._draft, self._tell = background, draft, tell
        self._shown = (False, draft.choice.picks)
        draft.changed.connect(self._look)

    @property
    def active(self) -> bool:
        """Points are being picked."""
        choice = self._draft.choice
        return choice.picking and choice.before is not None and choice.after is not None

    def begin(self) -> None:
        """From the first point on; those of the last time are forgotten, what they have led to stays until there are new ones."""
        self._draft.edit("points", picking=True, picks=NO_PICKS)

    def end(self) -> None:
        """Without a result."""
        self._draft.edit("unpick", picking=False, picks=NO_PICKS)

    def pick(self, role: Role, point: Point) -> None:
        """The next point of a surface, mm in its own frame; more than three are not taken."""
        known = before, after = self._draft.choice.picks
        picks: Picks = ((*before, point), after) if role == "before" else (before, (*after, point))
        if not self.active or max(map(len, picks)) > POINTS:
            return
        if all(len(points) == POINTS for points in picks):  # the last one and what it leads to are one step
            work, done = partial(_transform, picks), partial(self._take, known, picks)
            self._background.run("picked-points", work, done, partial(self._refused, known))
        else:
            self._draft.edit("points", picks=picks)

    # -------------------------------------------------------------------------------- inside
    def _take(self, known: Picks, picks: Picks, start: RigidTransform) -> None:
        if self._wanted(known):
            self._draft.edit("points", picking=False, picks=picks, start=start)

    def _refused(self, known: Picks, fault: Exception) -> None:
        if self._wanted(known):
            self._tell(fault)
            self.begin()

    def _wanted(self, known: Picks) -> bool:
        """Nobody has cancelled, undone or picked another one meanwhile."""
        return self.active and known is self._draft.choice.picks

    def _look(self) -> None:
        shown = (self.active, self._draft.choice.picks)
        if shown != self._shown:
            self._shown = shown
            self.changed.emit()


def _transform(picks: Picks) -> RigidTransform:
    from scanner_core.comparison.picked_points import transform_from_picked

    return transform_from_picked(*picks)
