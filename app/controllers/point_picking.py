"""Three points that a person picks on each surface, in the same order, where the program does not find the alignment."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.comparison_draft import ComparisonDraft, Picks, Point
from app.controllers.surface_reading import Role
from scanner_core.geometry.rigid import RigidTransform

POINTS = 3


class PointPicking(QObject):
    """The points are part of the choice, and so undone one by one; the third pair starts the comparison anew."""

    changed = Signal()

    def __init__(self, background: Background, draft: ComparisonDraft, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._draft, self._tell = background, draft, tell
        self._begun = False
        draft.changed.connect(self._look)

    @property
    def active(self) -> bool:
        """Points are being picked."""
        choice = self._draft.choice
        return self._begun and choice.before is not None and choice.after is not None

    def begin(self) -> None:
        """From the first point on; those of the last time are forgotten."""
        self._draft.edit("points", picks=((), ()), start=None)
        self._begun = True
        self.changed.emit()

    def end(self) -> None:
        """Without a result."""
        self._begun = False
        self.changed.emit()

    def pick(self, role: Role, point: Point) -> None:
        """The next point of a surface, mm in its own frame; more than three are not taken."""
        before, after = self._draft.choice.picks
        picks: Picks = ((*before, point), after) if role == "before" else (before, (*after, point))
        if not self.active or max(map(len, picks)) > POINTS:
            return
        self._draft.edit("points", picks=picks)
        if all(len(points) == POINTS for points in picks):
            self._background.run("picked-points", lambda: _transform(picks), lambda start: self._take(picks, start), self._refused)

    # -------------------------------------------------------------------------------- inside
    def _take(self, picks: Picks, start: RigidTransform) -> None:
        if picks is self._draft.choice.picks:
            self._begun = False
            self._draft.edit("points", start=start)
            self.changed.emit()

    def _refused(self, fault: Exception) -> None:
        self._tell(fault)
        self.begin()

    def _look(self) -> None:
        """Undo has come back among the points, or the surfaces are others."""
        count = sum(map(len, self._draft.choice.picks))
        if 0 < count < 2 * POINTS:
            self._begun = True
        elif self._draft.choice.start is not None:
            self._begun = False
        self.changed.emit()


def _transform(picks: Picks) -> RigidTransform:
    from scanner_core.comparison.picked_points import transform_from_picked

    return transform_from_picked(*picks)
