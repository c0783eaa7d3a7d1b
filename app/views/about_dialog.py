"""What this program is, whose method it follows, and the licences of everything in it."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialog, QListWidget, QListWidgetItem, QPlainTextEdit, QSplitter, QVBoxLayout, QWidget

from app.background import Background
from app.theme import Sign
from app.views.parts import button, column, label, row
from scanner_core import __version__
from scanner_core.support.libraries import Library, shipped_libraries


class AboutDialog(QDialog):
    """Beside the window, never modal, so that the stop button works."""

    def __init__(self, background: Background, parent: QWidget) -> None:
        super().__init__(parent)
        self.libraries: tuple[Library, ...] = ()
        self.setWindowTitle(self.tr("About Impronta"))
        self.setWindowModality(Qt.WindowModality.NonModal)
        self.resize(860, 600)
        self._version = label(self.tr("Impronta {version}").format(version=__version__), "headline", selectable=True)
        what = label(
            self.tr(
                "Measures an object with two cameras and a laser spot, and turns the points into a closed surface: ear impressions, dental models."
            ),
            wrap=True,
        )
        method = label(
            self.tr(
                "The method is the published one of G. Tognola et al., “Contact-less 3D-Coordinate Measurement System by Laser Scanning and "
                "Image Reconstruction from Unorganized Data”: two cameras see a laser spot, and a surface adapts itself to the points."
            ),
            "muted",
            wrap=True,
            selectable=True,
        )
        licence = label(self.tr("Impronta itself is free software under the MIT licence."), "muted")
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Libraries in this program"))
        self.list.currentRowChanged.connect(self._show_text)
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setAccessibleName(self.tr("Text of the licence"))
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.list)
        split.addWidget(self.text)
        split.setChildrenCollapsible(False)
        split.setStretchFactor(1, 1)
        split.setSizes([310, 520])
        self.copy = button(self.tr("Copy versions"), "", self._copy)
        self.copy.setToolTip(self.tr("Names and versions of everything in this program, as text"))
        close = button(self.tr("Close"), "", self.close)
        mark = Sign(40, "mark", "accent")
        head = row(mark, column(self._version, what, method, licence, spacing=6), spacing=14)
        head.setStretch(1, 1)
        head.setAlignment(mark, Qt.AlignmentFlag.AlignTop)
        box = QVBoxLayout(self)
        box.setContentsMargins(20, 18, 20, 16)
        box.setSpacing(10)
        box.addLayout(head)
        box.addSpacing(4)
        box.addWidget(label(self.tr("Libraries and their licences"), "section"))
        box.addWidget(split, 1)
        box.addLayout(row(1, self.copy, close))
        self.copy.setEnabled(False)
        background.run("licences", shipped_libraries, self._fill)

    def _fill(self, libraries: tuple[Library, ...]) -> None:
        self.libraries = libraries
        for library in libraries:
            item = QListWidgetItem(f"{library.name} {library.version}\n{library.licence}".strip())
            self.list.addItem(item)
        self.list.setCurrentRow(0)
        self.copy.setEnabled(True)

    def _show_text(self, place: int) -> None:
        if 0 <= place < len(self.libraries):
            self.text.setPlainText(self.libraries[place].text or self.tr("Its package brings no text of the licence along."))

    def _copy(self) -> None:
        lines = [f"Impronta {__version__}", *(f"{library.name} {library.version} ({library.licence})" for library in self.libraries)]
        QApplication.clipboard().setText("\n".join(lines) + "\n")
