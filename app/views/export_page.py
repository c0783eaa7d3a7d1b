"""Export: format, name from the template, folder; nothing is overwritten unasked."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QButtonGroup, QLineEdit, QPushButton, QToolButton, QVBoxLayout

from app.controllers.export import FORMATS, ExportFormat
from app.file_names import FIELDS, free_name
from app.services import Services
from app.theme import icon
from app.views import format as fmt
from app.views.file_dialogs import choose_folder
from app.views.page import Page
from app.views.parts import button, label, row, seam
from scanner_core import wall_clock


class ExportPage(Page):
    """Stands beside what is exported."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._format = FORMATS[0]
        box = self.inspector(self.tr("Export"))
        box.addWidget(label(self.tr("Format"), "section"))
        group = QButtonGroup(self)
        self._formats: dict[str, QPushButton] = {}
        kinds = QVBoxLayout()
        kinds.setSpacing(6)
        first: list[QPushButton] = []
        for kind in FORMATS:
            choice = button(QCoreApplication.translate("export", kind.title), "choice", partial(self._choose, kind))
            choice.setCheckable(True)
            choice.setToolTip(QCoreApplication.translate("export", kind.use))
            group.addButton(choice)
            self._formats[kind.suffix] = choice
            first.append(choice)
        kinds.addLayout(row(*first[:3], spacing=6))
        kinds.addLayout(row(*first[3:], spacing=6))
        box.addLayout(kinds)
        self._use = label("", "muted", wrap=True)
        box.addWidget(self._use)
        box.addSpacing(4)
        box.addWidget(seam())
        box.addWidget(label(self.tr("Folder"), "section"))
        self._folder = QLineEdit(fmt.short_path(services.settings.export_folder))
        self._folder.setAccessibleName(self.tr("Folder"))
        self._folder.textChanged.connect(self._show)
        browse = QToolButton()
        browse.setIcon(icon("folder"))
        browse.setToolTip(self.tr("Choose a folder"))
        browse.setAccessibleName(self.tr("Choose a folder"))
        browse.clicked.connect(self._browse)
        box.addLayout(row(self._folder, browse, spacing=4))
        box.addWidget(label(self.tr("Name"), "section"))
        self._template = QLineEdit(services.settings.name_template)
        self._template.setAccessibleName(self.tr("Template of the name"))
        self._template.setToolTip(self.tr("In braces: {fields}").format(fields=", ".join(FIELDS)))
        self._template.textChanged.connect(self._show)
        box.addWidget(self._template)
        for field in (self._folder, self._template):
            field.setTextMargins(5, 0, 5, 0)
            field.setMinimumHeight(30)
        self._name = label("", "", wrap=True, selectable=True)
        self._name.setStyleSheet("font-weight: 600;")
        box.addWidget(self._name)
        self._note = label("", "muted", wrap=True)
        box.addWidget(self._note)
        box.addStretch(1)
        self._done = label("", "good", wrap=True, selectable=True)
        self._open = button(self.tr("Show in its folder"), "link", self._show_folder)
        box.addWidget(self._done)
        box.addWidget(self._open)
        box.addWidget(seam())
        self.primary = button(self.tr("Export"), "primary", lambda: self._write(replace=False))
        self._replace = button(self.tr("Replace the existing file"), "", lambda: self._write(replace=True))
        box.addWidget(self._replace)
        box.addWidget(self.primary)
        services.case.opened.connect(self._fresh)
        services.case.meshed.connect(self._fresh)
        services.acquisition.ended.connect(self._show)
        services.export.written.connect(self._show_written)
        services.draft.changed.connect(self._show)
        self._formats[self._format.suffix].setChecked(True)
        self._fresh()

    def entered(self) -> None:
        self._show()

    def path(self) -> Path:
        """Where the next export goes."""
        folder, template = Path(self._folder.text()).expanduser(), self._template.text()
        return free_name(folder, template, self.services.draft.values, self._format.suffix, wall_clock.today())

    # -------------------------------------------------------------------------------- inside
    def _choose(self, kind: ExportFormat) -> None:
        self._format = kind
        self._show()

    def _browse(self) -> None:
        start = str(Path(self._folder.text()).expanduser())
        choose_folder(self, self.tr("Folder for exported files"), start, lambda folder: self._folder.setText(fmt.short_path(str(folder))))

    def _write(self, *, replace: bool) -> None:
        self.services.settings.name_template = self._template.text()
        self.services.export.write(self.path(), points=self._format.points, replace=replace)
        self._show()

    def _fresh(self) -> None:
        self.services.export.last = None
        self._show_written()

    def _show_written(self) -> None:
        last = self.services.export.last
        self._done.setVisible(last is not None)
        self._open.setVisible(last is not None)
        if last is not None:
            self._done.setText(self.tr("Written: {name}, {size:.1f} MB").format(name=last.path.name, size=last.size_bytes / 1e6))
        self._show()

    def _show(self) -> None:
        case, export = self.services.case, self.services.export
        self._use.setText(QCoreApplication.translate("export", self._format.use))
        there = case.cloud is not None if self._format.points else case.surface is not None
        path = self.path()
        self._name.setText(path.name)
        exists = "{rev}" not in self._template.text() and path.exists()
        if not there:
            missing = self.tr("Scan first: there are no points yet."), self.tr("Reconstruct first: there is no surface yet.")
            self._note.setText(missing[0] if self._format.points else missing[1])
        elif exists:
            self._note.setText(self.tr("This file exists already. With {rev} in the name every export gets its own number."))
        elif self._format.points:
            self._note.setText(self.tr("{n} points, millimetres").format(n=fmt.count(len(case.cloud)) if case.cloud is not None else ""))
        elif case.surface is not None:
            low, high = case.surface.mesh.bounds()
            size = " × ".join(f"{length:.1f}" for length in high - low)
            self._note.setText(self.tr("{n} triangles, {size} mm").format(n=fmt.count(len(case.surface.mesh.triangles)), size=size))
        self.primary.setEnabled(there and not exists and not export.busy)
        self._replace.setVisible(there and exists)
        self._replace.setEnabled(not export.busy)

    def _show_folder(self) -> None:
        last = self.services.export.last
        if last is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(str(last.path.parent)))
