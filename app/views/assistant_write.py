"""Third step: what the rig is called, where its file is written, and what stands in it."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLineEdit, QPlainTextEdit, QWidget

from app.controllers.assistant import AssistantController
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.views import format as fmt
from app.views.file_dialogs import choose_new_file
from app.views.parts import button, column, label, row, seam

_FIRST_NAME = "my-rig"
_PAUSE_MS = 250
"""In typing, after which the text is made anew."""


class WriteStep(QWidget):
    """Calls `use(path)` for the rig that was written."""

    def __init__(self, assistant: AssistantController, folder: Path, use: Callable[[Path], None]) -> None:
        super().__init__()
        self._assistant, self._folder, self._use = assistant, folder, use
        self._chosen: Path | None = None
        self._to_replace: Path | None = None
        self._typed = QTimer(self)
        self._typed.setSingleShot(True)
        self._typed.setInterval(_PAUSE_MS)
        self._typed.timeout.connect(self.entered)
        self.name = QLineEdit(_FIRST_NAME)
        self.name.setAccessibleName(self.tr("Name of the rig"))
        self.name.setMinimumHeight(32)
        self.name.setMaxLength(60)
        self.name.textChanged.connect(self._rename)
        self._path = label("", selectable=True, wrap=True)
        self.browse = button(self.tr("Other file…"), "", self._browse, "folder")
        self.save = button(self.tr("Save"), "primary", self._save)
        self._told = label("", "bad", wrap=True)
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setProperty("role", "details")
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setAccessibleName(self.tr("What will be written"))
        self._written = label("", "good", wrap=True, selectable=True)
        self.use_now = button(self.tr("Use this rig now"), "primary", self._go)
        self._next = label("", "muted", wrap=True)
        form = QGridLayout()
        form.setHorizontalSpacing(18)
        form.setVerticalSpacing(12)
        form.setColumnStretch(1, 1)
        name_label = label(self.tr("Name"), "muted")
        name_label.setBuddy(self.name)
        form.addWidget(name_label, 0, 0)
        form.addWidget(self.name, 0, 1)
        form.addWidget(label(self.tr("File"), "muted"), 1, 0)
        form.addWidget(self._path, 1, 1)
        to_know = self.tr(
            "Limits, the laser's place and the volume are those of the shipped bench. Correct them for your mechanics before the first scan."
        )
        left = column(
            label(self.tr("The rig's file"), "section"),
            form,
            label(to_know, "muted", wrap=True),
            row(self.save, self.browse, 1),
            self._told,
            self._written,
            row(self.use_now, 1),
            self._next,
            1,
            spacing=14,
        )
        left.setContentsMargins(36, 20, 24, 16)
        right = column(label(self.tr("What will be written"), "section"), self.text, spacing=10)
        right.setContentsMargins(24, 20, 28, 18)
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addLayout(left, 5)
        box.addWidget(seam(upright=True))
        box.addLayout(right, 6)

    @property
    def rig_name(self) -> str:
        return self.name.text().strip() or _FIRST_NAME

    @property
    def path(self) -> Path:
        """Where it will be written."""
        stem = re.sub(r"[^\w.-]+", "-", self.name.text().strip()).strip("-.") or _FIRST_NAME
        return self._chosen or self._folder / f"{stem}.toml"

    def entered(self) -> None:
        """The step is shown: what will be written, as of now."""
        self._assistant.propose(self.rig_name)

    def show_snapshot(self, snapshot: AssistantSnapshot) -> None:
        if self.text.toPlainText() != snapshot.text:
            at = self.text.verticalScrollBar().value()
            self.text.setPlainText(snapshot.text)
            self.text.verticalScrollBar().setValue(at)
        self._path.setText(fmt.short_path(str(self.path)))
        self.save.setEnabled(bool(snapshot.text) and bool(self.name.text().strip()) and snapshot.running is Job.NONE)
        written = snapshot.written
        self._written.setText("" if written is None else self.tr("Written to {path}.").format(path=fmt.short_path(str(written))))
        calibrated = snapshot.config is not None and snapshot.config.calibration is not None
        to_do = self.tr("The rig cannot measure before it is calibrated: the Rig page prints the target and takes you through it.")
        self._next.setText(self.tr("The Rig page shows it, and calibrates it anew.") if calibrated else to_do)
        for part in (self._written, self.use_now, self._next):
            part.setVisible(written is not None)
        self._told.setVisible(bool(self._told.text()))

    # -------------------------------------------------------------------------------- inside
    def _rename(self) -> None:
        self._chosen = None
        self._tell("")
        self._path.setText(fmt.short_path(str(self.path)))
        self._typed.start()

    def _browse(self) -> None:
        title, kinds = self.tr("Where to write the rig"), self.tr("Rigs (*.toml)")
        choose_new_file(self, title, str(self.path), kinds, "toml", self._take)

    def _take(self, path: Path) -> None:
        """The dialog has asked whether a file that is there may be replaced."""
        self._chosen, self._to_replace = path, path
        self._tell("")
        self.show_snapshot(self._assistant.snapshot)

    def _save(self) -> None:
        path = self.path
        self._assistant.write(self.rig_name, path, force=path == self._to_replace, exists=lambda: self._ask(path))

    def _ask(self, path: Path) -> None:
        """There is such a file already: the next press replaces it."""
        self._to_replace = path
        self._tell(self.tr("There is a file of this name already. Press once more to replace it, or choose another name."))
        self.save.setText(self.tr("Replace it"))

    def _tell(self, text: str) -> None:
        if not text:
            self._to_replace = self._to_replace if self._to_replace == self._chosen else None
            self.save.setText(self.tr("Save"))
        self._told.setText(text)
        self._told.setVisible(bool(text))

    def _go(self) -> None:
        written = self._assistant.snapshot.written
        if written is not None:
            self._use(written)
