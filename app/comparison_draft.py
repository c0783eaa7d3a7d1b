"""What a person has chosen for a comparison: surfaces, frame, marks; one frozen value, edited through the undo stack."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from app.translation import QT_TRANSLATE_NOOP
from scanner_core.comparison.parameters import ComparisonParameters, Frame, Jaw
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.rigid import RigidTransform

if TYPE_CHECKING:
    from scanner_core.comparison.arch_frame import ArchFrame

Mask = NDArray[np.bool_]
Point = tuple[float, float, float]
Picks = tuple[tuple[Point, ...], tuple[Point, ...]]
NO_PICKS: Picks = ((), ())


@dataclass(frozen=True, slots=True, eq=False)
class LoadedSurface:
    """One surface as it was read.

    Attributes
    ----------
    path : of its file; None for the mesh of the open case, which was in the window already
    unit : what a person has said; None while the unit is the guess
    arch : its directions, when it is a dental arch
    """

    surface: ComparedSurface
    path: Path | None
    unit: str | None = None
    arch: ArchFrame | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ComparisonChoice:
    """Everything that a person decides.

    Attributes
    ----------
    frame : what is held fixed
    tolerance_um : clinical threshold
    jaw : None until it was said
    mask : (v_after,) what was painted as stable; None without
    picking : points are being picked
    picks : those picked so far on before and on after, each in its own frame, mm
    start : after to before, from three of them; None without
    tooth : (v_after,) bool, the marked tooth; None without
    """

    before: LoadedSurface | None = None
    after: LoadedSurface | None = None
    frame: Frame = Frame.AUTO
    tolerance_um: int = 250
    jaw: Jaw | None = None
    mask: Mask | None = None
    picking: bool = False
    picks: Picks = NO_PICKS
    start: RigidTransform | None = None
    tooth: Mask | None = None

    @property
    def ready(self) -> bool:
        """There are two surfaces, and a painted region where the frame asks for one."""
        return self.before is not None and self.after is not None and (self.frame is not Frame.MASK or self.mask is not None)

    @property
    def parameters(self) -> ComparisonParameters:
        return ComparisonParameters(frame=self.frame, tolerance_um=float(self.tolerance_um), jaw=self.jaw)

    def same_pair(self, other: ComparisonChoice) -> bool:
        """The same two surfaces, the same way round."""
        return self.before is other.before and self.after is other.after

    def same_question(self, other: ComparisonChoice) -> bool:
        """Whether what is measured for one is measured for the other: jaw and threshold only tell it in other terms."""
        return (
            self.same_pair(other)
            and self.frame is other.frame
            and self.start is other.start
            and (self.frame is not Frame.MASK or self.mask is other.mask)
        )


class ComparisonDraft(QObject):
    """The current choice; `changed` after every edit, undo and redo."""

    changed = Signal()

    def __init__(self, stack: QUndoStack, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stack = stack
        self.choice = ComparisonChoice()

    def edit(self, step: str, **values: Any) -> None:
        """A person's edit, a key of STEPS; it can be undone.  Nothing happens when every value is the one that is there."""
        if any(not _same(getattr(self.choice, name), value) for name, value in values.items()):
            self._stack.push(_Edit(self, step, self.choice, replace(self.choice, **values)))

    def put(self, choice: ComparisonChoice) -> None:
        """Set without a way back; the undo commands use it."""
        self.choice = choice
        self.changed.emit()


STEPS = {
    "before": QT_TRANSLATE_NOOP("comparison", "Load the surface before"),
    "after": QT_TRANSLATE_NOOP("comparison", "Load the surface after"),
    "unit": QT_TRANSLATE_NOOP("comparison", "Change unit"),
    "remove": QT_TRANSLATE_NOOP("comparison", "Remove a surface"),
    "swap": QT_TRANSLATE_NOOP("comparison", "Swap before and after"),
    "frame": QT_TRANSLATE_NOOP("comparison", "Change what is held fixed"),
    "threshold": QT_TRANSLATE_NOOP("comparison", "Change threshold"),
    "jaw": QT_TRANSLATE_NOOP("comparison", "Say which jaw it is"),
    "paint": QT_TRANSLATE_NOOP("comparison", "Paint as stable"),
    "erase": QT_TRANSLATE_NOOP("comparison", "Erase from the stable region"),
    "points": QT_TRANSLATE_NOOP("comparison", "Pick three points on each"),
    "unpick": QT_TRANSLATE_NOOP("comparison", "Pick no points"),
    "tooth": QT_TRANSLATE_NOOP("comparison", "Mark a tooth"),
    "lasso": QT_TRANSLATE_NOOP("comparison", "Correct the marked tooth"),
    "unmark": QT_TRANSLATE_NOOP("comparison", "Remove the mark of the tooth"),
}
"""What undo and redo call a step."""


class _Edit(QUndoCommand):
    """One step; turning on at the same threshold is one."""

    def __init__(self, draft: ComparisonDraft, step: str, old: ComparisonChoice, new: ComparisonChoice) -> None:
        super().__init__(QCoreApplication.translate("comparison", STEPS[step]))
        self._draft, self._step, self._old, self.new = draft, step, old, new

    def redo(self) -> None:
        self._draft.put(self.new)

    def undo(self) -> None:
        self._draft.put(self._old)

    def id(self) -> int:
        return 1000 + list(STEPS).index(self._step)  # the form's own begin at 1

    def mergeWith(self, other: QUndoCommand) -> bool:  # noqa: N802 - Qt's name
        if not isinstance(other, _Edit) or other.id() != self.id() or self._step != "threshold":
            return False
        self.new = other.new
        return True


def _same(old: object, new: object) -> bool:
    """The same thing; of texts, numbers and points also an equal one."""
    return old is new or (isinstance(old, str | int | tuple) and isinstance(new, str | int | tuple) and old == new)
