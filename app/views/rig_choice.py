"""Which rig: a preset or a laboratory's own rig file; of a virtual one also what stands on its table and how fast it runs."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QButtonGroup, QComboBox, QGridLayout, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from app.controllers.rig import SPECIMENS, SPEEDS, RigController
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.file_dialogs import choose_file
from app.views.parts import button, label, row

PRESET_WORDS = {
    "bench": QT_TRANSLATE_NOOP("rig", "Bench: 604 × 294 px at 435 mm"),
    "paper-2003": QT_TRANSLATE_NOOP("rig", "Paper 2003: the published rig at 770 mm"),
    "workshop": QT_TRANSLATE_NOOP("rig", "Workshop: 1440 × 1080 px at 600 mm"),
}
SPECIMEN_WORDS = {
    "ear": QT_TRANSLATE_NOOP("rig", "Ear impression"),
    "arch": QT_TRANSLATE_NOOP("rig", "Dental arch"),
    "ear-pair": QT_TRANSLATE_NOOP("rig", "Both ears on a pair tray"),
    "heart": QT_TRANSLATE_NOOP("rig", "Heart"),
    "sphere": QT_TRANSLATE_NOOP("rig", "Reference sphere"),
}
SPEED_WORDS = {
    "1": QT_TRANSLATE_NOOP("rig", "Real time"),
    "5": QT_TRANSLATE_NOOP("rig", "5 times"),
    "max": QT_TRANSLATE_NOOP("rig", "As fast as it can"),
}
_CAPTION = 110


def specimen_words(name: str) -> str:
    """A built-in specimen in words, a file by its name."""
    word = SPECIMEN_WORDS.get(name)
    return QCoreApplication.translate("rig", word) if word else Path(name).name


class RigChoice(QWidget):
    """Asks the rig's controller for what a person chooses."""

    def __init__(self, rig: RigController) -> None:
        super().__init__()
        self._rig = rig
        self.preset, self.specimen = QComboBox(), QComboBox()
        self.preset.setAccessibleName(self.tr("Rig"))
        self.specimen.setAccessibleName(self.tr("On the table"))
        for field in (self.preset, self.specimen):
            field.setMinimumHeight(34)
            field.setMinimumContentsLength(12)
            field.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.preset.activated.connect(lambda index: rig.choose(preset=self.preset.itemData(index)))
        for key in SPECIMENS:
            self.specimen.addItem(QCoreApplication.translate("rig", SPECIMEN_WORDS[key]), key)
        self.specimen.activated.connect(lambda index: rig.choose(specimen=self.specimen.itemData(index)))
        self._own = button(self.tr("Own rig…"), "", self.choose_rig_file, "folder")
        self._own.setToolTip(self.tr("Open a rig file (TOML); it can be dropped here, too"))
        self._mesh = button(self.tr("Mesh file…"), "", self.choose_mesh, "folder")
        self._speeds: dict[str, QPushButton] = {}
        speeds, group = QHBoxLayout(), QButtonGroup(self)
        speeds.setSpacing(8)
        for key in SPEEDS:
            made = button(QCoreApplication.translate("rig", SPEED_WORDS[key]), "choice", partial(rig.choose, speed=key))
            made.setCheckable(True)
            group.addButton(made)
            speeds.addWidget(made, 1)
            self._speeds[key] = made
        rig_line = row(self.preset, self._own)
        rig_line.setStretch(0, 1)
        self.more = QHBoxLayout()
        """For what else there is to do about the choice of a rig."""
        self.more.setSpacing(14)
        specimen_line = row(self.specimen, self._mesh)
        specimen_line.setStretch(0, 1)
        self._specimen_line, self._speed_line = _line(self.tr("On the table"), specimen_line), _line(self.tr("Speed"), speeds)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(14)
        for part in (_line(self.tr("Rig"), rig_line), self._specimen_line, self._speed_line):
            box.addWidget(part)
        box.addLayout(self.more)

    def show_rig(self) -> None:
        """What was chosen, and what may be chosen now."""
        rig = self._rig.snapshot
        self._list_rigs()
        self.preset.setCurrentIndex(self.preset.findData(rig.preset))
        self.preset.setToolTip(rig.preset if rig.own else "")
        at = self.specimen.findData(rig.specimen)
        if at < 0:
            self.specimen.addItem(Path(rig.specimen).name, rig.specimen)
            at = self.specimen.count() - 1
        self.specimen.setCurrentIndex(at)
        self._speeds[rig.speed].setChecked(True)
        self._specimen_line.setVisible(rig.virtual)
        self._speed_line.setVisible(rig.simulated)
        for part in (self.preset, self._own, self.specimen, self._mesh, *self._speeds.values()):
            part.setEnabled(not rig.busy and rig.calibrating is None)

    def _list_rigs(self) -> None:
        """The presets, then the own rigs that are known, with those whose file is missing."""
        chosen = self._rig.snapshot.preset
        own = list(self._rig.files.known)
        own += [chosen] if self._rig.snapshot.own and chosen not in own else []
        wanted = [(QCoreApplication.translate("rig", word), key) for key, word in PRESET_WORDS.items()]
        wanted += [(_own_words(path), path) for path in own]
        if wanted == [(self.preset.itemText(at), self.preset.itemData(at)) for at in range(self.preset.count())]:
            return
        self.preset.clear()
        for words, key in wanted:
            self.preset.addItem(words, key)
            if key not in PRESET_WORDS:
                self.preset.setItemData(self.preset.count() - 1, key, Qt.ItemDataRole.ToolTipRole)

    # -------------------------------------------------------------------------------- files
    def choose_rig_file(self) -> None:
        known = self._rig.files.known
        start = str(Path(known[0]).parent) if known else str(Path.home())
        choose_file(self, self.tr("Open a rig file"), start, self.tr("Rig files (*.toml)"), lambda path: self._rig.choose(preset=str(path)))

    def choose_mesh(self) -> None:
        kinds = self.tr("Meshes (*.stl *.ply *.obj *.vtp *.3mf)")
        choose_file(self, self.tr("A mesh as specimen"), "", kinds, lambda path: self._rig.choose(specimen=str(path)))


def _own_words(path: str) -> str:
    stem, folder = Path(path).stem, fmt.short_path(str(Path(path).parent))
    if Path(path).is_file():
        return f"{stem}  ·  {folder}"
    missing = QCoreApplication.translate("rig", QT_TRANSLATE_NOOP("rig", "{rig}  (the file is missing)")).format(rig=stem)
    return f"{missing}  ·  {folder}"  # the folder is what may be cut


def _line(caption: str, line: QHBoxLayout) -> QWidget:
    made = QWidget()
    grid = QGridLayout(made)
    grid.setContentsMargins(0, 0, 0, 0)
    grid.setHorizontalSpacing(18)
    grid.setColumnMinimumWidth(0, _CAPTION)
    grid.setColumnStretch(1, 1)
    grid.addWidget(label(caption, "muted"), 0, 0)
    grid.addLayout(line, 0, 1)
    return made
