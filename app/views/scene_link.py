"""What the 3D view shows: it follows scan, reconstruction, case and page, and the actions of the View menu."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction

from app.colouring import Colouring
from app.services import Services
from app.views import format as fmt
from app.views.page import Page
from app.views.point_colour import SurfaceColour
from app.views.scan_words import status_words
from app.views.stage import Stage
from app.views.surface import Surface

if TYPE_CHECKING:
    from app.views.scene_view import SceneView


class SceneLink(QObject):
    """Everything that comes before there is a 3D view is shown once it is there."""

    shown = Signal()
    """There is another case, surface or state of the scan: what can be done with it may be another."""

    def __init__(self, services: Services, stage: Stage, actions: Mapping[str, QAction], page: Callable[[], Page], parent: QObject) -> None:
        super().__init__(parent)
        self._services, self._stage, self._actions, self._page = services, stage, actions, page
        self.scene: SceneView | None = None
        self.colouring = Colouring(services.settings, self)
        stage.legend.offer(self.colouring)
        self.colouring.changed.connect(self._colour)
        actions["show_uncertainty"].setChecked(self.colouring.surface is SurfaceColour.UNCERTAINTY)
        self._told_s = 0.0
        self._follows = False
        self._late = False
        services.acquisition.began.connect(self._begin_scan)
        services.acquisition.changed.connect(self._show_scan)
        services.acquisition.ended.connect(self._end_scan)
        services.acquisition.add_point_sink(lambda points: self.call(lambda scene: scene.append_points(points)))
        services.case.opened.connect(self.show_case)
        services.case.meshed.connect(self._show_mesh)
        for told in (services.reconstruction.began, services.case.opened, services.acquisition.began, services.acquisition.ended):
            told.connect(self._follow_reconstruction)
        services.reconstruction.began.connect(self._begin_reconstruction)
        services.reconstruction.grown.connect(self._grow)
        services.reconstruction.ended.connect(self._end_reconstruction)

    def put_scene(self, scene: SceneView) -> None:
        """The 3D view is there: show what has come meanwhile."""
        self.scene = scene
        self._stage.put_scene(scene)
        scene.coloured.connect(self._show_legend)
        self._colour()
        self.show_case()
        self.show_aside()

    def call(self, call: Callable[[SceneView], Any]) -> None:
        """Do something with the 3D view, if there is one."""
        if self.scene is not None:
            call(self.scene)

    # -------------------------------------------------------------------------------- actions of the View menu
    def look(self, view: str) -> None:
        """Turn the view of the page, or that of the case: ``fit``, ``front`` or ``top``."""
        if not self._page().look(view):
            self.call(lambda scene: {"fit": scene.view_fit, "front": scene.view_front, "top": scene.view_top}[view]())

    def show_points(self, on: bool) -> None:
        self.call(lambda scene: scene.set_points_visible(on))
        self._show_legend()

    def show_surface(self, on: bool) -> None:
        self._services.live_surface.want(on)
        self.call(lambda scene: scene.set_surface_visible(on))

    def show_edges(self, on: bool) -> None:
        self.call(lambda scene: scene.set_edges(on))

    def show_uncertainty(self, on: bool) -> None:
        self.colouring.choose(SurfaceColour.UNCERTAINTY if on else SurfaceColour.SUPPORT)

    def next_colour(self) -> None:
        """Of the points, or of the surface where it alone is to be seen."""
        bare = self.scene is not None and self.scene.mesh.surface is not None and not self._actions["show_points"].isChecked()
        self.colouring.next(of_surface=bare)

    def _colour(self) -> None:
        by_uncertainty = self.colouring.surface is SurfaceColour.UNCERTAINTY
        self._actions["show_uncertainty"].setChecked(by_uncertainty)
        self.call(lambda scene: scene.colour_points_by(self.colouring.points))
        self.call(lambda scene: scene.set_uncertainty(by_uncertainty))
        self._show_legend()

    # -------------------------------------------------------------------------------- what is shown
    def show_case(self) -> None:
        """Everything of the open case, after it was opened or closed; later where something else is shown in its place."""
        self._late = self.scene is not None and self.scene.aside is not None and self._page().aside() is not None
        if self._late:
            self._show_facts()
            self.shown.emit()
            return
        scene, case = self.scene, self._services.case
        if scene is not None:
            config = self._services.rig.snapshot.config
            if not self._services.acquisition.running:
                scene.clear()
                if case.cloud is not None:
                    scene.show_cloud(case.cloud)
            if config is not None:
                scene.show_table(config.volume.radius_mm)
            self._show_mesh()

    def show_aside(self) -> None:
        """What the page shows in the place of the case."""
        self.call(lambda scene: scene.show_aside(self._page().aside()))
        if self.scene is not None and self._late and self.scene.aside is None:
            self.show_case()
        self.call(self._page().meet_scene)
        if not self._services.acquisition.running:
            self._show_facts()
        self._show_legend()

    def _show_mesh(self) -> None:
        case = self._services.case
        surface = None if self._services.acquisition.running else case.surface
        if surface is not None:
            self._actions["show_points"].setChecked(False)
        elif case.cloud is not None:  # they were hidden for the surface of the order before
            self._actions["show_points"].setChecked(True)
        self.call(lambda scene: scene.show_mesh(surface))
        self._show_facts()
        self._show_legend()
        self.shown.emit()

    def _show_facts(self) -> None:
        case = self._services.case
        if facts := self._page().facts():
            self._stage.show_facts(facts)
        elif case.surface is not None:
            self._stage.show_facts(self.tr("{n} triangles").format(n=fmt.count(len(case.surface.mesh.triangles))))
        elif case.cloud is not None:
            self._stage.show_facts(self.tr("{n} points").format(n=fmt.count(len(case.cloud))))
        else:
            self._stage.show_facts("")

    def _show_legend(self) -> None:
        self._stage.legend.show_scene(self.scene, points=self._actions["show_points"].isChecked())

    # -------------------------------------------------------------------------------- scan and reconstruction
    def _begin_scan(self) -> None:
        self.call(lambda scene: scene.clear())
        self.call(lambda scene: scene.set_live(True))
        self._actions["show_points"].setChecked(True)

    def _show_scan(self) -> None:
        now = time.monotonic()
        if self._services.acquisition.running and now - self._told_s < 0.1:
            return
        self._told_s = now
        status = self._services.acquisition.status
        if status is not None:
            self._stage.show_facts(status_words(status))
        self._show_legend()
        self.shown.emit()

    def _end_scan(self) -> None:
        self.call(lambda scene: scene.set_live(False))
        cloud = self._services.case.cloud
        if cloud is not None:  # the live points are those before the views were registered
            self.call(lambda scene: scene.replace_cloud(cloud))
        self.shown.emit()

    def _follow_reconstruction(self) -> None:
        """Whether the points of the open case are being reconstructed: only then the balloon is what is looked at."""
        job, scanning = self._services.reconstruction, self._services.acquisition.running
        self.call(lambda scene: scene.set_live(job.mine or scanning))
        follows = job.mine and not scanning  # into the same case again: the live points are what is looked at
        if follows != self._follows:
            self._follows = follows
            self.call(lambda scene: scene.set_points_quiet(follows))

    def _grow(self, surface: Surface) -> None:
        if self._follows:
            self.call(lambda scene: scene.show_mesh(surface))

    def _begin_reconstruction(self) -> None:
        if self._services.reconstruction.mine:
            self.call(lambda scene: scene.show_mesh(None))
            self._actions["show_points"].setChecked(True)

    def _end_reconstruction(self) -> None:
        job, case = self._services.reconstruction, self._services.case
        self._follow_reconstruction()
        if job.wanted is not None and job.wanted.path == case.path and not job.succeeded:  # else the finished one comes in a moment
            self.call(lambda scene: scene.show_mesh(case.surface))
