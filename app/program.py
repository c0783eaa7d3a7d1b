"""The running program: makes services, window and pump, and takes them down in one order."""

from __future__ import annotations

import gc
import logging
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from PySide6.QtCore import QByteArray, QObject, QTimer
from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import QApplication

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.aiming import AimController
from app.controllers.assistant import AssistantController
from app.controllers.case import CaseController
from app.controllers.comparing import Comparing
from app.controllers.coverage import CoverageController
from app.controllers.delivery import DeliveryController
from app.controllers.editing import EditingController
from app.controllers.live_surface import LiveSurfaceController
from app.controllers.measurements import Measurements
from app.controllers.mount_picks import MountPicks
from app.controllers.mounts import MountsController
from app.controllers.pair_tray import PairTrayController
from app.controllers.preferences import Preferences
from app.controllers.readiness import ReadinessController
from app.controllers.reconstruction import ReconstructionController
from app.controllers.recovery import RecoveryController
from app.controllers.rig import RigController
from app.controllers.shading import Shading
from app.controllers.verification import VerificationController
from app.controllers.worklist import WorklistController
from app.draft import Draft, DraftValues, first_order
from app.event_log import EventLog
from app.faults import install_hooks, remove_hooks
from app.graphics_import import import_graphics
from app.heartbeat import Heartbeat
from app.language import Translation, spoken
from app.pump import Pump
from app.services import Services
from app.settings import load_settings, settings_path
from app.stop_key import StopKey
from app.theme import icon, set_theme
from app.undo import UndoHistory
from app.views.activity import is_busy
from app.views.main_window import MainWindow
from scanner_core.log_file import log_fault, log_versions
from scanner_core.user_folders import cache_folder

_DEADLINE_S = 8.0
_SWITCH_S = 0.001
"""A scan's threads give Python's lock to the window after so long; with Python's own 5 ms every slot waits longer."""
_log = logging.getLogger("impronta")


@dataclass(frozen=True, slots=True, eq=False)
class Again:
    """Where a window was that is made anew in another language."""

    case: Path | None
    page: str
    order: DraftValues
    geometry: QByteArray


