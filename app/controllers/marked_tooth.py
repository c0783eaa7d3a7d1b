"""The tooth that a person marks: it grows from a click to its edge, is corrected by a lasso, and its motion is told."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, Signal

from app.background import Background
from app.comparison_draft import ComparisonDraft, LoadedSurface, Mask
from app.controllers.comparison import ComparisonController
from app.translation import QT_TRANSLATE_NOOP
from scanner_core.comparison.area import PartMotion
from scanner_core.comparison.comparison import Comparison

_GROWING = QT_TRANSLATE_NOOP("comparison", "Looking for its edge…")
_MEASURING = QT_TRANSLATE_NOOP("comparison", "Measuring its motion…")


class MarkedTooth(QObject):
    """The mark is part of the choice, and so undone like everything; the motion follows it and the newest answer."""

    changed = Signal()

    def __init__(
        self,
        background: Background,
        draft: ComparisonDraft,
        answers: ComparisonController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._draft, self._answers, self._tell = background, draft, answers, tell
        self._of: tuple[Comparison, Mask] | None = None  # what `motion` belongs to, or will
        self._turn = 0
        self.motion: PartMotion | None = None
        self.words = ""
        """What is being done, while there is no motion."""
        draft.changed.connect(self._follow)
        answers.answered.connect(self._follow)

    # -------------------------------------------------------------------------------- commands
    def mark(self, vertex: int) -> None:
        """Grow a mark from a vertex of the surface after; the newest click counts."""
        after, comparison = self._draft.choice.after, self._answers.comparison
        if after is None or comparison is None or comparison.after is not after.surface:
            return
        self._turn += 1
        turn, known = self._turn, self._draft.choice.tooth
        self._say(_GROWING)

        def wanted() -> bool:
            """No newer click, no other surface, and the mark neither corrected nor taken back meanwhile."""
            return turn == self._turn and after is self._draft.choice.after and known is self._draft.choice.tooth

        def done(mask: Mask) -> None:
            if wanted():
                self._draft.edit("tooth", tooth=mask)

        def failed(fault: Exception) -> None:
            if wanted():
                self._failed(fault)

        self._background.run("grow-tooth", partial(_grow, after, vertex), done, failed)

    def correct(self, vertices: np.ndarray[tuple[int], np.dtype[np.int64]], *, add: bool) -> None:
        """Add vertices of the surface after to the mark, or take them off."""
        tooth = self._draft.choice.tooth
        if tooth is not None:
            mask = tooth.copy()
            mask[vertices] = add
            self._draft.edit("lasso", tooth=mask)

    def unmark(self) -> None:
        self._draft.edit("unmark", tooth=None)

    # -------------------------------------------------------------------------------- inside
    def _follow(self) -> None:
        comparison, tooth = self._answers.comparison, self._draft.choice.tooth
        if comparison is None or tooth is None or not tooth.any():
            self._of = self.motion = None
            self._say("")
            return
        if self._of is not None and self._of[0].alignment is comparison.alignment and self._of[1] is tooth:
            return
        self._of, self.motion = (comparison, tooth), None
        self._say(_MEASURING)
        self._background.run(
            "tooth-motion", partial(_motion, comparison, tooth), partial(self._done, comparison, tooth), partial(self._missed, tooth)
        )

    def _done(self, comparison: Comparison, tooth: Mask, motion: PartMotion) -> None:
        if self._of is not None and self._of[0] is comparison and self._of[1] is tooth:
            self.motion = motion
            self._say("")

    def _missed(self, tooth: Mask, fault: Exception) -> None:
        if self._of is not None and self._of[1] is tooth:
            self._failed(fault)

    def _failed(self, fault: Exception) -> None:
        self._say("")
        self._tell(fault)

    def _say(self, words: str) -> None:
        self.words = QCoreApplication.translate("comparison", words) if words else ""
        self.changed.emit()


def _grow(after: LoadedSurface, vertex: int) -> Mask:
    from scanner_core.comparison.grow_part import grow_part

    return grow_part(after.surface.mesh, vertex, after.surface.supported)


def _motion(comparison: Comparison, tooth: Mask) -> PartMotion:
    from scanner_core.comparison.part_motion import part_motion

    return part_motion(comparison.before, comparison.after, comparison.alignment, tooth)
