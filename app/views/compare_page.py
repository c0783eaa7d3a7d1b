"""Compare: two surfaces side by side, what moved between them, and whether that can be trusted."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QDragEnterEvent, QDragLeaveEvent, QDragMoveEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QStackedWidget, QVBoxLayout, QWidget

from app.controllers.surface_reading import Role, loaded_of
from app.graphics_import import import_graphics
from app.services import Services
from app.views.alignment_panel import AlignmentPanel
from app.views.compare_foot import CompareFoot
from app.views.compare_stage import CompareStage
from app.views.comparison_picture import ComparisonPicture
from app.views.drop_target import DropTarget, arrow
from app.views.file_dialogs import choose_file, choose_folder
from app.views.findings_panel import FindingsPanel
from app.views.page import Page
from app.views.parts import button, label, row, scrolled, seam
from app.views.surfaces_panel import SurfacesPanel
from app.views.verdict import Verdict

if TYPE_CHECKING:
    from app.views.comparison_scene import ComparisonScene
    from scanner_core.comparison.surface import ComparedSurface

WIDTH = 340
SUFFIXES = (".stl", ".ply", ".obj", ".vtp", ".3mf", ".impronta")
ROLES: tuple[Role, Role] = ("before", "after")


class ComparePage(Page):
    """Fills the window: drop targets, then the 3D view, and three panels beside them."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.setAcceptDrops(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._comparing = services.comparing
        self.scene: ComparisonScene | None = None
        self._preparing = False
        self._dragging = False
        self._pair: tuple[ComparedSurface, ComparedSurface] | None = None
        self.stage = CompareStage()
        self.targets = self._make_targets()
        self._empty = self._make_empty()
        self.stage.put(self._empty)
        self.picture = ComparisonPicture(services, self.stage)
        self.surfaces = SurfacesPanel(services, self._choose_file)
        self.alignment = AlignmentPanel(services)
        self.findings = FindingsPanel(services)
        self.verdict = Verdict()
        self.foot = CompareFoot(services, self._save_report)
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addWidget(self.stage, 1)
        box.addWidget(seam(upright=True))
        box.addWidget(self._make_inspector())
        self._connect()
        self._show()

    # -------------------------------------------------------------------------------- the page
    def entered(self) -> None:
        self._show_cases()
        self._show()
        self.setFocus()  # for the space bar

    def paint_scene(self) -> float:
        return 0.0 if self.scene is None or self.scene.closed else self.scene.paint()

    def close_scene(self) -> None:
        if self.scene is not None:
            self.scene.close_scene()

    def look(self, view: str) -> bool:
        self.picture.look({"front": "frontal", "top": "occlusal"}.get(view, view))
        return True

    def show_panel(self, name: str) -> None:
        """``surfaces``, ``alignment`` or ``findings``."""
        self._panels.setCurrentIndex(list(self.tabs).index(name))
        self.tabs[name].setChecked(True)

    # -------------------------------------------------------------------------------- parts
    def _make_targets(self) -> dict[Role, DropTarget]:
        reading = self._comparing.reading
        words = {
            "before": (self.tr("Before"), self.tr("The state that everything is compared with")),
            "after": (self.tr("After"), self.tr("The state whose changes are shown")),
        }
        return {
            role: DropTarget(
                *words[role],
                open_file=partial(self._choose_file, role),
                open_case=partial(reading.take_open_case, role),
                chosen=partial(reading.read, role),
            )
            for role in ROLES
        }

    def _make_empty(self) -> QWidget:
        made = QWidget()
        line = row(self.targets["before"], arrow(), self.targets["after"], spacing=12)
        line.setStretch(0, 1)
        line.setStretch(2, 1)
        line.setContentsMargins(24, 24, 24, 24)
        made.setLayout(line)
        return made

    def _make_inspector(self) -> QWidget:
        self._panels = QStackedWidget()
        self.tabs: dict[str, QPushButton] = {}
        for name, text, panel in (
            ("surfaces", self.tr("Surfaces"), self.surfaces),
            ("alignment", self.tr("Alignment"), self.alignment),
            ("findings", self.tr("Findings"), self.findings),
        ):
            made = button(text, "choice", partial(self.show_panel, name))
            made.setCheckable(True)
            made.setAutoExclusive(True)
            made.setStyleSheet("padding: 7px 4px;")
            self.tabs[name] = made
            self._panels.addWidget(scrolled(panel))
        whole = QWidget()
        whole.setFixedWidth(WIDTH)
        box = QVBoxLayout(whole)
        box.setContentsMargins(16, 13, 16, 14)
        box.setSpacing(9)
        box.addWidget(label(self.tr("Compare"), "title"))
        box.addWidget(self.verdict)
        box.addLayout(row(*self.tabs.values(), spacing=6))
        box.addWidget(self._panels, 1)
        box.addWidget(seam())
        box.addWidget(self.foot)
        self.show_panel("surfaces")
        return whole

    def _connect(self) -> None:
        comparing = self._comparing
        comparing.draft.changed.connect(self._show)
        comparing.reading.changed.connect(self._show)
        comparing.answers.changed.connect(self._show_state)
        comparing.answers.answered.connect(self._show_answer)
        comparing.tooth.changed.connect(self._show_tooth)
        comparing.points.changed.connect(self._show_points)
        comparing.report.changed.connect(self.foot.show_state)
        comparing.kept.connect(self.foot.show_state)
        comparing.keeping.changed.connect(self.surfaces.show_kept)
        self.services.case.opened.connect(self._show_cases)
        self.services.case.meshed.connect(self._show_cases)
        self.alignment.tool_wanted.connect(self.picture.take_tool)
        self.alignment.stable_wanted.connect(self.picture.show_stable)
        self.findings.tool_wanted.connect(self.picture.take_tool)
        self.findings.areas.wanted.connect(self.picture.fly_to)
        self.picture.tool_taken.connect(self.alignment.show_tool)
        self.picture.tool_taken.connect(self.findings.show_tool)
        self.picture.tool_taken.connect(self.foot.show_tool)

    # -------------------------------------------------------------------------------- showing
    def _show(self) -> None:
        comparing = self._comparing
        choice, reading = comparing.draft.choice, comparing.reading.reading
        for role in ROLES:
            self.targets[role].show_surface(loaded_of(choice, role), reading.get(role))
        self.surfaces.show_choice()
        self.alignment.show_choice()
        self.findings.show_choice()
        self.picture.show_choice()
        if choice.before is not None or choice.after is not None:
            self._prepare_scene()
        self._show_state()

    def _show_state(self) -> None:
        """Progress, and what stands in the middle."""
        answers = self._comparing.answers
        picking = self._comparing.points.active
        self.verdict.show_comparison(None if picking else answers.comparison, current=answers.current)
        self.foot.show_state()
        self.tabs["findings"].setEnabled(not picking)  # they belong to the answer that is not seen meanwhile
        seen = answers.comparison is not None and not self._dragging and not picking
        self.stage.show_seen(seen)
        self.stage.show_part(self.scene if seen or picking else self._empty)

    def _show_answer(self) -> None:
        comparison = self._comparing.answers.comparison
        self.findings.show_comparison(comparison)
        self.alignment.show_comparison(comparison)
        self.picture.show_comparison(comparison)
        pair = None if comparison is None else (comparison.before, comparison.after)
        if pair != self._pair:
            self._pair = pair
            self.show_panel("surfaces" if pair is None else "findings")
        self._show_state()

    def _show_tooth(self) -> None:
        self.findings.show_choice()
        self.picture.show_choice()

    def _show_points(self) -> None:
        self.picture.show_points()
        self.alignment.show_choice()
        self.findings.show_choice()
        if self._comparing.points.active:
            self.show_panel("alignment")
        self._show_state()

    def _show_cases(self) -> None:
        case = self.services.case
        name = case.path.stem if case.path is not None and case.surface is not None else None
        for target in self.targets.values():
            target.show_cases(name, self.services.settings.recent_cases)

    # -------------------------------------------------------------------------------- the 3D view
    def _prepare_scene(self) -> None:
        """The first surface is there: by the time of the result the 3D view will be, too."""
        if self.scene is None and not self._preparing:
            self._preparing = True
            self.stage.show_waiting(self.tr("Preparing the 3D view…"))
            work = partial(import_graphics, "app.views.comparison_scene")
            self.services.background.run("import-comparison-3d", work, lambda _: self._put_scene(), self._unprepared)

    def _unprepared(self, fault: Exception) -> None:
        """The next edit tries again."""
        self._preparing = False
        self.stage.show_waiting(self.tr("There is no 3D view; the numbers stand beside it."))
        self._comparing.tell(fault)

    def _put_scene(self) -> None:
        from app.views.comparison_scene import ComparisonScene

        self.scene = ComparisonScene()
        self.stage.put(self.scene)
        self.scene.area_clicked.connect(self.findings.areas.choose)
        self.picture.put_scene(self.scene)
        self.scene.warm_up()
        self._show_state()

    # -------------------------------------------------------------------------------- files
    def _choose_file(self, role: Role) -> None:
        title = self.tr("The surface before") if role == "before" else self.tr("The surface after")
        kinds = self.tr("Surfaces ({kinds})").format(kinds=" ".join(f"*{suffix}" for suffix in SUFFIXES))
        choose_file(self, title, self.services.settings.export_folder, kinds, lambda path: self._comparing.reading.read(role, path))

    def _save_report(self) -> None:
        comparison = self._comparing.answers.comparison
        if comparison is not None:
            report = self._comparing.report
            choose_folder(self, self.tr("Folder for the report"), report.start_folder, lambda folder: report.write(comparison, folder))

    def take_files(self, paths: list[Path], role: Role | None) -> None:
        """Dropped files: one for `role`, or for the place that is free; two are before and after, in their order."""
        strange = [path.name for path in paths if path.suffix.lower() not in SUFFIXES]
        paths = [path for path in paths if path.suffix.lower() in SUFFIXES]
        kinds = self.tr("A surface is an STL, PLY, OBJ, VTP or 3MF file, or a case.")
        if strange:
            self.noted.emit(self.tr("{names}: not read.").format(names=", ".join(strange)), kinds)
        elif len(paths) > 2:
            left = ", ".join(path.name for path in paths[2:])
            self.noted.emit(self.tr("{names}: not read.").format(names=left), self.tr("Two surfaces are compared: the first two files were taken."))
        if len(paths) >= 2:
            for each, path in zip(ROLES, paths, strict=False):
                self._comparing.reading.read(each, path)
        elif paths:
            free: Role = "before" if self._comparing.draft.choice.before is None and "before" not in self._comparing.reading.reading else "after"
            self._comparing.reading.read(role or free, paths[0])

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self.picture.flicker()
        else:
            super().keyPressEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802 - Qt's name
        if _files(event):
            event.acceptProposedAction()
            self._dragging = True
            self._show_state()

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:  # noqa: N802 - Qt's name
        over = self._over(event)
        for role, target in self.targets.items():
            target.light(role == over)

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:  # noqa: N802 - Qt's name
        self._end_drag()

    def dropEvent(self, event: QDropEvent) -> None:  # noqa: N802 - Qt's name
        over = self._over(event)
        event.acceptProposedAction()
        self._end_drag()
        self.take_files(_files(event), over)

    def _over(self, event: QDropEvent) -> Role | None:
        place = event.position().toPoint()
        return next((role for role, target in self.targets.items() if target.rect().contains(target.mapFrom(self, place))), None)

    def _end_drag(self) -> None:
        self._dragging = False
        for target in self.targets.values():
            target.light(False)
        self._show_state()


def _files(event: QDropEvent) -> list[Path]:
    return [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
