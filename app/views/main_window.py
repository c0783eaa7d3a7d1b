"""The window: rail, 3D view, the current page, banner and status line; it connects them and computes nothing."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QHBoxLayout, QMainWindow, QStackedWidget, QVBoxLayout, QWidget

from app.actions import fill_menus, make_actions
from app.controllers.support import SupportController
from app.services import Services
from app.undo import UndoHistory
from app.views import format as fmt
from app.views.activity import activity_words
from app.views.banner import Banner
from app.views.coverage_page import CoveragePage
from app.views.file_dialogs import choose_file
from app.views.home_page import HomePage
from app.views.laser_lamps import LaserLamps
from app.views.mounts_page import MountsPage
from app.views.page import Page
from app.views.pages import ASIDE, FOOT, PAGES
from app.views.parts import seam
from app.views.rail import Rail
from app.views.reconstruction_words import reconstruction_words
from app.views.scene_link import SceneLink
from app.views.stage import Stage
from app.views.status_line import StatusLine
from app.views.support_dialog import SupportDialog
from app.views.window_help import WindowHelp
from scanner_core.acquisition.plan import PlanRequest

if TYPE_CHECKING:
    from app.views.scene_view import SceneView

SIZE = (1280, 800)


class MainWindow(QMainWindow):
    """Every page of the registry, made once."""

    closing = Signal()
    """Sent once, before anything is taken down."""

    def __init__(self, services: Services, undo: UndoHistory) -> None:
        super().__init__()
        self.services = services
        self._undo = undo
        self._support: SupportDialog | None = None
        self.setWindowTitle("Impronta")
        self.actions_by_id = make_actions(self)
        fill_menus(self.menuBar(), self.actions_by_id)
        self.banner = Banner(self.show_support)
        self.rail = Rail(PAGES, FOOT, self.show_page, self.laser_off)
        self.stage = Stage(
            [self.actions_by_id[name] for name in ("show_points", "show_surface", "show_edges", "show_uncertainty", "fit", "front", "top")]
        )
        self.pages: dict[str, Page] = {}
        self._stack = QStackedWidget()
        for info in (*PAGES, *FOOT, *ASIDE):
            page = info.make(services)
            page.wanted.connect(self.show_page)
            page.intent.connect(self._do)
            page.noted.connect(self.banner.tell_note)
            self.pages[info.id] = page
            self._stack.addWidget(page)
        self._link = SceneLink(services, self.stage, self.actions_by_id, lambda: self.pages[self.page_id], self)
        for page in self.pages.values():
            page.aside_changed.connect(self._link.show_aside)
            page.flight.connect(lambda points, normal: self._link.call(lambda scene: scene.fly_to(points, normal)))
        self._stage_seam = seam(upright=True)
        middle = QHBoxLayout()
        middle.setSpacing(0)
        middle.addWidget(self.stage, 1)
        middle.addWidget(self._stage_seam)
        middle.addWidget(self._stack)
        right = QVBoxLayout()
        right.setSpacing(0)
        right.addWidget(self.banner)
        right.addLayout(middle, 1)
        upper = QHBoxLayout()
        upper.setSpacing(0)
        upper.addWidget(self.rail)
        upper.addWidget(seam(upright=True))
        upper.addLayout(right, 1)
        self.status_line = StatusLine(self._open_reconstructed)
        self.laser = LaserLamps(services, self.rail, self.status_line)
        whole = QWidget()
        box = QVBoxLayout(whole)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addLayout(upper, 1)
        box.addWidget(self.status_line)
        self.setCentralWidget(whole)
        size = services.settings.window
        self.resize(*(size if len(size) == 2 else SIZE))
        self.help = WindowHelp(whole, self._stack, self.rail, self.pages, services.background)
        self._connect()
        self.show_page(PAGES[0].id)
        for name in ("show_points", "show_surface"):
            self.actions_by_id[name].setChecked(True)
        self._show_rig()
        self._show_undo()

    # -------------------------------------------------------------------------------- the 3D view
    @property
    def scene(self) -> SceneView | None:
        """None until its libraries are loaded."""
        return self._link.scene

    def put_scene(self, scene: SceneView) -> None:
        """The 3D view is there."""
        self._link.put_scene(scene)

    def paint_scene(self) -> float:
        """For the pump."""
        self.laser.show()
        return 0.0 if self.scene is None else self.scene.paint()

    # -------------------------------------------------------------------------------- slots of the action table
    def show_page(self, page_id: str) -> None:
        info = next(info for info in (*PAGES, *FOOT, *ASIDE) if info.id == page_id)
        page = self.pages[page_id]
        beside = bool(info.stage)
        if beside:
            self._stack.setFixedWidth(page.minimumWidth())
            self.stage.show_title(QCoreApplication.translate("pages", info.stage))
        self._stack.setCurrentWidget(page)
        self.stage.setVisible(beside)
        self._stage_seam.setVisible(beside)
        if not beside:
            self._stack.setMinimumWidth(0)
            self._stack.setMaximumWidth(16_777_215)
        self.rail.show_page(info.of or page_id)
        self.help.show_page(page_id)
        self._show_whose()
        page.entered()
        self._link.show_aside()

    @property
    def page_id(self) -> str:
        current = self._stack.currentWidget()
        return next(name for name, page in self.pages.items() if page is current)

    def new_case(self) -> None:
        """The form of another order; what is open stays so until that is made."""
        self.show_page("home")
        home = self.pages["home"]
        assert isinstance(home, HomePage)
        home.new_order()

    def choose_case(self) -> None:
        choose_file(self, self.tr("Open a case"), self.services.settings.case_folder, self.tr("Cases (*.impronta)"), self.open_case)

    def open_case(self, path: Path) -> None:
        if self.services.acquisition.running:
            self._tell_running()
            return
        self.services.case.open(path)
        self.show_page("reconstruct")

    def show_deliver(self) -> None:
        self.show_page("deliver")

    def set_up_rig(self) -> None:
        self.show_page("assistant")

    def undo(self) -> None:
        self._undo.undo()

    def redo(self) -> None:
        self._undo.redo()

    def start_scan(self) -> None:
        if self.services.acquisition.running:
            return
        self.banner.dismiss()
        self.services.acquisition.start(self._request())

    def _request(self) -> PlanRequest:
        rig, values = self.services.rig.snapshot, self.services.draft.values
        request = PlanRequest(
            views=values.views,
            points=values.points,
            object_radius_mm=rig.specimen_radius_mm,
            object_height_mm=rig.specimen_height_mm,
            until_um=float(values.until_um) if values.until_um else None,
            retry=self.services.settings.retry,
        )
        return self.services.pair_tray.planned(request)

    def show_coverage(self) -> None:
        self.show_page("coverage")

    def fill(self) -> None:
        """Scan on, as the object stands."""
        page = self.pages["coverage"]
        assert isinstance(page, CoveragePage)
        if page.fill.isEnabled():
            self.banner.dismiss()
            self.services.acquisition.fill(float(page.wanted_um.value()), self.services.draft.values.points)

    def show_mounts(self) -> None:
        self.show_page("mounts")

    def scan_mount(self) -> None:
        """The object as it stands now, into the same case."""
        page = self.pages["mounts"]
        assert isinstance(page, MountsPage)
        if page.scan.isEnabled():
            self.banner.dismiss()
            self.services.acquisition.start_mount(self._request())

    def pause_scan(self) -> None:
        self.services.acquisition.pause_or_resume()

    def laser_off(self) -> None:
        """Esc and the stop buttons: from every page, whatever is going on."""
        self.help.dismiss()
        if self.services.acquisition.running:
            self.services.acquisition.stop()
        else:
            self.services.rig.laser_off()
            self.services.assistant.laser_off()

    def start_reconstruction(self) -> None:
        if not self.services.acquisition.running:
            self.banner.dismiss()
            self.show_page("reconstruct")
            self.services.reconstruction.start(self.services.draft.values)

    def view_fit(self) -> None:
        self._link.look("fit")

    def view_front(self) -> None:
        self._link.look("front")

    def view_top(self) -> None:
        self._link.look("top")

    def show_points(self, on: bool) -> None:
        self._link.show_points(on)

    def show_surface(self, on: bool) -> None:
        self._link.show_surface(on)

    def show_edges(self, on: bool) -> None:
        self._link.show_edges(on)

    def show_uncertainty(self, on: bool) -> None:
        self._link.show_uncertainty(on)

    def next_colour(self) -> None:
        self._link.next_colour()

    def show_support(self) -> None:
        if self._support is None:
            support = SupportController(self.services, self)
            self.closing.connect(support.cancel)
            self._support = SupportDialog(support, self)
        self._support.show()
        self._support.raise_()
        self._support.activateWindow()

    def show_about(self) -> None:
        self.help.show_about()

    def show_help(self) -> None:
        self.help.toggle_panel()

    def show_shortcuts(self) -> None:
        self.help.show_shortcuts()

    def show_tour(self) -> None:
        self.show_page(PAGES[0].id)
        self.help.start_tour()

    # -------------------------------------------------------------------------------- inside
    def _tell_running(self) -> None:
        self.banner.tell_note(self.tr("A scan is running."), self.tr("Wait for its end or stop it first (Esc)."))

    def _tell_split(self, counts: dict[str, int]) -> None:
        what = self.tr("Both ears are measured: {left} points on the left one, {right} on the right one.").format(
            left=fmt.count(counts["left"]), right=fmt.count(counts["right"])
        )
        self.banner.tell_note(what, self.tr("Each is an order of its own now; both stand in the worklist."))

    def _tell_meshed(self, path: Path) -> None:
        what = self.tr("The surface of {case} is done.").format(case=path.stem)
        self.banner.tell_note(what, self.tr("It is kept in its case."), self.tr("Open it"), lambda: self.open_case(path))

    def _open_reconstructed(self) -> None:
        """The order whose points are being reconstructed."""
        wanted = self.services.reconstruction.wanted
        if wanted is None or wanted.path in (None, self.services.case.path):
            self.show_page("reconstruct")
        elif wanted.path is not None:
            self.open_case(wanted.path)

    def _do(self, action_id: str) -> None:
        self.actions_by_id[action_id].trigger()

    def _connect(self) -> None:
        services = self.services
        services.draft.changed.connect(lambda _: self._show_order())
        services.rig.changed.connect(self._show_rig)
        services.acquisition.began.connect(self._begin_scan)
        services.case.opened.connect(self._show_case)
        services.case.meshed_elsewhere.connect(self._tell_meshed)
        services.case.edited.connect(self._show_activity)
        self._link.shown.connect(self._show_activity)
        self._link.shown.connect(self._show_actions)
        for told in (services.reconstruction.began, services.reconstruction.ended, services.reconstruction.changed):
            told.connect(self._show_activity)
        services.comparing.answers.changed.connect(self._show_activity)
        services.comparing.draft.changed.connect(self._show_whose)
        services.assistant.changed.connect(self._show_activity)
        services.verification.changed.connect(self._show_activity)
        for controller in (services.coverage, services.mounts):
            controller.changed.connect(self._show_activity)
        services.mounts.began.connect(self.show_mounts)
        services.pair_tray.split.connect(self._tell_split)
        self._undo.changed.connect(self._show_undo)
        self._show_order()

    def _show_order(self) -> None:
        """Of the open case; what stands in a form is no order yet."""
        self.rail.show_order(self.services.draft.values if self.services.case.store is not None else None)

    def _show_whose(self) -> None:
        """Whose surface is shown: the order's, or those that are compared, which may be another patient's."""
        if self.page_id != "compare":
            self.rail.show_surfaces(None)
            return
        choice = self.services.comparing.draft.choice
        before, after = (None if loaded is None else loaded.surface.name for loaded in (choice.before, choice.after))
        self.rail.show_surfaces((before, after))

    def _show_undo(self) -> None:
        for name, what in (("undo", self._undo.undo_words), ("redo", self._undo.redo_words)):
            action = self.actions_by_id[name]
            action.setEnabled(what is not None)
            plain = self.tr("&Undo") if name == "undo" else self.tr("&Redo")
            action.setText(f"{plain}: {what}" if what else plain)

    def _begin_scan(self) -> None:
        self.show_page("scan")
        self._show_activity()

    def _show_case(self) -> None:
        self._show_order()
        path = self.services.case.path
        self.setWindowTitle(f"{path.stem} – Impronta" if path is not None else "Impronta")
        self._show_activity()
        self._show_actions()

    def _show_actions(self) -> None:
        running, case = self.services.acquisition.running, self.services.case
        self.actions_by_id["pause_scan"].setEnabled(running)
        self.actions_by_id["start_scan"].setEnabled(not running)
        self.actions_by_id["reconstruct"].setEnabled(case.cloud is not None and not running)
        for name in ("show_edges", "show_uncertainty"):
            self.actions_by_id[name].setEnabled(case.surface is not None)

    def _show_activity(self) -> None:
        self.status_line.show_activity(activity_words(self.services))
        self.status_line.show_reconstruction(reconstruction_words(self.services.reconstruction))

    def _show_rig(self) -> None:
        self.status_line.show_rig(self.services.rig.snapshot)
        self._show_activity()

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        self.services.settings.window = [self.width(), self.height()]
        self.closing.emit()
        super().closeEvent(event)
