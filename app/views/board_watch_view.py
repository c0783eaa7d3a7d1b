"""While the rig is calibrated: what to do, what became of the last view, and both pictures with what was seen in them."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from app.controllers.calibration import BoardLook
from app.views.board_picture import BoardPicture
from app.views.board_words import computing_text, count_text, hint_text, now_text, sighting_text, task_text, verdict_text
from app.views.parts import give_role, label
from scanner_core.optics.board_watch import SIDES, BoardWatch, Phase, Side, ViewVerdict

_READ_S = 1.2
_NOW_HEIGHT = 96
"""Two lines: the pictures below do not jump with every sentence."""


class BoardWatchView(QWidget):
    """The left half of the Rig page during a calibration."""

    def __init__(self) -> None:
        super().__init__()
        self._task = label("", "headline", wrap=True)
        self._count = label("", "title")
        self._hint = label("", "muted", wrap=True)
        self._verdict = label("", "muted")
        self._now = label("", "large", wrap=True)
        self._now.setMinimumHeight(_NOW_HEIGHT)
        self._now.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self._by_hand = False
        self._changed_s = 0.0
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
        box.addWidget(self._now)
        box.addSpacing(12)
        for side in SIDES:
            box.addWidget(self.pictures[side], 1)
            box.addSpacing(10)
        self.clear()

    @property
    def now(self) -> str:
        """What a person who shows the board has to do now."""
        return self._now.text()

    def clear(self, *, by_hand: bool = False) -> None:
        """Before the first look; `by_hand` when a person shows the board."""
        self._by_hand = by_hand
        self._now.setVisible(by_hand)
        self._verdict.setVisible(not by_hand)
        self._hint.setVisible(not by_hand)
        self._now.setText(hint_text(Phase.BOARD))
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
        if self._by_hand:
            self._tell_now(watch)
        for side in SIDES:
            seen = watch.left if side == "left" else watch.right
            good = seen.reason is None and taken
            self.pictures[side].show_look(look.frames[side], seen.corners_px, sighting_text(watch, side), good=good)

    def _tell_now(self, watch: BoardWatch) -> None:
        """One large sentence; it stays long enough to be read from where the board is held."""
        words, taken, now_s = now_text(watch), watch.verdict is ViewVerdict.TAKEN, time.monotonic()
        if taken:
            QApplication.beep()
        if words == self._now.text() or not (taken or now_s - self._changed_s > _READ_S):
            return
        self._changed_s = now_s
        give_role(self._now, "large-good" if taken else "large")
        self._now.setText(words)


def _is_last(watch: BoardWatch) -> bool:
    """After it something is computed, which takes a while."""
    return watch.index + 1 == watch.count