class Program(QObject):
    """One window and everything behind it."""

    def __init__(
        self,
        application: QApplication,
        *,
        started_s: float,
        heartbeat_file: Path | None = None,
        case: Path | None = None,
        settings_file: Path | None = None,
        after: Again | None = None,
    ) -> None:
        super().__init__()
        sys.setswitchinterval(_SWITCH_S)
        self._started_s = started_s
        self._heartbeat_file = heartbeat_file
        self._settings_file = settings_file or settings_path()
        self._first_run = not self._settings_file.exists()
        self._closed = False
        self.again: Again | None = None
        """The window was closed so that it be made anew, as this."""
        self._application = application
        self.settings = load_settings(self._settings_file)
        application.setApplicationName("Impronta")
        application.setWindowIcon(icon("mark"))
        self._translation = Translation(application, self.settings.language)
        set_theme(application, self.settings.theme)
        application.styleHints().colorSchemeChanged.connect(self._follow_system)
        self.background = Background()
        self.pump = Pump(self)
        self.heartbeat = Heartbeat(self)
        self.undo_stack, self.compare_stack, settings_stack = QUndoStack(self), QUndoStack(self), QUndoStack(self)
        self._stacks = (self.undo_stack, self.compare_stack, settings_stack)
        preferences = Preferences(self.settings, self._settings_file, settings_stack, self)
        draft = Draft(self.undo_stack, self)
        rig = RigController(self.background, self._settings_file.parent / "rigs", self.tell, self, known=self.settings.own_rigs)
        cases = CaseController(self.background, self.settings, draft, self.tell, self, settings_file=self._settings_file)
        acquisition = AcquisitionController(self.background, rig, cases, self.tell, self)
        reconstruction = ReconstructionController(self.background, cases, self.tell, self)
        delivery = DeliveryController(self.background, preferences, draft, cases, self.tell, self)
        comparing = Comparing(self.background, self.settings, self.compare_stack, cases, self.tell, self)
        recovery = RecoveryController(self.background, self.settings, cases, acquisition, self.tell, self)
        assistant = AssistantController(self.background, rig, self.tell, self)
        live = LiveSurfaceController(self.background, acquisition, self)
        coverage = CoverageController(self.background, cases, acquisition, self.tell, self)
        mounts = MountsController(self.background, cases, acquisition, rig, self.tell, self)
        picks = MountPicks(self.compare_stack, mounts, self)
        worklist = WorklistController(self.background, self.settings, cases, self._cache_folder(), self.tell, self)
        readiness = ReadinessController(self.background, rig, self.settings, self)
        aiming = AimController(self.background, rig, self.compare_stack, self._settings_file.parent / "materials", self.tell, self)
        editing = EditingController(self.background, cases, acquisition, self.tell, self)
        self.services = Services(
            self.settings,
            draft,
            self.background,
            rig,
            cases,
            acquisition,
            reconstruction,
            delivery,
            comparing,
            recovery,
            assistant,
            live,
            coverage,
            mounts,
            picks,
            preferences,
            readiness,
            worklist,
            PairTrayController(cases, worklist, acquisition, rig, self.tell, self),
            Draft(self.undo_stack, self),
            aiming,
            editing,
            Measurements(self.background, cases, self.tell, self),
            VerificationController(self.background, rig, self.tell, self),
        )
        draft.load(first_order(self.settings.last_order) if after is None else after.order)
        live.allow(self.settings.live_surface)
        preferences.changed.connect(self._take_preference)
        self._event_log = EventLog(self.services, self)
        self.window = MainWindow(self.services, UndoHistory(*self._stacks, draft, cases, self))
        self.window.closing.connect(self.shut_down)
        rig.mended.connect(self.window.banner.retract)
        self._stop_key = StopKey(self.window.laser_off, self.window.rail.stop_button, self)
        application.installEventFilter(self._stop_key)
        install_hooks(self._show)
        self._shading = Shading(self.background)
        pages = [page.tick for page in self.window.pages.values()]
        drains = (self.background.drain, acquisition.drain, reconstruction.drain, comparing.drain, coverage.drain, mounts.drain, editing.drain)
        for source in (*drains, live.tick, self._shading.tick, *pages):
            self.pump.add_source(source)
        for painter in (self.window.paint_scene, *(page.paint_scene for page in self.window.pages.values())):
            self.pump.add_painter(painter)
        self.pump.start()
        if heartbeat_file is not None:
            self.heartbeat.start()
        if after is not None:
            self.window.restoreGeometry(after.geometry)
        self.window.show()
        QTimer.singleShot(0, lambda: self._painted(case, after))

    def tell(self, fault: BaseException) -> None:
        """From any thread: the sentence into the banner, the details into the log too."""
        log_fault(fault, "window")
        self._show(fault)

    def _show(self, fault: BaseException) -> None:
        self.background.post(lambda: self.window.banner.tell_fault(fault))

    def _cache_folder(self) -> Path:
        """Beside settings of one's own, else where the system keeps such things."""
        own = self._settings_file != settings_path()
        return self._settings_file.parent / "cache" if own else cache_folder()

    def _take_preference(self, name: str) -> None:
        """What was set is in force from now on."""
        if name == "theme":
            self._restyle(self.settings.theme)
        elif name == "live_surface":
            self.services.live_surface.allow(self.settings.live_surface)
        elif name == "language" and spoken(self.settings.language) != self._translation.language and not is_busy(self.services):
            window = self.window
            self.again = Again(self.services.case.path, window.page_id, self.services.draft.values, window.saveGeometry())
            QTimer.singleShot(0, window.close)

    def _follow_system(self) -> None:
        """The desktop has changed between dark and light."""
        if self.settings.theme == "system" and not self._closed:
            self._restyle("system")

    def _restyle(self, theme: str) -> None:
        """Every widget is told some twenty things, none of which is a key: a filter that sees them all would make it take much longer."""
        self._application.removeEventFilter(self._stop_key)
        try:
            set_theme(self._application, theme)
        finally:
            self._application.installEventFilter(self._stop_key)

    # -------------------------------------------------------------------------------- start
    def _painted(self, case: Path | None, after: Again | None) -> None:
        """The window stands on the screen: now the slow things may begin."""
        self.window.repaint()
        self.heartbeat.notes["first_window_s"] = time.perf_counter() - self._started_s
        self.background.run("versions", log_versions)
        self.background.run("import-3d", partial(import_graphics, "app.views.scene_view"), lambda _: self._make_scene())
        self.services.rig.choose(preset=self.settings.preset, specimen=self.settings.specimen, speed=self.settings.speed)
        if case is not None:
            self.window.open_case(case)
        if after is not None:
            self.window.show_page(after.page)
        elif self._first_run:
            self.services.preferences.keep()  # shown once
            self.window.show_tour()
        self.services.recovery.look()
        self.services.worklist.look()

    def _make_scene(self) -> None:
        if self._closed:
            return
        from app.views.scene_view import SceneView

        scene = SceneView()
        self.window.put_scene(scene)
        scene.warm_up()
        self._shading.watch(scene)
        self.services.live_surface.watch(scene)
        self.heartbeat.notes["scene_s"] = time.perf_counter() - self._started_s
        self.services.reconstruction.prewarm()
        gc.freeze()  # what is here stays: looking through its 300,000 objects for garbage would stop every thread for 0.1 s
        self.heartbeat.forget()  # what is measured begins after the first 3D picture

    # -------------------------------------------------------------------------------- end
    def shut_down(self) -> None:
        """Pump, runner and capture, laser and devices, job, case, 3D view, window; may be called again.

        A step that raises or is late is logged, and the others are still taken: none of them may leave laser, rig or case open.
        """
        if self._closed:
            return
        self._closed = True
        services = self.services
        steps: tuple[tuple[str, Callable[[], object]], ...] = (
            ("pump", self.pump.stop),
            ("heartbeat", self._end_heartbeat),
            ("recovery", services.recovery.shutdown),
            ("worklist", services.worklist.shutdown),
            ("scan", lambda: services.acquisition.shutdown(_DEADLINE_S)),
            ("reference sphere", lambda: services.verification.shutdown(_DEADLINE_S)),
            ("assistant", lambda: services.assistant.shutdown(_DEADLINE_S)),
            ("rig", lambda: services.rig.shutdown(_DEADLINE_S)),
            ("live surface", services.live_surface.shutdown),
            ("reconstruction", services.reconstruction.shutdown),
            ("comparison", services.comparing.shutdown),
            ("coverage", services.coverage.shutdown),
            ("mounts", services.mounts.shutdown),
            ("delivery", services.delivery.shutdown),
            ("editing", services.editing.shutdown),
            ("measurements", services.measurements.cancel),
            ("case", lambda: services.case.shutdown(_DEADLINE_S)),
            ("shading", lambda: self._shading.close(_DEADLINE_S)),
            ("background", self._end_background),
            ("scene", self._end_scene),
            ("settings", self._keep_settings),
            ("hooks", self._end_hooks),
            ("window", self._end_window),
            ("garbage", gc.unfreeze),
        )
        for name, step in steps:
            try:
                if step() is False:
                    _log.error("still running at the end: %s", name)
            except Exception:
                _log.exception("the end of: %s", name)

    def _end_heartbeat(self) -> None:
        self.heartbeat.stop()
        if self._heartbeat_file is not None:
            self.heartbeat.write(self._heartbeat_file)

    def _end_background(self) -> None:
        late = self.background.join(_DEADLINE_S)
        if late:
            _log.error("still running at the end: %s", ", ".join(late))

    def _end_scene(self) -> None:
        if self.window.scene is not None:
            self.window.scene.close_scene()
        for page in self.window.pages.values():
            page.close_scene()

    def _keep_settings(self) -> None:
        rig = self.services.rig.snapshot
        self.settings.preset, self.settings.specimen, self.settings.speed = rig.preset, rig.specimen, rig.speed
        self.services.preferences.keep()

    def _end_hooks(self) -> None:
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self._stop_key)
        remove_hooks()
        self._event_log.close()
        self._translation.remove()

    def _end_window(self) -> None:
        for stack in self._stacks:
            stack.blockSignals(True)  # it tells of its own end, when the window may be gone already
        self.window.close()
