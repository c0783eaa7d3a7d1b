"""Between the comparison and its 3D view: what is drawn, and what a person does in it."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.comparison_draft import LoadedSurface, Mask
from app.services import Services
from app.views.compare_stage import VIEWS, CompareStage
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import DeviationScale
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Frame, Jaw
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform

if TYPE_CHECKING:
    from app.views.comparison_marks import Landmark
    from app.views.comparison_scene import ComparisonScene
    from app.views.drawn_comparison import DrawnComparison
    from app.views.drawn_surface import DrawnSurface
    from app.views.pointed import Pointed

T = TypeVar("T")
Array = NDArray[np.float64]

COLOURED = ("map", "side_by_side", "curtain")
"""The ways to look in which the surface after is a map."""
_TOOLS = {"look": "look", "tooth": "pick", "paint": "paint", "erase": "erase", "lasso_add": "lasso", "lasso_remove": "lasso"}


class ComparisonPicture(QObject):
    """Draws the answer that is there, once the 3D view is there, too."""

    tool_taken = Signal(str)
    """Another tool is in hand."""

    def __init__(self, services: Services, stage: CompareStage) -> None:
        super().__init__(stage)
        self._comparing, self._stage, self._background = services.comparing, stage, services.background
        self._scene: ComparisonScene | None = None
        self._shown: Comparison | None = None
        self.tool = "look"
        self._chosen: Area | None = None
        self._axes = np.eye(3)
        self._upper: bool | None = None
        self._half_mm = 0.0
        self._drawn: tuple[DrawnSurface, DrawnSurface] | None = None
        self._turn = 0
        self._threshold_um = 0
        self._tooth: Mask | None = None
        self._painted: Mask | None = None
        self._stable_shown = False
        self._stroke: tuple[Mask, bool] | None = None
        self.between: RigidTransform | None = None
        """Where the surface after is shown while points are picked, from its own frame to that of BEFORE; None at other times."""
        stage.mode_wanted.connect(self._take_mode)
        stage.amount_wanted.connect(lambda share: self._with(lambda scene: scene.set_amount(share)))
        stage.view_wanted.connect(self.look)
        stage.section_wanted.connect(self._section)
        stage.section_moved.connect(self._move_section)

    @property
    def drawn(self) -> bool:
        """What there is to see is in the 3D view."""
        return self._shown is None or self._drawn is not None

    # -------------------------------------------------------------------------------- showing
    def put_scene(self, scene: ComparisonScene) -> None:
        """The 3D view is there: show what has come meanwhile."""
        self._scene = scene
        scene.hovered.connect(self._hover)
        scene.picked.connect(self._pick)
        scene.painted.connect(self._paint)
        scene.stroke_ended.connect(self._end_stroke)
        scene.lassoed.connect(self._lasso)
        scene.amount_changed.connect(self._stage.show_amount)
        self.show_comparison(self._comparing.answers.comparison)

    def show_comparison(self, comparison: Comparison | None) -> None:
        """An answer, or none."""
        scene = self._scene
        if scene is None or comparison is self._shown or self.between is not None:
            return
        if comparison is not None and self._shown is not None and comparison.alignment is self._shown.alignment:
            self._shown = comparison  # the same measurement in other terms: nothing that is drawn changes
            return
        self._shown = comparison
        self._chosen = None
        known = None if self._drawn is None else self._drawn[0]
        self._begin_drawing()
        self._stage.show_section(False)
        self.take_tool("look")
        if comparison is None:
            scene.clear()
            return
        from app.views.drawn_comparison import DrawnComparison

        threshold_um = float(self._comparing.draft.choice.tolerance_um)
        self._draw(lambda: DrawnComparison.of(comparison, threshold_um, known), partial(self._put_comparison, comparison))

    def show_choice(self) -> None:
        """The threshold, the painted region and the marked tooth as they are chosen."""
        scene, choice, comparison, drawn = self._scene, self._comparing.draft.choice, self._shown, self._drawn
        if scene is None or comparison is None or drawn is None or self.between is not None:
            return
        from app.views.drawn_comparison import drawn_threshold, outline

        self._turn_to_arch(scene, choice.jaw)
        if self._threshold_um != choice.tolerance_um:
            self._threshold_um = choice.tolerance_um
            deviation, threshold_um = comparison.deviation, choice.tolerance_um
            self._draw(partial(drawn_threshold, drawn[1], deviation, float(threshold_um)), partial(self._put_threshold, threshold_um))
            self._stage.legend.set_threshold_um(float(threshold_um))
        self._show_mask()
        if self._tooth is not choice.tooth:
            self._tooth = tooth = choice.tooth
            self._draw(lambda: None if tooth is None else outline(drawn[1], np.flatnonzero(tooth)), partial(self._put_part, tooth))

    def _turn_to_arch(self, scene: ComparisonScene, jaw: Jaw | None) -> None:
        """What is occlusal, frontal, left and right: told by the arch, and by the jaw that a person has said."""
        choice = self._comparing.draft.choice
        arch = None if choice.before is None else choice.before.arch
        upper = None if jaw is None else jaw is Jaw.UPPER
        if arch is None or arch.forward is None:
            axes = np.eye(3)
        else:
            right = np.cross(arch.forward, arch.up)
            axes = np.stack([-right if upper else right, arch.forward, arch.up], axis=1)
        if upper is not self._upper or not np.array_equal(axes, self._axes):
            self._axes, self._upper = axes, upper
            scene.set_axes(axes, upper)
            scene.look("occlusal")

    def show_points(self) -> None:
        """Both surfaces as they lie, middle on middle, while points are picked on them; the answer again after that."""
        scene, choice, points = self._scene, self._comparing.draft.choice, self._comparing.points
        if scene is None:
            return
        if not points.active or choice.before is None or choice.after is None:
            if self.between is not None:
                self.between = self._shown = None
                self._begin_drawing()
                scene.clear()
                self.show_comparison(self._comparing.answers.comparison)
            return
        if self.between is None:
            from app.views.drawn_surface import DrawnSurface

            before, after = choice.before, choice.after
            self.take_tool("look")
            self.between = between = _onto(after, before)
            self._begin_drawing()
            scene.clear()
            self._turn_to_arch(scene, None)  # which side of the surface after is the patient's right is not known yet
            mesh = after.surface.mesh
            placed = TriangleMesh(between.apply(mesh.vertices), mesh.triangles)
            self._draw(lambda: (DrawnSurface.of(before.surface.mesh), DrawnSurface.of(placed)), self._put_between)
            self._stage.show_section(False)
        marks: list[Landmark] = [(str(number), point, "before") for number, point in enumerate(choice.picks[0], 1)]
        marks += [(f"{number}\u2032", self.between.apply(np.asarray(point)[None])[0]) for number, point in enumerate(choice.picks[1], 1)]
        scene.show_landmarks(marks)

    def show_stable(self, on: bool) -> None:
        self._stable_shown = on
        self._with(lambda scene: scene.show_stable(on))
        self._show_mask()

    def look(self, view: str) -> None:
        """One of VIEWS, or ``fit``."""
        if self._shown is not None or self.between is not None:
            self._with(lambda scene: scene.look(view) if view in VIEWS else scene.fit())

    def fly_to(self, area: Area) -> None:
        """To an entry of the list."""
        self._chosen = area
        self._with(lambda scene: scene.select_area(area.rank))
        self._with(lambda scene: scene.fly_to(area))

    def flicker(self) -> None:
        """The other surface in place of the one that is seen."""
        if self._shown is not None and self.between is None and self._stage.mode in ("map", "flicker"):
            self._with(lambda scene: scene.show_other(not scene.shows_other))

    # -------------------------------------------------------------------------------- tools
    def take_tool(self, tool: str) -> None:
        """``look``, ``tooth``, ``paint``, ``erase``, ``lasso_add`` or ``lasso_remove``."""
        if self.between is None:  # while points are picked the pointer is theirs
            self.tool = tool
            if tool != "look":
                self._stage.choose_mode("map")
            self._with(lambda scene: scene.set_tool(_TOOLS[tool]))
            self._show_mask()
        self.tool_taken.emit(self.tool)

    # -------------------------------------------------------------------------------- inside
    def _with(self, call: Callable[[ComparisonScene], object]) -> None:
        if self._scene is not None and not self._scene.closed:
            call(self._scene)

    def _begin_drawing(self) -> None:
        """What is being drawn in the background is out of date."""
        self._turn += 1
        self._drawn = self._tooth = self._painted = None
        self._threshold_um = 0

    def _draw(self, work: Callable[[], T], put: Callable[[ComparisonScene, T], None]) -> None:
        """Draw in a thread; the result comes into the scene unless another pair is shown by then."""
        turn = self._turn
        self._background.run("draw-comparison", work, lambda made: self._with(lambda scene: put(scene, made)) if turn == self._turn else None)

    def _put_comparison(self, comparison: Comparison, scene: ComparisonScene, made: DrawnComparison) -> None:
        alignment, deviation = comparison.alignment, comparison.deviation
        self._drawn = (made.before, made.after)
        scene.show_pair(made.before, made.after)
        scene.show_deviation(deviation.signed_um, deviation.level_um, alignment.stable, np.isfinite(deviation.signed_um), made.scale)
        scene.show_feet(deviation.feet_mm)
        scene.show_areas(comparison.areas, made.outlines)
        if self._chosen is not None:
            scene.select_area(self._chosen.rank)
        scene.set_mode(self._stage.mode)
        self._stage.legend.show_scale(made.scale)
        self._show_legend()
        self.show_choice()

    def _put_between(self, scene: ComparisonScene, made: tuple[DrawnSurface, DrawnSurface]) -> None:
        scene.show_pair(*made)
        scene.set_mode("side_by_side")
        scene.fit()
        scene.set_tool("pick")
        self.show_points()

    def _put_threshold(self, threshold_um: int, scene: ComparisonScene, made: tuple[Any, DeviationScale]) -> None:
        if threshold_um == self._threshold_um:
            scene.show_threshold(*made)
            self._stage.legend.show_scale(made[1])

    def _put_part(self, tooth: Mask | None, scene: ComparisonScene, lines: Any) -> None:
        if tooth is self._tooth:
            scene.show_part(lines)

    def _show_mask(self) -> None:
        """What is painted, while the region is shown or a brush is in hand; before the first stroke what was found."""
        choice, comparison = self._comparing.draft.choice, self._shown
        if comparison is None or self._drawn is None or self.between is not None:
            return
        mask = choice.mask if choice.frame is Frame.MASK else None
        if self.tool in ("paint", "erase"):
            mask = comparison.alignment.stable if mask is None else mask
        elif not self._stable_shown:
            mask = None
        if mask is not self._painted:
            self._painted = mask
            self._with(lambda scene: scene.show_mask(mask))

    def _take_mode(self, mode: str) -> None:
        def take(scene: ComparisonScene) -> None:
            halved = scene.mode != mode and "side_by_side" in (scene.mode, mode)
            scene.set_mode(mode)
            if halved:  # two pictures in the place of one, or one again
                scene.fit()

        if self.between is None:
            self._with(take)
        self._show_legend()

    def _show_legend(self) -> None:
        """Where there are colours that it tells of."""
        self._stage.legend.setVisible(self._scene is not None and self._scene.mode in COLOURED)

    def _hover(self, found: Pointed | None) -> None:
        self._stage.show_value(None if found is None else found.signed_um, there=found is not None and found.surface == "after")

    def _pick(self, found: Pointed) -> None:
        if self.between is not None:
            place = np.asarray(found.point_mm)[None]
            x, y, z = (place if found.surface == "before" else self.between.inverse().apply(place))[0].tolist()
            self._comparing.points.pick("before" if found.surface == "before" else "after", (x, y, z))
        elif self.tool == "tooth" and found.surface == "after":
            self._comparing.tooth.mark(found.vertex)
            self.take_tool("look")

    def _paint(self, vertices: NDArray[np.int64], add: bool) -> None:
        """A stroke over the surface after goes on: over what was found, or painted before."""
        comparison, choice = self._shown, self._comparing.draft.choice
        if comparison is None:
            return
        if self._stroke is None:
            begun = choice.mask if choice.mask is not None and choice.frame is Frame.MASK else comparison.alignment.stable
            self._stroke = (begun.copy(), add)
        self._stroke[0][vertices] = add
        self._painted = mask = self._stroke[0]
        self._with(lambda scene: scene.show_mask(mask))

    def _end_stroke(self) -> None:
        """The brush was lifted: one step."""
        stroke, self._stroke = self._stroke, None
        if stroke is not None:
            self._comparing.draft.edit("paint" if stroke[1] else "erase", mask=stroke[0], frame=Frame.MASK)

    def _lasso(self, vertices: NDArray[np.int64]) -> None:
        self._comparing.tooth.correct(vertices, add=self.tool == "lasso_add")

    def _section(self, on: bool) -> None:
        """Across the surface, through the area that is spoken of or through the middle."""
        comparison = self._shown
        if comparison is None:
            return
        low, high = comparison.before.mesh.bounds()
        middle = _middle(comparison.before.mesh) if self._chosen is None else self._chosen.centroid_mm
        self._half_mm = 0.5 * float((high - low).max())
        self._stage.show_section(on)
        normal, chosen = self._across() if on else None, self._chosen
        self._with(lambda scene: scene.set_section(middle, normal))
        if on:
            self._with(lambda scene: scene.face_section(chosen))

    def _across(self) -> Array:
        """Unit normal of the section: along the arch at the chosen area, so that it cuts a tooth from cheek to tongue."""
        right, _, occlusal = self._axes.T
        if self._chosen is None:
            return np.asarray(right, np.float64)
        before = self._comparing.draft.choice.before
        arch = None if before is None else before.arch
        if arch is not None and arch.forward is not None:
            return arch.along(np.asarray(self._chosen.centroid_mm))[1]
        along = np.cross(occlusal, self._chosen.normal)
        length = float(np.sqrt(along @ along))
        return np.asarray(along / length if length > 0.2 else right, np.float64)

    def _move_section(self, share: float) -> None:
        self._with(lambda scene: scene.set_section_offset_mm((2 * share - 1) * self._half_mm))


def _onto(after: LoadedSurface, before: LoadedSurface) -> RigidTransform:
    """Middle on middle, and turned so that both arches show the same side, where both are known to be arches."""
    first, second = before.arch, after.arch
    turn = np.eye(3)
    if first is not None and second is not None and first.forward is not None and second.forward is not None:
        there, here = (
            np.column_stack([np.cross(forward, up), forward, up]) for forward, up in ((first.forward, first.up), (second.forward, second.up))
        )
        turn = there @ here.T
    return RigidTransform(turn, _middle(before.surface.mesh) - turn @ _middle(after.surface.mesh))


def _middle(mesh: TriangleMesh) -> Array:
    low, high = mesh.bounds()
    return np.asarray(0.5 * (low + high), np.float64)
