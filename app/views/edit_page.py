"""Edit: take points out before they become a surface, and measure what is there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QEvent, QPointF
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import QButtonGroup, QStackedWidget

from app.services import Services
from app.views import format as fmt
from app.views import measure_words
from app.views.aside import Aside
from app.views.comparison_overlay import Tag
from app.views.edit_points_panel import PointsPanel
from app.views.measure_panel import MeasurePanel
from app.views.page import Page
from app.views.parts import button, label, row, scrolled

if TYPE_CHECKING:
    from app.views.drawn_surface import DrawnSurface
    from app.views.edit_aside import EditAside
    from app.views.edit_tools import EditTools
    from app.views.measure_aside import MeasureAside
    from app.views.scene_view import SceneView
    from app.views.surface import Surface
    from scanner_core.measuring.distance import Place

_NEAR_PX = 12.0


class EditPage(Page):
    """Stands beside the 3D view."""

    def __init__(self, services: Services) -> None:
        self._points_aside: EditAside | None = None  # first of all: Qt may tell of the palette while the page is made
        super().__init__(services)
        self._editing, self._case = services.editing, services.case
        self._tools: EditTools | None = None
        self._measure_aside: MeasureAside | None = None
        self._drawn: tuple[Surface, DrawnSurface] | None = None
        self._drawing: Surface | None = None
        self._told_facts = ""
        box = self.inspector(self.tr("Edit"))
        self.points_tab = button(self.tr("Points"), "choice", self._turn)
        self.measure_tab = button(self.tr("Measure"), "choice", self._turn)
        tabs = QButtonGroup(self)
        for made in (self.points_tab, self.measure_tab):
            made.setCheckable(True)
            tabs.addButton(made)
        self.points_tab.setChecked(True)
        box.addLayout(row(self.points_tab, self.measure_tab, spacing=6))
        self.points = PointsPanel(services)
        self.measure = MeasurePanel(services)
        self._stack = QStackedWidget()
        self._stack.addWidget(scrolled(self.points))
        self._stack.addWidget(self.measure)
        box.addWidget(self._stack, 1)
        self.told = label("", "muted", wrap=True)
        box.addWidget(self.told)
        self.accept = button("", "primary", self._accept)
        self.accept.setShortcut("Return")
        self.drop = button(self.tr("Leave them in"), "", self.points.drop_shape)
        self.go_on = button("", "primary", self._go_on)
        for made in (self.accept, self.drop, self.go_on):
            box.addWidget(made)
        self.points.tool_changed.connect(self._show_tool)
        self.points.looks_changed.connect(self._show_points)
        self.measure.looks_changed.connect(self._show_lines)
        self._editing.changed.connect(self._show_points)
        self._editing.changed.connect(self._show_count)
        self._editing.loaded.connect(self._renew)
        services.case.opened.connect(self._renew_measure)
        services.case.meshed.connect(self._renew_measure)
        self._show_state()

    @property
    def measuring(self) -> bool:
        return self.measure_tab.isChecked()

    # -------------------------------------------------------------------------------- for the window
    def entered(self) -> None:
        self._editing.want(True)
        self._prepare_surface()
        self._show_state()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._points_aside is not None:
            self._show_points()

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        super().hideEvent(event)
        self._editing.want(False)
        self.points.drop_shape()
        self._let_go()

    def aside(self) -> Aside | None:
        """The points, or what is measured on."""
        editing = self._editing
        if self.services.acquisition.running:
            return None
        if self.measuring:
            return self._made_measure_aside()
        if editing.points is None:
            return None
        if self._points_aside is None or self._points_aside.points is not editing.points:
            from app.views.edit_aside import EditAside

            self._points_aside = EditAside(editing.points)
            self._points_aside.show(editing.out, editing.marked, out_too=self.points.out_too.isChecked())
        return self._points_aside

    def facts(self) -> str:
        editing = self._editing
        if editing.points is None or (self.measuring and self._case.surface is not None):
            return ""
        return self.tr("{n} points").format(n=fmt.count(len(editing.out) - int(editing.out.sum())))

    def meet_scene(self, scene: SceneView) -> None:
        if scene.aside is None:
            self._let_go()
            return
        if self._tools is None:
            from app.views.edit_tools import EditTools

            self._tools = EditTools(scene, np.zeros(3))
            self._tools.begun.connect(self._begin)
            self._tools.drawn.connect(self._editing.draw)
            self._tools.ended.connect(self._end)
            self._tools.pointed.connect(self._point)
            scene.moved.connect(self._thin)
        if (bounds := scene.aside.bounds_mm) is not None:
            self._tools.set_middle_mm(bounds.mean(axis=0))
        self._show_tool()
        self._show_lines()

    # -------------------------------------------------------------------------------- what a person does
    def _turn(self) -> None:
        self._stack.setCurrentIndex(int(self.measuring))
        if self.measuring:
            self.points.drop_shape()
        self._prepare_surface()
        self._show_state()
        self.aside_changed.emit()

    def _accept(self) -> None:
        if self._editing.gain:
            self._editing.accept()
            self.points.drop_shape()

    def _go_on(self) -> None:
        if self._case.surface is None or self._case.outdated:
            self.intent.emit("reconstruct")
        else:
            self.wanted.emit("reconstruct")

    def _begin(self) -> None:
        if self._tools is None:
            return
        from scanner_core.editing.sight import Sight

        view = self._tools.scene.whole_view()
        sight = Sight(view.matrix, view.width, view.height, view.direction)
        self._thin(True)
        self._editing.begin_stroke(sight, back=self.points.back.isChecked(), through=self.points.through.isChecked())

    def _end(self) -> None:
        self._thin(False)
        self._editing.end_stroke()

    def _point(self, x: float, y: float) -> None:
        place = self._place_at(x, y)
        if place is not None:
            self.measure.point(place)

    def _place_at(self, x: float, y: float) -> Place | None:
        """What lies under a pixel: of the surface, or the foremost point."""
        from scanner_core.editing.sight import Sight
        from scanner_core.measuring.distance import Place

        aside, tools = self._measure_aside, self._tools
        if aside is None or tools is None:
            return None
        view = tools.scene.whole_view()
        if aside.drawn is not None:
            hit = aside.drawn.picker.hit(*view.ray(x, y))
            return None if hit is None else Place.of_mesh(aside.drawn.mesh, hit.vertex, hit.point)
        if aside.cloud is None:
            return None
        from scanner_core.editing.screen_region import nearest_in_front

        sight = Sight(view.matrix, view.width, view.height, view.direction)
        number = nearest_in_front(aside.cloud.points, sight, np.array([x, y]), _NEAR_PX)
        return None if number is None else Place.of_cloud(aside.cloud, number)

    # -------------------------------------------------------------------------------- showing
    def _show_tool(self) -> None:
        if self._tools is not None:
            tool = "point" if self.measuring else self.points.tool
            self._tools.set_tool(tool, back=self.points.back.isChecked())

    def _show_points(self) -> None:
        aside, editing = self._points_aside, self._editing
        if aside is not None and aside.points is editing.points and self.isVisible():
            aside.show(editing.out, editing.marked, out_too=self.points.out_too.isChecked())
            self.points.draw_shape(aside)
            self._touch()
        self._show_state()

    def _show_lines(self) -> None:
        aside = self._measure_aside
        if aside is not None and self.measuring:
            aside.show_lines([line for item in self.services.measurements.items for line in measure_words.lines_of(item)], self.measure.lines_now())
            self._touch()
        if self._tools is not None and not self.measuring:
            self._tools.overlay.tags = []
            self._tools.overlay.update()

    def _show_tags(self) -> None:
        """Before every picture: the numbers of the measurements beside them."""
        tools = self._tools
        if tools is None or not self.measuring or tools.scene.closed:
            return
        view = tools.scene.whole_view()
        tags = []
        for number, item in enumerate(self.services.measurements.items, 1):
            lines = measure_words.lines_of(item)
            if lines and len(lines[0]):
                at = view.project(lines[0][[len(lines[0]) // 2]])[0] if item["kind"] != "distance" else view.project(lines[0].mean(axis=0)[None])[0]
                spot = QPointF(at[0] + 34, at[1] - 22)
                tags.append(Tag(f"{number}  {measure_words.value(item)}", QPointF(*at), spot))
        tools.overlay.tags = tags
        tools.overlay.update()

    def _show_state(self) -> None:
        editing, case = self._editing, self._case
        gain = editing.gain if self.points.shape else 0
        proposing = bool(self.points.shape) and not self.measuring
        self.accept.setText(self.tr("Take out {n} points").format(n=fmt.count(gain)))
        self.accept.setVisible(proposing)
        self.accept.setEnabled(gain > 0 and gain < len(editing.out) - int(editing.out.sum()))
        self.drop.setVisible(proposing)
        self.go_on.setVisible(not proposing and not self.measuring)
        self.go_on.setText(self.tr("Reconstruct") if case.surface is None or case.outdated else self.tr("Go on to the surface"))
        self.go_on.setEnabled(editing.able)
        if editing.points is None:
            self.told.setText(self.tr("Reading the points…") if editing.loading else self.tr("Scan an object or open a case first."))
        elif case.outdated:
            self.told.setText(self.tr("The surface was made when other points were taken out. Reconstruct it again."))
        else:
            self.told.setText("")
        self.told.setVisible(bool(self.told.text()) and not (self.measuring and editing.points is None))
        surface = case.surface
        self.measure.show_content(None if surface is None else surface.mesh, able=surface is not None or editing.points is not None)

    def _thin(self, moving: bool) -> None:
        if self._points_aside is not None and self.isVisible():
            self._points_aside.thin(moving)

    def _touch(self) -> None:
        if self._tools is not None:
            self._tools.scene.touch()

    # -------------------------------------------------------------------------------- inside
    def _let_go(self) -> None:
        tools, self._tools = self._tools, None
        if tools is not None:
            tools.scene.moved.disconnect(self._thin)
            tools.let_go()

    def _show_count(self) -> None:
        """The title over the view tells how many points are left: after an undo these are known later than the case's."""
        if self.isVisible() and self.facts() != self._told_facts:
            self._told_facts = self.facts()
            self.aside_changed.emit()

    def _renew(self) -> None:
        self._measure_aside = None
        if self.isVisible():
            self.aside_changed.emit()
        self._show_state()

    def _renew_measure(self) -> None:
        self._measure_aside = None
        if self.isVisible():
            self._prepare_surface()
            if self.measuring:
                self.aside_changed.emit()
        self._show_state()

    def _prepare_surface(self) -> None:
        """The surface made ready to be pointed at, away from the window."""
        surface = self._case.surface
        if not self.measuring or surface is None or self._drawing is surface or (self._drawn is not None and self._drawn[0] is surface):
            return
        self._drawing = surface

        def work() -> DrawnSurface:
            from app.views.drawn_surface import DrawnSurface

            return DrawnSurface.of(surface.mesh)

        def done(drawn: DrawnSurface) -> None:
            self._drawing = None
            if surface is self._case.surface:
                self._drawn, self._measure_aside = (surface, drawn), None
                if self.isVisible():
                    self.aside_changed.emit()

        self.services.background.run("measured-surface", work, done)

    def _made_measure_aside(self) -> Aside | None:
        surface, editing = self._case.surface, self._editing
        ready = self._drawn if surface is not None and self._drawn is not None and self._drawn[0] is surface else None
        if surface is not None and ready is None:
            return self._points_aside if editing.points is not None else None
        if ready is None and editing.points is None:
            return None
        if self._measure_aside is None:
            from app.views.measure_aside import MeasureAside

            self._measure_aside = MeasureAside(ready, editing.points, None if editing.points is None else ~editing.out)
            self._measure_aside.pictured = self._show_tags
        return self._measure_aside
