"""What a support bundle would hold: every entry to read and to leave out, before anything is saved."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QCloseEvent, QShowEvent
from PySide6.QtWidgets import QDialog, QListWidget, QListWidgetItem, QProgressBar, QSplitter, QVBoxLayout, QWidget

from app.controllers.support import SupportController
from app.faults import sentence_of
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.file_dialogs import choose_new_file
from app.views.parts import button, column, give_role, label, row
from app.views.support_preview import SupportPreview
from scanner_core import wall_clock

KINDS = {
    "log": QT_TRANSLATE_NOOP("support", "Log"),
    "machine": QT_TRANSLATE_NOOP("support", "Versions and machine"),
    "rig": QT_TRANSLATE_NOOP("support", "Rig file"),
    "transcript": QT_TRANSLATE_NOOP("support", "Transcript of the controller"),
    "doctor": QT_TRANSLATE_NOOP("support", "Checks"),
    "settings": QT_TRANSLATE_NOOP("support", "Settings"),
    "cases": QT_TRANSLATE_NOOP("support", "Sizes of the cases"),
}
_NAME = Qt.ItemDataRole.UserRole


class SupportDialog(QDialog):
    """Beside the window, never modal, so that the stop button works."""

    def __init__(self, support: SupportController, parent: QWidget) -> None:
        super().__init__(parent)
        self._support = support
        self._shown: object = None
        self.setWindowTitle(self.tr("Support bundle"))
        self.setWindowModality(Qt.WindowModality.NonModal)
        self.resize(980, 620)
        about = self.tr(
            "One file for whoever helps you. Orders, patients, file names, the user and this machine are replaced, as marked in the text. "
            "Nothing leaves this machine by itself: you save the file and send it."
        )
        self.entries = QListWidget()
        self.entries.setAccessibleName(self.tr("Entries; those with a tick are saved"))
        self.entries.setWordWrap(True)
        self.entries.setSpacing(3)
        self.entries.currentItemChanged.connect(lambda *_: self._show_entry())
        self.entries.itemChanged.connect(lambda _: self._show_total())
        self._title = label("", "section")
        self._about = label("", "muted", wrap=True)
        self.preview = SupportPreview()
        reading = column(self._title, self._about, self.preview, spacing=4)
        reading.setContentsMargins(10, 0, 0, 0)
        right = QWidget()
        right.setLayout(reading)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.entries)
        split.addWidget(right)
        split.setChildrenCollapsible(False)
        split.setStretchFactor(1, 1)
        split.setSizes([290, 660])
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setRange(0, 100)
        self.said = label("", "muted", wrap=True, selectable=True)
        self.again = button(self.tr("Collect &again"), "", support.collect)
        self.save = button(self.tr("&Save…"), "primary", self._choose)
        self._close = button(self.tr("Close"), "", self.close)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 14, 16, 14)
        box.setSpacing(10)
        box.addWidget(label(about, wrap=True))
        box.addWidget(split, 1)
        box.addWidget(self.bar)
        foot = row(self.said, self.again, self._close, self.save)
        foot.setStretch(0, 1)
        box.addLayout(foot)
        support.changed.connect(self._show)

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        """Each time it is opened it shows how things are now."""
        if not event.spontaneous():
            self._support.collect()
        super().showEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        self._support.cancel()
        super().closeEvent(event)

    def left_out(self) -> list[str]:
        """Names of the entries without a tick."""
        items = (self.entries.item(number) for number in range(self.entries.count()))
        return [item.data(_NAME) for item in items if item.checkState() is not Qt.CheckState.Checked]

    def _show(self) -> None:
        state = self._support.state
        self.bar.setVisible(state.fraction is not None)
        self.bar.setValue(round(100 * (state.fraction or 0.0)))
        self.save.setEnabled(state.bundle is not None and not state.writing)
        self.again.setEnabled(state.fraction is None)
        if state.bundle is not self._shown:
            self._shown = state.bundle
            self._fill()
        self._show_total()

    def _fill(self) -> None:
        bundle = self._support.state.bundle
        self.entries.clear()
        for entry in () if bundle is None else bundle.entries:
            kind = QCoreApplication.translate("support", KINDS[entry.kind])
            item = QListWidgetItem(f"{kind}\n{entry.name}, {_size(len(entry.content))}")
            item.setData(_NAME, entry.name)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Checked)
            self.entries.addItem(item)
        self.entries.setCurrentRow(0)
        self._show_entry()

    def _show_entry(self) -> None:
        bundle, item = self._support.state.bundle, self.entries.currentItem()
        entry = None if bundle is None or item is None else next(each for each in bundle.entries if each.name == item.data(_NAME))
        self._title.setText("" if entry is None else entry.name)
        self._about.setText("" if entry is None else _about(entry.kind))
        self.preview.show_text("" if entry is None else entry.text, from_end=entry is not None and entry.kind in ("log", "transcript"))

    def _show_total(self) -> None:
        state = self._support.state
        give_role(self.said, "bad" if state.refused is not None else "muted")
        if state.refused is not None:
            self.said.setText(" ".join(sentence_of(state.refused)))
        elif state.written is not None:
            self.said.setText(self.tr("Saved as {path}.").format(path=fmt.short_path(str(state.written))))
        elif state.bundle is None:
            self.said.setText(self.tr("Collecting…") if state.fraction is not None else "")
        else:
            kept = state.bundle.without(self.left_out())
            total = sum(len(entry.content) for entry in kept.entries)
            taken = ", ".join(f"{mark} {fmt.count(times)}" for mark, times in sorted(kept.replaced.items()))
            words = self.tr("{size} in {n} entries. Replaced: {taken}.").format(size=_size(total), n=len(kept.entries), taken=taken or "–")
            self.said.setText(words)

    def _choose(self) -> None:
        start = Path.home() / f"impronta-support-{wall_clock.today().isoformat()}.zip"
        choose_new_file(self, self.tr("Save the support bundle"), str(start), self.tr("Archives (*.zip)"), "zip", self._save)

    def _save(self, path: Path) -> None:
        self._support.save(path, self.left_out())


def _about(kind: str) -> str:
    """What an entry is, for a person."""
    words = {
        "log": QCoreApplication.translate("support", "What the program noted, the newest at the end."),
        "machine": QCoreApplication.translate("support", "Versions, system, processors, memory, graphics."),
        "rig": QCoreApplication.translate("support", "The rig as it is used, with its calibration."),
        "transcript": QCoreApplication.translate("support", "What program and controller said to each other: seconds, direction, line."),
        "doctor": QCoreApplication.translate("support", "What was checked without moving anything, each with its remedy."),
        "settings": QCoreApplication.translate("support", "Without folders, recent cases and orders."),
        "cases": QCoreApplication.translate("support", "How large the cases are and when they changed; nothing of what is in them."),
    }
    return words[kind]


def _size(size_bytes: int) -> str:
    if size_bytes < 1000:
        return f"{size_bytes} B"
    return f"{fmt.decimal(size_bytes / 1000, 1)} kB" if size_bytes < 1_000_000 else f"{fmt.decimal(size_bytes / 1e6, 1)} MB"
