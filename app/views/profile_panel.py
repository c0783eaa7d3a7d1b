"""An export profile, field by field: what is changed is in force at once, and can be undone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QLineEdit, QToolButton, QVBoxLayout, QWidget

from app.controllers.export_profiles import ExportProfiles
from app.file_names import FIELDS
from app.services import Services
from app.theme import icon
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.delivery_words import POSES, profile_name
from app.views.file_dialogs import choose_folder
from app.views.parts import button, label, row, seam
from scanner_core.delivery.profile import LONGEST_NAME, Pose, Profile

_FORMAT_WORDS = {
    ".stl": "STL",
    ".ply": QT_TRANSLATE_NOOP("delivery", "PLY, with uncertainty and support"),
    ".obj": "OBJ",
    ".3mf": QT_TRANSLATE_NOOP("delivery", "3MF, carries its unit"),
}

_UNIT_WORDS = {
    "mm": QT_TRANSLATE_NOOP("delivery", "Millimetres"),
    "cm": QT_TRANSLATE_NOOP("delivery", "Centimetres"),
    "m": QT_TRANSLATE_NOOP("delivery", "Metres"),
    "inch": QT_TRANSLATE_NOOP("delivery", "Inches"),
}


class ProfilePanel(QWidget):
    """`closed` when the person is done."""

    closed = Signal()

    def __init__(self, services: Services, profiles: ExportProfiles) -> None:
        super().__init__()
        self._services, self._profiles = services, profiles
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(9)
        self._hint = label("", "muted", wrap=True)
        box.addWidget(self._hint)
        grid = QGridLayout()
        grid.setColumnStretch(1, 1)
        grid.setVerticalSpacing(8)
        box.addLayout(grid)
        self.name = self._text(grid, self.tr("Name"), lambda text: self._change(name=text.strip() or self._profile().name))
        self.name.setMaxLength(LONGEST_NAME)
        self.format = self._choice(grid, self.tr("Format"), {suffix: _word(words) for suffix, words in _FORMAT_WORDS.items()}, "format")
        self.unit = self._choice(grid, self.tr("Unit"), {unit: _word(words) for unit, words in _UNIT_WORDS.items()}, "unit")
        self.template = self._text(grid, self.tr("File name"), lambda text: self._change(template=text.strip()))
        self.template.setToolTip(self.tr("In braces: {fields}").format(fields=", ".join(FIELDS)))
        self.folder = QLineEdit()
        self.browse = QToolButton()
        self.browse.setIcon(icon("folder"))
        self.browse.setToolTip(self.tr("Choose a folder"))
        self.browse.setAccessibleName(self.tr("Choose a folder"))
        self.browse.clicked.connect(self._browse)
        self._field(grid, self.tr("Folder"), self.folder)
        grid.addLayout(row(self.folder, self.browse, spacing=4), grid.rowCount() - 1, 1)
        self.folder.editingFinished.connect(lambda: self._change(folder=self.folder.text().strip()))
        self.pose = self._choice(grid, self.tr("Lies"), {pose: _word(words) for pose, words in POSES.items()}, "pose")
        self.open_base = self._switch(box, self.tr("Without its base (open surface)"), "open_base")
        self.certificate = self._switch(box, self.tr("Certificate beside it (PDF and JSON)"), "certificate")
        self.points = self._switch(box, self.tr("Measured points beside it (XYZ)"), "points")
        box.addStretch(1)
        self.copy = button(self.tr("Copy as my own"), "", self._copy)
        self.remove = button(self.tr("Remove"), "", lambda: self._profiles.remove(self._profile()))
        self.done = button(self.tr("Done"), "primary", self.closed.emit)
        box.addWidget(seam())
        box.addLayout(row(self.copy, self.remove, 1, self.done, spacing=6))
        profiles.changed.connect(self.show_profile)
        services.draft.changed.connect(lambda name: self.show_profile() if name == "kind" else None)
        self.show_profile()

    def show_profile(self) -> None:
        """The one that is chosen for this order."""
        profile, own = self._profile(), self._profiles.is_own(self._profile())
        self._hint.setText(
            self.tr("Every change counts at once; Ctrl+Z takes it back.")
            if own
            else self.tr("This profile belongs to the program. Copy it to change it.")
        )
        settings = self._services.settings
        self._put(self.name, profile_name(profile))
        self._put(self.template, profile.template)
        self.template.setPlaceholderText(settings.name_template)
        self._put(self.folder, profile.folder)
        self.folder.setPlaceholderText(fmt.short_path(settings.export_folder))
        for choice, value in ((self.format, profile.format), (self.unit, profile.unit), (self.pose, profile.pose.value)):
            choice.setCurrentIndex(max(0, choice.findData(value)))
        for switch, on in ((self.open_base, profile.open_base), (self.certificate, profile.certificate), (self.points, profile.points)):
            switch.setChecked(on)
        fields = (self.name, self.template, self.folder, self.browse, self.format, self.unit, self.pose)
        for part in (*fields, self.open_base, self.certificate, self.points, self.remove):
            part.setEnabled(own)
        self.remove.setVisible(own)

    # -------------------------------------------------------------------------------- inside
    def _profile(self) -> Profile:
        return self._profiles.chosen(self._kind)

    @property
    def _kind(self) -> str:
        return self._services.draft.values.kind

    def _change(self, **values: Any) -> None:
        before = self._profile()
        after = replace(before, **values)
        if after != before and self._profiles.is_own(before):
            self._profiles.change(self._kind, before, after)

    def _copy(self) -> None:
        self._profiles.copy(self._kind, replace(self._profile(), name=profile_name(self._profile())))
        self.name.setFocus()
        self.name.selectAll()

    def _browse(self) -> None:
        start = self._profile().folder or self._services.settings.export_folder
        choose_folder(self, self.tr("Folder for exported files"), str(Path(start).expanduser()), lambda path: self._change(folder=str(path)))

    @staticmethod
    def _put(field: QLineEdit, text: str) -> None:
        if field.text() != text:
            field.setText(text)

    # -------------------------------------------------------------------------------- what it is made of
    def _field(self, grid: QGridLayout, caption: str, field: QWidget) -> None:
        words = label(caption, "muted")
        words.setBuddy(field)
        field.setAccessibleName(caption)
        field.setMinimumHeight(30)
        grid.addWidget(words, grid.rowCount(), 0)

    def _text(self, grid: QGridLayout, caption: str, changed: Callable[[str], None]) -> QLineEdit:
        field = QLineEdit()
        self._field(grid, caption, field)
        grid.addWidget(field, grid.rowCount() - 1, 1)
        field.editingFinished.connect(lambda: changed(field.text()))
        return field

    def _choice(self, grid: QGridLayout, caption: str, words: dict[Any, str], name: str) -> QComboBox:
        choice = QComboBox()
        choice.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        for value, text in words.items():
            choice.addItem(text, value.value if isinstance(value, Pose) else value)
        self._field(grid, caption, choice)
        grid.addWidget(choice, grid.rowCount() - 1, 1)
        make = Pose if name == "pose" else str
        choice.activated.connect(lambda _: self._change(**{name: make(choice.currentData())}))
        return choice

    def _switch(self, box: QVBoxLayout, words: str, name: str) -> QCheckBox:
        switch = QCheckBox(words)
        switch.clicked.connect(partial(self._switched, name))
        box.addWidget(switch)
        return switch

    def _switched(self, name: str, on: bool) -> None:
        self._change(**{name: on})


def _word(text: str) -> str:
    return QCoreApplication.translate("delivery", text)
