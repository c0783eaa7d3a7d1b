"""A check of the rig: how it came out, what was measured, and what to do."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.views.assistant_words import verdict_words
from app.views.check_names import check_name
from app.views.parts import Lamp, button, column, label, row

if TYPE_CHECKING:
    from scanner_core.commissioning.rig_check import RigCheck

_INDENT = 16


class CheckLine(QWidget):
    """Calls `shown(check)` when a person wants its pictures."""

    def __init__(self, made: RigCheck, shown: Callable[[RigCheck], None]) -> None:
        super().__init__()
        self.made = made
        mood, word = verdict_words(made.check)
        self.state = Lamp()
        self.state.show_state(mood, check_name(made.check.name))
        self.state.setStyleSheet("font-weight: 600;")
        self.detail = label(_sentence(made.check.detail), "muted", wrap=True, selectable=True)
        self.remedy = label(made.check.remedy, "bad", wrap=True, selectable=True)
        self.remedy.setVisible(bool(made.check.remedy))
        self.pictures = button(self.tr("Pictures"), "choice", lambda: shown(made))
        self.pictures.setCheckable(True)
        self.pictures.setAccessibleName(self.tr("Pictures of: {check}").format(check=check_name(made.check.name)))
        self.pictures.setVisible(bool(made.pictures))
        verdict = label(word, {"good": "good", "warn": "bad"}[mood])
        texts = column(self.detail, self.remedy, spacing=3)
        texts.setContentsMargins(_INDENT, 0, 0, 0)
        body = row(texts, self.pictures, spacing=12)
        body.setStretch(0, 1)
        body.setAlignment(self.pictures, Qt.AlignmentFlag.AlignTop)
        box = column(row(self.state, 1, verdict), body, spacing=3)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        told = (check_name(made.check.name), word, made.check.detail, made.check.remedy)
        self.setAccessibleName(", ".join(part for part in told if part))

    def show_chosen(self, chosen: bool) -> None:
        self.pictures.setChecked(chosen)


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
