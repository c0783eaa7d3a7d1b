"""One of two compared surfaces as VTK draws it: plain or as the map of its deviation."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from app.views.compared_shader import MOST_BANDS, install
from app.views.drawn_surface import DrawnSurface
from app.views.surface_colours import rgb
from app.views.vtk_arrays import copied
from scanner_core.comparison.colour_scale import HATCH, NO_COUNTERPART, WITHIN_LEVEL, DeviationScale

STABLE = "#1f8f7d"
BACK = "#5d5a58"
_ALL_BUT_TRANSPARENT = 0.002
"""VTK leaves out what is wholly transparent, its depth too."""


class ComparedActor:
    """The surface, and what is known of each of its vertices."""

    def __init__(self, colour: str) -> None:
        """`colour` is that of the plain surface."""
        self.drawn: DrawnSurface | None = None
        self._values = np.zeros((0, 4), np.float32)
        self._mapper, self._coarse_mapper = _mapper(), _mapper()
        self._first_mapper = _mapper()
        self.actor = _actor(self._mapper)
        self.first = _actor(self._first_mapper)
        """The same surface, all but transparent: drawn before a translucent one, it keeps what lies behind out of it."""
        self.first.SetVisibility(False)
        for actor in (self.actor, self.first):
            self._declare(actor, colour)

    def show(self, drawn: DrawnSurface | None) -> None:
        """Draw this one from now on, or none."""
        self.drawn = drawn
        self.actor.SetVisibility(drawn is not None)
        self.actor.SetMapper(self._mapper)
        if drawn is None:
            return
        count = len(drawn.mesh.vertices)
        self._values = np.zeros((count, 4), np.float32)
        self._values[:, 2] = 1.0
        self._put("deviation", self._values)
        self._put("painted", np.zeros(count, np.float32))
        self._put("foot", np.zeros((count, 3), np.float32))
        for mapper in (self._mapper, self._first_mapper):
            mapper.SetInputData(drawn.poly)
        if drawn.coarse is not None:
            self._coarse_mapper.SetInputData(drawn.coarse)

    def set_coarse(self, on: bool) -> None:
        """Fewer triangles between the same vertices."""
        drawn = self.drawn
        if on and drawn is not None and drawn.coarse is not None:
            drawn.coarse.GetPointData().ShallowCopy(drawn.poly.GetPointData())
            self.actor.SetMapper(self._coarse_mapper)
        else:
            self.actor.SetMapper(self._mapper)

    def show_values(self, signed_um: NDArray[np.float64], level_um: NDArray[np.float64], counterpart: NDArray[np.bool_]) -> None:
        """Signed deviation and level of detection, (v,) um, and which vertices have a counterpart."""
        self._values[:, 0] = np.where(counterpart, np.nan_to_num(signed_um), 0.0)
        self._values[:, 1] = np.nan_to_num(level_um)
        self._values[:, 2] = counterpart
        self._put("deviation", self._values)

    def show_stable(self, stable: NDArray[np.bool_]) -> None:
        """(v,): which vertices carry the alignment."""
        self._values[:, 3] = stable
        self._put("deviation", self._values)

    def show_feet(self, feet_mm: NDArray[np.float64]) -> None:
        """(v, 3) mm: where each vertex stands at the beginning of the morph; NaN stays in place."""
        assert self.drawn is not None
        self._put("foot", np.nan_to_num(feet_mm - self.drawn.mesh.vertices).astype(np.float32))

    def show_painted(self, painted: NDArray[np.bool_] | None) -> None:
        """(v,): what a person has painted."""
        if self.drawn is not None:
            self._put("painted", np.zeros(len(self.drawn.mesh.vertices), np.float32) if painted is None else painted.astype(np.float32))

    def show_scale(self, scale: DeviationScale | None) -> None:
        """Map or, with None, the plain surface."""
        for actor in (self.actor, self.first):
            uniforms = actor.GetShaderProperty().GetFragmentCustomUniforms()
            uniforms.SetUniformi("coloured", scale is not None)
            if scale is not None:
                uniforms.SetUniformf("perUM", scale.steps / scale.limit_um)
                uniforms.SetUniformi("steps", scale.steps)
                packed = np.zeros(MOST_BANDS)
                packed[: 2 * scale.steps] = scale.band_colours[:MOST_BANDS] @ np.array([65536.0, 256.0, 1.0])
                for i, four in enumerate(packed.reshape(-1, 4).tolist()):
                    uniforms.SetUniform4f(f"bands{i}", four)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Device pixels of a pixel: the hatch keeps its size."""
        for actor in (self.actor, self.first):
            actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniformf("pixelRatio", ratio)

    def set_fade(self, opacity: float) -> None:
        """0 to 1."""
        self.actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniformf("fade", max(opacity, _ALL_BUT_TRANSPARENT))

    def set_morph(self, amount: float) -> None:
        """0 with every vertex at its foot, 1 with every vertex at its own place."""
        for actor in (self.actor, self.first):
            actor.GetShaderProperty().GetVertexCustomUniforms().SetUniformf("morph", amount)

    def set_stable_shown(self, on: bool) -> None:
        self.actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniformi("stableShown", on)

    def set_curtain(self, x: float, side: int) -> None:
        """Only what lies right (+1) or left (-1) of a column of the picture, device pixels; 0 for all."""
        self.actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform2f("curtain", (x, float(side)))

    def set_cut(self, normal: Sequence[float], offset: float) -> None:
        """Only points with ``normal . p <= offset``; a normal of zeros and an offset of 1 for all."""
        for actor in (self.actor, self.first):
            actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform4f("cut", (*normal, offset))

    def _put(self, name: str, values: NDArray[np.float32]) -> None:
        assert self.drawn is not None
        array = copied(values)
        array.SetName(name)
        self.drawn.poly.GetPointData().AddArray(array)
        self.drawn.poly.Modified()

    def _declare(self, actor: vtkActor, colour: str) -> None:
        shader = actor.GetShaderProperty()
        install(shader)
        shader.GetVertexCustomUniforms().SetUniformf("morph", 1.0)
        uniforms = shader.GetFragmentCustomUniforms()
        for name in ("coloured", "steps", "stableShown"):
            uniforms.SetUniformi(name, 0)
        uniforms.SetUniformf("perUM", 0.0)
        uniforms.SetUniformf("pixelRatio", 1.0)
        uniforms.SetUniformf("fade", 1.0 if actor is self.actor else _ALL_BUT_TRANSPARENT)
        uniforms.SetUniform2f("curtain", (0.0, 0.0))
        uniforms.SetUniform4f("cut", (0.0, 0.0, 0.0, 1.0))
        for i in range(MOST_BANDS // 4):
            uniforms.SetUniform4f(f"bands{i}", (0.0, 0.0, 0.0, 0.0))
        colours = {
            "plainColour": rgb(colour),
            "levelColour": WITHIN_LEVEL,
            "emptyColour": NO_COUNTERPART,
            "hatchColour": HATCH,
            "stableColour": rgb(STABLE),
            "backColour": rgb(BACK),
        }
        for name, value in colours.items():
            uniforms.SetUniform3f(name, _floats(value))


def _floats(colour: Sequence[int] | NDArray[np.uint8]) -> tuple[float, float, float]:
    red, green, blue = (float(value) / 255 for value in colour)
    return red, green, blue


def _mapper() -> vtkPolyDataMapper:
    mapper = vtkPolyDataMapper()
    mapper.ScalarVisibilityOff()
    mapper.SetVBOShiftScaleMethod(0)  # the shader adds millimetres to the coordinates
    for name in ("deviation", "painted", "foot"):
        mapper.MapDataArrayToVertexAttribute(f"{name}MC", name, 0, -1)
    return mapper


def _actor(mapper: vtkPolyDataMapper) -> vtkActor:
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetVisibility(False)
    actor.ForceOpaqueOn()
    actor.GetProperty().SetInterpolationToPhong()
    return actor
