"""While the rig is calibrated: what to do, what became of the last view, and both pictures with what was seen in them."""

from __future__ import annotations

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.controllers.calibration import BoardLook
from app.views.board_picture import BoardPicture
from app.views.board_words import computing_text, count_text, hint_text, sighting_text, task_text, verdict_text
from app.views.parts import give_role, label
from scanner_core.optics.board_watch import SIDES, BoardWatch, Phase, Side, ViewVerdict


class BoardWatchView(QWidget):
    """The left half of the Rig page during a calibration."""

    def __init__(self) -> None:
        super().__init__()
        self._task = label("", "headline", wrap=True)
        self._count = label("", "title")
        self._hint = label("", "muted", wrap=True)
        self._verdict = label("", "muted")
        names: dict[Side, str] = {"left": self.tr("Camera left"), "right": self.tr("Camera right")}
        self.pictures = {side: BoardPicture(names[side]) for side in SIDES}
        box = QVBoxLayout(self)
        box.setContentsMargins(40, 34, 40, 24)
        box.setSpacing(0)
        box.addWidget(self._task)
        box.addSpacing(4)
        box.addWidget(self._hint)
        box.addSpacing(12)
        box.addWidget(self._count)
        box.addSpacing(2)
        box.addWidget(self._verdict)
        box.addSpacing(12)
        for side in SIDES:
            box.addWidget(self.pictures[side], 1)
            box.addSpacing(10)
        self.clear()

    def clear(self) -> None:
        """Before the first look."""
        self._task.setText(task_text(Phase.BOARD))
        self._hint.setText(hint_text(Phase.BOARD))
        self._count.setText(self.tr("Starting…"))
        self._verdict.setText("")
        for picture in self.pictures.values():
            picture.clear()

    def show_look(self, look: BoardLook) -> None:
        """The newest look."""
        watch = look.watch
        self._task.setText(task_text(watch.phase))
        self._hint.setText(hint_text(watch.phase))
        self._count.setText(count_text(watch))
        taken = watch.verdict is ViewVerdict.TAKEN
        give_role(self._verdict, "good" if taken else "bad")
        self._verdict.setText(verdict_text(watch.verdict))
        if _is_last(watch):
            give_role(self._verdict, "muted")
            self._verdict.setText(computing_text(watch.phase))
        for side in SIDES:
            seen = watch.left if side == "left" else watch.right
            good = seen.reason is None and taken
            self.pictures[side].show_look(look.frames[side], seen.corners_px, sighting_text(watch, side), good=good)


def _is_last(watch: BoardWatch) -> bool:
    """After it something is computed, which takes a while."""
    return watch.index + 1 == watch.count
