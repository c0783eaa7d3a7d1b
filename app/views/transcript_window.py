"""What was said to the controller and what it answered: the last lines, live while the window is open, to be copied into a mail."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QFontDatabase, QHideEvent, QShowEvent
from PySide6.QtWidgets import QApplication, QCheckBox, QDialog, QPlainTextEdit, QVBoxLayout, QWidget

from app.controllers.rig import RigController
from app.views.parts import button, label, row
from scanner_core.wall_clock import stamp

_PERIOD_MS = 400


class TranscriptWindow(QDialog):
    """Beside the window, never modal; Esc closes it (and stops the laser, as everywhere)."""

    def __init__(self, rig: RigController, parent: QWidget) -> None:
        super().__init__(parent)
        self._rig = rig
        self._shown: list[str] = []
        self.setWindowTitle(self.tr("Transcript of the controller"))
        self.setWindowModality(Qt.WindowModality.NonModal)
        self.resize(720, 520)
        self._about = label("", "muted", wrap=True)
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setAccessibleName(self.tr("Lines to (>) and from (<) the controller"))
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.quiet = QCheckBox(self.tr("&Leave out the questions for the status"))
        self.quiet.setChecked(True)
        self.quiet.toggled.connect(self._show_lines)
        self.copy = button(self.tr("&Copy"), "", self._copy)
        self._close = button(self.tr("Close"), "", self.close)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 14, 16, 14)
        box.setSpacing(10)
        box.addWidget(self._about)
        box.addWidget(self.text, 1)
        box.addLayout(row(self.quiet, 1, self.copy, self._close))
        self._timer = QTimer(self)
        self._timer.setInterval(_PERIOD_MS)
        self._timer.timeout.connect(self._show_lines)

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        self._show_lines()
        self.text.setFocus()
        self._timer.start()
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        self._timer.stop()
        super().hideEvent(event)

    def _show_lines(self) -> None:
        rig, lines = self._rig.snapshot, self._rig.transcript()
        port = "–" if rig.config is None else rig.config.controller.port
        words = self.tr("Port {port}. Seconds since the start, > to the controller, < from it.").format(port=port)
        self._about.setText(words if lines else self.tr("Port {port}. Nothing has been said yet.").format(port=port))
        wanted = [line.words() for line in lines if not (self.quiet.isChecked() and line.is_status)]
        if wanted == self._shown or self.text.textCursor().hasSelection():  # somebody is about to copy a part of it
            return
        self._shown = wanted
        bar = self.text.verticalScrollBar()
        at_end, place = bar.value() >= bar.maximum() - 2, bar.value()
        self.text.setPlainText("\n".join(wanted))
        bar.setValue(bar.maximum() if at_end else place)

    def _copy(self) -> None:
        """Everything, also what is left out of the picture."""
        rig = self._rig.snapshot
        head = [stamp(), rig.preset, *(f"{key}: {value}" for key, value in rig.controller.items())]
        QApplication.clipboard().setText("\n".join([*head, "", *(line.words() for line in self._rig.transcript())]) + "\n")
