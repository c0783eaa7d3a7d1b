"""Three points that a person picks on a mount and on those that were joined, where the program does not find how it lies."""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from app.controllers.mounts import MountsController

POINTS: Final = 3
Point = tuple[float, float, float]
Side = Literal["fixed", "moving"]
Picked = tuple[tuple[Point, ...], tuple[Point, ...]]
NONE: Picked = ((), ())


class MountPicks(QObject):
    """Each point is a step that can be undone; the third pair has the mounts registered from there."""

    changed = Signal()

    def __init__(self, stack: QUndoStack, mounts: MountsController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stack, self._mounts = stack, mounts
        self.mount: int | None = None
        """The one that is picked on."""
        self.picked: Picked = NONE
        """On those that were joined, in the frame of the first, and on the mount, in its own; mm."""
        mounts.changed.connect(self._look)

    def begin(self) -> None:
        """From the first point on, for the mount that was refused."""
        refused = self._mounts.refused
        mount = None if refused is None else refused.mount
        if mount != self.mount:
            self.mount = mount
            self.put(NONE)

    def pick(self, side: Side, point: Point) -> None:
        """The next point of a cloud; more than three are not taken."""
        fixed, moving = self.picked
        if self.mount is None or self._mounts.running or len(fixed if side == "fixed" else moving) >= POINTS:
            return
        self._edit(((*fixed, point), moving) if side == "fixed" else (fixed, (*moving, point)))
        fixed, moving = self.picked
        if len(fixed) == len(moving) == POINTS:
            self._mounts.register({self.mount: (np.array(moving), np.array(fixed))})

    def start_again(self) -> None:
        """Forget all points; that can be undone, too."""
        if self.picked != NONE:
            self._edit(NONE)

    def put(self, picked: Picked) -> None:
        """Set without a way back; the undo commands use it."""
        self.picked = picked
        self.changed.emit()

    # -------------------------------------------------------------------------------- inside
    def _edit(self, picked: Picked) -> None:
        self._stack.push(_Pick(self, self.mount, self.picked, picked))

    def _look(self) -> None:
        """Another case, or the mount was joined."""
        refused = self._mounts.refused
        if not self._mounts.running and (refused is None or refused.mount != self.mount):
            self.mount, self.picked = None, NONE
        self.changed.emit()


class _Pick(QUndoCommand):
    """One point; after the mount was joined it changes nothing."""

    def __init__(self, picks: MountPicks, mount: int | None, old: Picked, new: Picked) -> None:
        super().__init__(QCoreApplication.translate("mounts", "Pick a point on a mount"))
        self._picks, self._mount, self._old, self._new = picks, mount, old, new

    def redo(self) -> None:
        self._put(self._new)

    def undo(self) -> None:
        self._put(self._old)

    def _put(self, picked: Picked) -> None:
        if self._picks.mount == self._mount:
            self._picks.put(picked)
