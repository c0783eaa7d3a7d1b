"""Between the comparison and its 3D view: what is drawn, and what a person does in it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.comparison_draft import Mask
from app.services import Services
from app.views.compare_stage import VIEWS, CompareStage
from scanner_core.comparison.area import Area
from scanner_core.comparison.colour_scale import DeviationScale
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Frame, Jaw
from scanner_core.geometry.mesh import TriangleMesh

if TYPE_CHECKING:
    from app.views.comparison_marks import Landmark
    from app.views.comparison_scene import ComparisonScene
    from app.views.pointed import Pointed

Array = NDArray[np.float64]

_TOOLS = {"look": "look", "tooth": "pick", "paint": "paint", "erase": "erase", "lasso_add": "lasso", "lasso_remove": "lasso"}


class ComparisonPicture(QObject):
    """Draws the answer that is there, once the 3D view is there, too."""

    tool_taken = Signal(str)
    """Another tool is in hand."""

    def __init__(self, services: Services, stage: CompareStage) -> None:
        super().__init__(stage)
        self._comparing, self._stage = services.comparing, stage
        self._scene: ComparisonScene | None = None
        self._shown: Comparison | None = None
        self.tool = "look"
        self._chosen: Area | None = None
        self._axes = np.eye(3)
        self._upper: bool | None = None
        self._half_mm = 0.0
        self._threshold_um = 0
        self._stroke: tuple[Mask, bool] | None = None
        self._between: Array | None = None
        stage.mode_wanted.connect(self._take_mode)
        stage.amount_wanted.connect(lambda share: self._with(lambda scene: scene.set_amount(share)))
        stage.view_wanted.connect(self.look)
        stage.section_wanted.connect(self._section)
        stage.section_moved.connect(self._move_section)

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
        if scene is None or comparison is self._shown or self._between is not None:
            return
        if comparison is not None and self._shown is not None and comparison.alignment is self._shown.alignment:
            self._shown = comparison  # the same measurement in other terms: nothing that is drawn changes
            return
        self._shown = comparison
        self._chosen = None
        self._stage.show_section(False)
        self.take_tool("look")
        if comparison is None:
            scene.clear()
            return
        alignment, deviation, after = comparison.alignment, comparison.deviation, comparison.after.mesh
        scene.show_pair(comparison.before.mesh, TriangleMesh(alignment.transform.apply(after.vertices), after.triangles))
        scene.show_deviation(deviation.signed_um, deviation.level_um, alignment.stable, np.isfinite(deviation.signed_um), self._scale(comparison))
        scene.show_feet(deviation.feet_mm)
        scene.show_areas(comparison.areas)
        scene.set_mode(self._stage.mode)
        self.show_choice()

    def show_choice(self) -> None:
        """The threshold, the painted region and the marked tooth as they are chosen."""
        scene, choice, comparison = self._scene, self._comparing.draft.choice, self._shown
        if scene is None or comparison is None:
            return
        self._turn_to_arch(scene)
        if self._threshold_um != choice.tolerance_um:
            self._threshold_um = choice.tolerance_um
            scene.set_threshold_um(float(choice.tolerance_um))
            self._stage.legend.set_threshold_um(float(choice.tolerance_um))
        scene.show_mask(choice.mask if choice.frame is Frame.MASK else None)
        scene.show_part(None if choice.tooth is None else np.flatnonzero(choice.tooth))

    def _turn_to_arch(self, scene: ComparisonScene) -> None:
        """What is occlusal, frontal, left and right: told by the arch, and by the jaw that a person has said."""
        choice = self._comparing.draft.choice
        arch = None if choice.before is None else choice.before.arch
        upper = None if choice.jaw is None else choice.jaw is Jaw.UPPER
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
            if self._between is not None:
                self._between = self._shown = None
                scene.clear()
                self.show_comparison(self._comparing.answers.comparison)
            return
        if self._between is None:
            before, after = choice.before.surface.mesh, choice.after.surface.mesh
            self._between = _middle(before) - _middle(after)
            scene.show_pair(before, TriangleMesh(after.vertices + self._between, after.triangles))
            scene.set_mode("side_by_side")
            scene.fit()
            scene.set_tool("pick")
        marks: list[Landmark] = [(str(number), point, "before") for number, point in enumerate(choice.picks[0], 1)]
        marks += [(f"{number}\u2032", tuple(np.asarray(point) + self._between)) for number, point in enumerate(choice.picks[1], 1)]
        scene.show_landmarks(marks)

    def show_stable(self, on: bool) -> None:
        self._with(lambda scene: scene.show_stable(on))

    def look(self, view: str) -> None:
        """One of VIEWS, or ``fit``."""
        if self._shown is not None:
            self._with(lambda scene: scene.look(view) if view in VIEWS else scene.fit())

    def fly_to(self, area: Area) -> None:
        """To an entry of the list."""
        self._chosen = area
        self._with(lambda scene: scene.select_area(area.rank))
        self._with(lambda scene: scene.fly_to(area))

    def flicker(self) -> None:
        """The other surface in place of the one that is seen."""
        if self._shown is not None and self._stage.mode in ("map", "flicker"):
            self._with(lambda scene: scene.show_other(not scene.shows_other))

    # -------------------------------------------------------------------------------- tools
    def take_tool(self, tool: str) -> None:
        """``look``, ``tooth``, ``paint``, ``erase``, ``lasso_add`` or ``lasso_remove``."""
        self.tool = tool
        if tool != "look":
            self._stage.choose_mode("map")
        self._with(lambda scene: scene.set_tool(_TOOLS[tool]))
        self.tool_taken.emit(tool)

    # -------------------------------------------------------------------------------- inside
    def _with(self, call: Callable[[ComparisonScene], object]) -> None:
        if self._scene is not None and not self._scene.closed:
            call(self._scene)

    def _take_mode(self, mode: str) -> None:
        def take(scene: ComparisonScene) -> None:
            halved = scene.mode != mode and "side_by_side" in (scene.mode, mode)
            scene.set_mode(mode)
            if halved:  # two pictures in the place of one, or one again
                scene.fit()

        self._with(take)

    def _scale(self, comparison: Comparison) -> DeviationScale:
        """Steps of colour that have an edge at the threshold."""
        threshold_um = float(self._comparing.draft.choice.tolerance_um)
        scale = DeviationScale.fitting(comparison.deviation.signed_um, comparison.deviation.detection_level_um, threshold_um)
        self._stage.legend.show_scale(scale)
        return scale

    def _hover(self, found: Pointed | None) -> None:
        self._stage.show_value(None if found is None else found.signed_um, there=found is not None and found.surface == "after")

    def _pick(self, found: Pointed) -> None:
        if self._between is not None:
            x, y, z = found.point_mm
            dx, dy, dz = self._between.tolist() if found.surface == "after" else (0.0, 0.0, 0.0)
            self._comparing.points.pick("before" if found.surface == "before" else "after", (x - dx, y - dy, z - dz))
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
        mask = self._stroke[0]
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
        normal = self._across() if on else None
        self._with(lambda scene: scene.set_section(middle, normal))

    def _across(self) -> Array:
        """Unit normal of the section: along the arch at the chosen area, so that it cuts a tooth from cheek to tongue."""
        right, _, occlusal = self._axes.T
        if self._chosen is None:
            return np.asarray(right, np.float64)
        along = np.cross(occlusal, self._chosen.normal)
        length = float(np.sqrt(along @ along))
        return np.asarray(along / length if length > 0.2 else right, np.float64)

    def _move_section(self, share: float) -> None:
        self._with(lambda scene: scene.set_section_offset_mm((2 * share - 1) * self._half_mm))


def _middle(mesh: TriangleMesh) -> Array:
    low, high = mesh.bounds()
    return np.asarray(0.5 * (low + high), np.float64)
