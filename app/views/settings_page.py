"""Everything that is set once: looks, language, folders, what a scan does, privacy."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QComboBox, QGridLayout, QLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from app.controllers.preferences import SCALES
from app.language import LANGUAGES, system_language
from app.services import Services
from app.views import format as fmt
from app.views.activity import is_busy
from app.views.file_dialogs import choose_folder
from app.views.file_name_line import FileNameLine
from app.views.page import Page
from app.views.parts import button, column, label, row, scrolled, seam
from scanner_core.user_folders import log_folder

_WIDTH = 760
_CAPTION = 190


class SettingsPage(Page):
    """Each is in force as soon as it is changed, or says when it will be."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._preferences = services.preferences
        self._showing: dict[str, Callable[[object], None]] = {}
        inside = QWidget()
        inside.setMaximumWidth(_WIDTH)
        box = QVBoxLayout(inside)
        box.setContentsMargins(40, 34, 40, 30)
        box.setSpacing(12)
        self.reset = button(self.tr("Reset to defaults"), "", self._preferences.reset)
        self.reset.setToolTip(self.tr("Everything on this page as on the first day; Ctrl+Z takes it back."))
        box.addLayout(row(label(self.tr("Settings"), "headline"), 1, self.reset))
        self._add_looks(box)
        self._add_files(box)
        self._add_scanning(box)
        self._add_program(box)
        box.addStretch(1)
        around = QVBoxLayout(self)
        around.setContentsMargins(0, 0, 0, 0)
        around.addWidget(scrolled(inside))
        self._preferences.changed.connect(self._show)
        for name in self._showing:
            self._show(name)

    def entered(self) -> None:
        self.names.show_order(self.services.draft.values)

    # -------------------------------------------------------------------------------- parts
    def _add_looks(self, box: QVBoxLayout) -> None:
        grid = self._section(box, self.tr("Looks"))
        themes = {"system": self.tr("As the system"), "dark": self.tr("Dark"), "light": self.tr("Light")}
        self.themes = self._choice("theme", themes)
        self._line(grid, self.tr("Theme"), _side_by_side(self.themes))
        self.language = QComboBox()
        self.language.setMinimumHeight(32)
        self.language.addItem(self.tr("As the system ({language})").format(language=LANGUAGES[system_language()]), "")
        for code, name in LANGUAGES.items():
            self.language.addItem(name, code)
        self.language.activated.connect(lambda _: self._preferences.edit("language", self.language.currentData()))
        self._showing["language"] = lambda value: self.language.setCurrentIndex(max(0, self.language.findData(value)))
        self._language_note = label("", "faint", wrap=True)
        self._line(grid, self.tr("Language"), self.language, self._language_note)
        self.scales = self._choice("scale_percent", {value: self.tr("{n} %").format(n=value) for value in SCALES})
        note = label(self.tr("Of everything in the window, from the next start on."), "faint", wrap=True)
        self._line(grid, self.tr("Size"), _side_by_side(self.scales), note)

    def _add_files(self, box: QVBoxLayout) -> None:
        grid = self._section(box, self.tr("Files"))
        self.case_folder = self._folder("case_folder", grid, self.tr("Cases"))
        self.export_folder = self._folder("export_folder", grid, self.tr("Deliveries"))
        self.names = FileNameLine(self._preferences)
        self.names.unfold(True)
        note = label(self.tr("Without it a file that leaves the house tells the order, the side and the day, and no patient."), "faint", wrap=True)
        self._line(grid, self.tr("File names"), self.names, note)

    def _add_scanning(self, box: QVBoxLayout) -> None:
        grid = self._section(box, self.tr("Scanning"))
        surface = self._switch("live_surface", self.tr("Show the surface while it is scanned"))
        self._line(grid, self.tr("Live surface"), surface, label(self.tr("Off leaves a slow computer more time for the points."), "faint", wrap=True))
        again = self._switch("retry", self.tr("Measure weak places again by itself"))
        note = label(self.tr("At the end of a view, with the beam as slow as it needs to be; it costs some seconds."), "faint", wrap=True)
        self._line(grid, self.tr("Second try"), again, note)

    def _add_program(self, box: QVBoxLayout) -> None:
        grid = self._section(box, self.tr("Program"))
        where = QLineEdit(fmt.short_path(str(log_folder())))
        where.setMinimumHeight(32)
        where.setReadOnly(True)
        where.setAccessibleName(self.tr("Folder of the log"))
        self.open_log = button(self.tr("Open the folder"), "", _open_log, "folder")
        note = label(self.tr("The log holds no patients and no orders. A support bundle (Help) packs it with what else helps."), "faint", wrap=True)
        self._line(grid, self.tr("Log"), row(where, self.open_log), note)

    # -------------------------------------------------------------------------------- what they are made of
    def _section(self, box: QVBoxLayout, title: str) -> QGridLayout:
        box.addSpacing(10)
        box.addWidget(label(title, "section"))
        box.addWidget(seam())
        grid = QGridLayout()
        grid.setHorizontalSpacing(18)
        grid.setVerticalSpacing(12)
        grid.setColumnMinimumWidth(0, _CAPTION)
        grid.setColumnStretch(1, 1)
        box.addLayout(grid)
        return grid

    def _line(self, grid: QGridLayout, caption: str, part: QWidget | QLayout, note: QWidget | None = None) -> None:
        """A caption, what is set, and a word about it below."""
        line = grid.rowCount()
        words = label(caption, "muted", wrap=True)
        words.setFixedWidth(_CAPTION)
        if isinstance(part, QComboBox | QLineEdit):
            words.setBuddy(part)
            part.setAccessibleName(caption)
        parts = (part,) if note is None else (part, note)
        grid.addWidget(words, line, 0, Qt.AlignmentFlag.AlignTop)
        grid.addLayout(column(*parts, spacing=4), line, 1)

    def _choice(self, name: str, words: Mapping[str, str] | Mapping[int, str]) -> dict[object, QPushButton]:
        group = QButtonGroup(self)
        made: dict[object, QPushButton] = {}
        for value, text in words.items():
            choice = button(text, "choice", partial(self._preferences.edit, name, value))
            choice.setCheckable(True)
            group.addButton(choice)
            made[value] = choice
        self._showing[name] = lambda value: made[value].setChecked(True) if value in made else None
        return made

    def _switch(self, name: str, text: str) -> QCheckBox:
        made = QCheckBox(text)
        made.toggled.connect(partial(self._preferences.edit, name))
        self._showing[name] = lambda value: made.setChecked(bool(value))
        return made

    def _folder(self, name: str, grid: QGridLayout, caption: str) -> QLineEdit:
        path = QLineEdit()
        path.setMinimumHeight(32)
        path.setReadOnly(True)
        self._showing[name] = lambda value: path.setText(fmt.short_path(str(value)))
        choose = button(self.tr("Choose…"), "", partial(self._choose, name), "folder")
        choose.setAccessibleName(self.tr("Choose the folder: {name}").format(name=caption))
        path.setAccessibleName(self.tr("Folder: {name}").format(name=caption))
        line = row(path, choose)
        line.setStretch(0, 1)
        self._line(grid, caption, line)
        return path

    # -------------------------------------------------------------------------------- what is done
    def _show(self, name: str) -> None:
        if name in self._showing:
            self._showing[name](getattr(self._preferences.settings, name))
        if name == "language":
            waiting = is_busy(self.services)
            later = self.tr("The window changes its language when the scan or the reconstruction has ended and the program starts again.")
            self._language_note.setText(later if waiting else self.tr("The window is made anew in it; the open case stays."))

    def _choose(self, name: str) -> None:
        choose_folder(
            self, self.tr("Choose a folder"), getattr(self._preferences.settings, name), lambda path: self._preferences.edit(name, str(path))
        )


def _side_by_side(choices: dict[object, QPushButton]) -> QLayout:
    return row(*choices.values(), 1, spacing=8)


def _open_log() -> None:
    folder: Path = log_folder()
    folder.mkdir(parents=True, exist_ok=True)
    QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder)))
