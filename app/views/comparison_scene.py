"""The 3D view of a comparison: two surfaces, what differs between them, and the ways to look at it.

Import this module in a thread first: pyvista alone takes seconds.  Three renderers share one camera: the background, the
surface before and, above it, the surface after with a depth of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.theme import look
from app.views.compared_actor import ComparedActor
from app.views.comparison_camera import ComparisonCamera
from app.views.comparison_captions import ComparisonCaptions
from app.views.comparison_marks import ComparisonMarks, Landmark
from app.views.comparison_overlay import ComparisonOverlay
from app.views.comparison_tools import ComparisonTools
from app.views.drawn_surface import DrawnSurface
from app.views.interactor import InteractorView
from app.views.section_cut import SectionCut
from app.views.surface_picker import SurfacePicker
from app.views.viewpoint import Viewpoint
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import DeviationScale

Array = NDArray[np.float64]

MODES: Final = ("map", "side_by_side", "curtain", "flicker", "blend", "morph", "before", "after")
BEFORE_COLOUR: Final = "#cbb894"
AFTER_COLOUR: Final = "#dfe3e6"
_COLOURED = ("map", "side_by_side", "curtain")
_SLOW_S = 0.04


class ComparisonScene(InteractorView):
    """Both surfaces in the frame of BEFORE; call :meth:`paint` once a tick of the pump."""

    hovered = Signal(object)
    """:class:`Pointed`, or None beside the surfaces."""
    picked = Signal(object)
    """:class:`Pointed` of a click."""
    painted = Signal(object, bool)
    """Vertices (n,) int64 of the after surface under the brush, and whether they are added or taken away."""
    stroke_ended = Signal()
    """The brush was lifted."""
    lassoed = Signal(object)
    """Visible vertices (n,) int64 of the after surface within the lasso."""
    area_clicked = Signal(int)
    """The rank whose label was clicked."""
    amount_changed = Signal(float)
    """The curtain was dragged."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        engine = self._open()
        engine.enable_trackball_style()
        self._before, self._after = ComparedActor(BEFORE_COLOUR), ComparedActor(AFTER_COLOUR)
        self._overlay = ComparisonOverlay(self)
        self._overlay.setGeometry(self.rect())
        self._marks, self._section = ComparisonMarks(self._after, self._overlay), SectionCut()
        self._under, self._over = vtkRenderer(), vtkRenderer()
        window = engine.render_window
        window.SetNumberOfLayers(3)
        engine.renderer.SetInteractive(False)
        for layer, renderer in enumerate((self._under, self._over), 1):
            renderer.SetLayer(layer)
            renderer.SetActiveCamera(engine.camera)
            window.AddRenderer(renderer)
        self._under.AddActor(self._before.actor)
        self._over.AddActor(self._after.first)
        self._over.AddActor(self._after.actor)
        for line in (*self._marks.lines, *self._section.lines):
            self._over.AddActor(line.actor)
        self._mode, self._amount, self._other = "map", 0.5, False
        self._scale: DeviationScale | None = None
        self._signed = self._level = np.zeros(0)
        self._camera = ComparisonCamera(engine.camera)
        self._coarse = False
        self._captions = ComparisonCaptions(self._overlay)
        self._tools = ComparisonTools(self, engine, self._overlay)
        self._arrange()
        self.restyle()

    def restyle(self) -> None:
        self._open().set_background(look.panel)  # a gradient costs as much as ten thousand triangles
        self._dirty = True

    # -------------------------------------------------------------------------------- what is shown
    def show_pair(self, before: DrawnSurface, after: DrawnSurface) -> None:
        """Both surfaces, `after` already in the frame of BEFORE; no map yet.

        The camera sees everything, or stays where it is when `before` is the surface that is shown already.
        """
        known = self._before.drawn is not None and self._before.drawn.mesh is before.mesh
        self.clear()
        self._before.show(before)
        self._after.show(after)
        self._arrange()
        if not known:
            self.look("occlusal")

    def clear(self) -> None:
        """Neither surface, and nothing about them."""
        self._open()
        self._before.show(None)
        self._after.show(None)
        self._scale, self._signed, self._level = None, np.zeros(0), np.zeros(0)
        self._camera.stop()
        self._marks.clear()
        self.set_section(np.zeros(3), None)
        self._arrange()

    def show_deviation(
        self, signed_um: Array, level_um: Array, stable: NDArray[np.bool_], counterpart: NDArray[np.bool_], scale: DeviationScale | None
    ) -> None:
        """Colour the after surface: (v_after,) deviation um (NaN without counterpart), level of detection um, stable, counterpart."""
        self._open()
        self._signed, self._level, self._scale = np.where(counterpart, signed_um, np.nan), level_um, scale
        self._after.show_values(signed_um, level_um, counterpart & np.isfinite(signed_um))
        self._after.show_stable(stable)
        self._arrange()

    def show_feet(self, feet_mm: Array) -> None:
        """Where the after surface's vertices start from in the morph, (v_after, 3) mm; NaN stays in its place.

        Their feet on the before surface, or better, in a part whose motion is known, where that motion came from.
        """
        self._after.show_feet(feet_mm)
        self._dirty = True

    def show_stable(self, on: bool) -> None:
        """Dots where the alignment rests."""
        self._after.set_stable_shown(on)
        self._dirty = True

    def show_mask(self, mask: NDArray[np.bool_] | None) -> None:
        """What is painted, (v_after,)."""
        self._after.show_painted(mask)
        self._dirty = True

    def show_part(self, outline: Any) -> None:
        """The marked tooth: its outline, lines as VTK has them or None."""
        self._marks.show_part(outline)
        self._dirty = True

    def show_areas(self, areas: Sequence[Area], outlines: Sequence[Any]) -> None:
        """Ranks, and the outline of each as VTK has it or None."""
        self._marks.show_areas(areas, outlines)
        self._dirty = True

    def select_area(self, rank: int | None) -> None:
        """The area that is spoken of."""
        self._marks.choose(rank)
        self._dirty = True

    def show_landmarks(self, points: Sequence[Landmark]) -> None:
        """Named points."""
        self._marks.show_landmarks(points)
        self._dirty = True

    def show_threshold(self, lines: Any, scale: DeviationScale | None = None) -> None:
        """The line on the map, as VTK has it or None for none, and the colours that have an edge there, where they are others."""
        self._marks.show_threshold(lines)
        self._scale = scale or self._scale
        self._arrange()

    # -------------------------------------------------------------------------------- ways to look
    @property
    def mode(self) -> str:
        return self._mode

    @property
    def amount(self) -> float:
        """Of curtain, blend and morph: 0 is all before, 1 all after; the curtain stands that far from the right."""
        return self._amount

    def set_mode(self, mode: str) -> None:
        """One of `MODES`."""
        if mode not in MODES:
            raise ValueError(mode)
        aspect = self._aspect()
        self._mode, self._other = mode, False
        if self._aspect() != aspect:
            self._camera.keep(self._points(), aspect, self._aspect())
        self._arrange()

    def set_amount(self, amount: float) -> None:
        """0 to 1."""
        self._amount = min(max(amount, 0.0), 1.0)
        self._arrange()

    def show_other(self, on: bool) -> None:
        """The before surface in place of the after surface: the flicker."""
        self._other = on
        self._arrange()

    @property
    def shows_other(self) -> bool:
        return self._other

    def set_tool(self, tool: str) -> None:
        """``look``, ``pick``, ``paint``, ``erase`` or ``lasso``: what the left button of the mouse does."""
        self._tools.set_tool(tool)

    def set_section(self, origin: Sequence[float] | Array, normal: Sequence[float] | Array | None) -> None:
        """A plane through `origin` (mm) across `normal`: the near half goes, both contours show; no normal, no section.

        Without perspective while there is one: lengths across the line of sight are then true, and a bar tells them.
        """
        self._section.set_plane(np.asarray(origin, np.float64), None if normal is None else np.asarray(normal, np.float64))
        self._camera.set_parallel(self._section.active)
        self._cut()

    def set_section_offset_mm(self, offset_mm: float) -> None:
        """Move the section along its normal from where it was set."""
        self._section.set_offset_mm(offset_mm)
        self._cut()

    # -------------------------------------------------------------------------------- camera
    def set_axes(self, axes: Array | None, upper: bool | None = None) -> None:
        """Columns right, anterior and occlusal of the arch (3, 3), frame of BEFORE; whether it is an upper jaw, if that is known."""
        self._camera.set_axes(axes, upper)
        self._dirty = True

    def look(self, view: str) -> None:
        """``occlusal``, ``frontal``, ``left``, ``right``, ``lingual`` or ``underside``, everything in the picture."""
        self._camera.look(view, self._points(), self._aspect())
        self._coarsen(self._moving)

    def fit(self) -> None:
        """Everything in the picture, from where the camera looks."""
        self._camera.fit(self._points(), self._aspect())
        self._coarsen(self._moving)

    def fly_to(self, area: Area) -> None:
        """Look at an area from outside, in a moment; a person's hand on the camera ends the flight."""
        self._camera.fly_to(area, self._places(area), self._aspect())
        self._dirty = True

    def face_section(self, area: Area | None) -> None:
        """Look straight at the section, from the side to which its normal points, at an area or at all of the contours."""
        points = self._section.contour if area is None else self._places(area)
        if len(points):
            self._camera.face(self._section.normal, points, self._aspect())
            self._dirty = True

    @property
    def flying(self) -> bool:
        return self._camera.flying

    # -------------------------------------------------------------------------------- painting
    def paint(self) -> float:
        """As :meth:`InteractorView.paint`; 0 while a person turns the scene, so that nothing else is waited for."""
        self._dirty |= self._camera.flying
        taken_s = super().paint()
        return 0.0 if self._moving or self._camera.flying else taken_s

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        super().resizeEvent(event)
        self._overlay.setGeometry(self.rect())
        self._overlay.raise_()
        self._tools.brush.stand()
        self._arrange()

    # -------------------------------------------------------------------------------- for the tools
    def viewpoint(self, x: float, y: float) -> tuple[str, Viewpoint] | None:
        """Which surface is meant at a pixel, and how it is seen there."""
        before, after = self._viewpoints()
        if self._mode == "side_by_side":
            return ("before", before) if before.contains(x, y) else ("after", after)
        if self._mode == "curtain":
            return ("before" if x < self.curtain_x else "after", after)
        if self._mode == "before" or self._other:
            return "before", before
        return ("after", after) if self._mode in ("map", "flicker", "after", "blend") or self._amount >= 1 else None

    def picker(self, surface: str) -> SurfacePicker | None:
        """Rays into a surface."""
        drawn = (self._before if surface == "before" else self._after).drawn
        return None if drawn is None else drawn.picker

    def after_depth(self) -> NDArray[np.float32]:
        """How far the after surface is at every device pixel (h, w), 0 near to 1 far."""
        self._marks.set_seen(False, False)
        for line in self._section.lines:
            line.set_shown(False)
        depth = self.grab_depth()
        for line in self._section.lines:
            line.set_shown(True)
        self._arrange()
        return depth

    def ray(self, view: Viewpoint, x: float, y: float) -> tuple[Array, Array]:
        """The line of sight through a pixel, as far as the section leaves it."""
        near, far = view.ray(x, y)
        normal, offset = self._section.kept(self._open().camera)
        start, end = near @ normal - offset, far @ normal - offset
        if start > 0 > end:
            near = near + (far - near) * (start / (start - end))
        return near, far

    @property
    def values(self) -> tuple[Array, Array] | None:
        """Deviation and level of detection of the after surface's vertices, um, once they are known."""
        return (self._signed, self._level) if len(self._signed) else None

    @property
    def coloured(self) -> bool:
        """The after surface is shown as a map."""
        return self._mode in _COLOURED and self._scale is not None

    @property
    def curtain_x(self) -> float:
        return self.width() * (1.0 - self._amount)

    # -------------------------------------------------------------------------------- inside
    def _interact(self, moving: bool) -> None:
        super()._interact(moving)
        self._camera.stop()
        self._coarsen(moving)

    def _prepare_picture(self) -> None:
        camera = self._open().camera
        if self._camera.advance():
            self._coarsen(self._camera.flying)
        points = self._points()
        if points is not None:
            low, high = points.min(axis=0), points.max(axis=0)
            self._over.ResetCameraClippingRange(low[0], high[0], low[1], high[1], low[2], high[2])
        self._overlay.readout = self._overlay.twin = None  # of what was under the pointer before
        ratio = self.devicePixelRatioF()
        normal, offset = self._section.kept(camera)
        for actor in (self._before, self._after):
            actor.set_cut(normal.tolist(), offset)
            actor.set_pixel_ratio(ratio)
        for line in self._marks.lines:
            line.set_cut(normal, offset)
        for line in (*self._marks.lines, *self._section.lines):
            line.set_pixel_ratio(ratio)
        first, second = self._viewpoints()
        self._marks.place(first, second, (normal, offset), self.curtain_x if self._mode == "curtain" else 0.0)
        views = (first, second) if self._mode == "side_by_side" else (second,)
        self._captions.measure(views, points, self._camera.right, bool(camera.GetParallelProjection()))

    def _coarsen(self, moving: bool) -> None:
        """Fewer triangles while something moves, if a picture takes long here."""
        self._coarse = moving and (self._coarse or self.paint_s > _SLOW_S)
        for actor in (self._before, self._after):
            actor.set_coarse(self._coarse)
        self._after.first.SetVisibility(self._mode == "blend" and self._after.drawn is not None and not self._coarse)
        self._dirty = True

    def _arrange(self) -> None:
        """Everything that mode and amount decide."""
        mode, amount, pair = self._mode, self._amount, self._after.drawn is not None
        before = pair and (mode in ("side_by_side", "curtain", "blend", "before") or self._other)
        after = pair and mode != "before" and not self._other
        halves = mode == "side_by_side"
        self._under.SetViewport(0.0, 0.0, 0.5 if halves else 1.0, 1.0)
        self._over.SetViewport(0.5 if halves else 0.0, 0.0, 1.0, 1.0)
        self._under.SetInteractive(halves or not after)
        self._over.SetInteractive(after)
        self._before.actor.SetVisibility(before)
        self._after.actor.SetVisibility(after)
        self._after.first.SetVisibility(after and mode == "blend")
        ratio = self.devicePixelRatioF()
        x, side = (self.curtain_x * ratio, 1) if mode == "curtain" else (0.0, 0)
        self._before.set_curtain(x, -side)
        for seen in (self._after, *self._marks.lines):
            seen.set_curtain(x, side)
        self._after.set_morph(amount if mode == "morph" else 1.0)
        self._after.set_fade(amount if mode == "blend" else 1.0)
        self._after.show_scale(self._scale if self.coloured else None)
        self._marks.set_seen(after and (mode != "morph" or amount == 1.0), self.coloured)
        for line in self._section.lines:  # the contours belong to either surface
            if halves or not after:
                self._under.AddActor(line.actor)
            else:
                self._under.RemoveActor(line.actor)
        self._captions.name(mode if pair else None, other=self._other, curtain_x=self.curtain_x, section=self._section.active)
        self._dirty = True

    def _viewpoints(self) -> tuple[Viewpoint, Viewpoint]:
        camera = self._open().camera
        width, height = float(self.width()), float(self.height())
        if self._mode == "side_by_side":
            half = 0.5 * width
            return Viewpoint.of(camera, 0.0, 0.0, half, height), Viewpoint.of(camera, half, 0.0, half, height)
        whole = Viewpoint.of(camera, 0.0, 0.0, width, height)
        return whole, whole

    def _points(self) -> Array | None:
        few = [actor.drawn.few for actor in (self._before, self._after) if actor.drawn is not None]
        return np.concatenate(few) if few else None

    def _places(self, area: Area) -> Array:
        drawn = self._after.drawn
        return np.asarray(area.centroid_mm)[None] if drawn is None or not len(area.vertices) else drawn.mesh.vertices[area.vertices]

    def _aspect(self) -> float:
        return self.width() * (0.5 if self._mode == "side_by_side" else 1.0) / max(self.height(), 1)

    def _cut(self) -> None:
        self._section.show((self._before.drawn, self._after.drawn))
        self._arrange()
