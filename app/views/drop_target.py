"""Where one of the two surfaces is put: by dropping a file, choosing one, or out of a case."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

from app.comparison_draft import LoadedSurface
from app.controllers.case_files import read_case_name
from app.views import format as fmt
from app.views.parts import button, label

RECENT = 4


class DropTarget(QFrame):
    """A frame with a dashed edge; calls `open_file()`, `open_case()` and `chosen(path)`.  The page takes the drops themselves."""

    def __init__(
        self, title: str, what: str, *, open_file: Callable[[], None], open_case: Callable[[], None], chosen: Callable[[Path], None]
    ) -> None:
        super().__init__()
        self.setProperty("role", "target")
        self._chosen = chosen
        self._name = label("", wrap=True)
        self._name.setStyleSheet("font-weight: 600;")
        self._facts = label("", "muted", wrap=True)
        self._file = button(self.tr("Choose a file…"), "", open_file, "folder")
        self._case = button(self.tr("The open case"), "", open_case, "reconstruct")
        self._recent_title = label(self.tr("Recent cases"), "section")
        self._recent = QWidget()
        self._recent_box = QVBoxLayout(self._recent)
        self._recent_box.setContentsMargins(0, 0, 0, 0)
        self._recent_box.setSpacing(2)
        box = QVBoxLayout(self)
        box.setContentsMargins(26, 24, 26, 20)
        box.setSpacing(8)
        box.addWidget(label(title, "headline"))
        box.addWidget(label(what, "muted", wrap=True))
        box.addSpacing(10)
        box.addWidget(self._name)
        box.addWidget(self._facts)
        box.addSpacing(6)
        box.addWidget(self._file)
        box.addWidget(self._case)
        box.addSpacing(8)
        box.addWidget(self._recent_title)
        box.addWidget(self._recent)
        box.addStretch(1)
        self.light(False)

    def light(self, on: bool) -> None:
        """A file is held over it."""
        self.setProperty("lit", on)
        self.style().unpolish(self)
        self.style().polish(self)

    def show_surface(self, loaded: LoadedSurface | None, reading: str | None) -> None:
        """What stands there, or is being read."""
        if reading is not None:
            name, facts = reading, self.tr("Reading…")
        elif loaded is None:
            name, facts = self.tr("Drop a file here"), self.tr("STL, PLY, OBJ, VTP, 3MF, or a case")
        else:
            name = loaded.surface.name
            facts = self.tr("{n} triangles").format(n=fmt.count(len(loaded.surface.mesh.triangles)))
        self._name.setText(name)
        self._facts.setText(facts)

    def show_cases(self, open_case: str | None, recent: list[str]) -> None:
        """The open case by its name, and paths of recent ones."""
        self._case.setVisible(open_case is not None)
        self._case.setToolTip(open_case or "")
        while (item := self._recent_box.takeAt(0)) is not None:
            part = item.widget()
            if part is not None:
                part.deleteLater()
        there = [path for path in map(Path, recent) if path.is_file()][:RECENT]
        for path in there:
            told = read_case_name(path.stem)
            made = button(told.order if told else path.stem, "link", partial(self._chosen, path))
            made.setToolTip(str(path))
            self._recent_box.addWidget(made, 0, Qt.AlignmentFlag.AlignLeft)
        self._recent_title.setVisible(bool(there))

    @property
    def texts(self) -> tuple[str, str]:
        return self._name.text(), self._facts.text()


def arrow() -> QLabel:
    """Between the two targets: what is before and what is after."""
    return label("→", "arrow")
