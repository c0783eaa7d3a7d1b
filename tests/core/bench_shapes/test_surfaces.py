from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from tests.bench.reconstruction.arch import ARCH
from tests.bench.reconstruction.bodies import HEART, PLATE, SHELL, SPHERE, SPHERE_RADIUS_MM, VESSEL
from tests.bench.reconstruction.ear import EAR, EAR_LEFT
from tests.bench.reconstruction.implicit import Array, Surface


def points_on(surface: Surface, step_mm: float) -> Array:
    """Grid points near the surface, moved onto it."""
    low, high = surface.box()
    axes = [np.arange(low[axis], high[axis], step_mm) for axis in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    # Only close ones: a Newton step from the medial axis may land anywhere.
    return surface.project(grid[np.abs(surface(grid)) < 0.5 * step_mm])


@pytest.mark.parametrize(
    ("surface", "size_mm", "step_mm"),
    [
        (EAR, (18, 14, 22), 0.5),
        (ARCH, (60, 50, 10), 0.8),
        (HEART, (70, 104, 99), 3.0),
        (SPHERE, (22.266, 22.266, 22.266), 0.8),
        (SHELL, (30, 24, None), 0.6),
        (PLATE, (30, 20, 1.2), 0.4),
    ],
    ids=lambda value: value.name if isinstance(value, Surface) else "",
)
def test_a_surface_has_its_stated_size_and_projection_lands_on_it(surface: Surface, size_mm: tuple[float | None, ...], step_mm: float) -> None:
    points = points_on(surface, step_mm)
    # Creases, where parts of a solid meet without a blend, turn a Newton step round.
    assert (1e3 * np.abs(surface.distance(points)) < 0.1).mean() > 0.995
    for extent, stated in zip(np.ptp(points, axis=0), size_mm, strict=True):
        assert stated is None or extent == pytest.approx(stated, abs=0.1 * step_mm + 0.05)


def test_the_shell_is_two_millimetres_thick_across_its_middle() -> None:
    z = np.linspace(-2, 2, 4001)
    inside = SHELL(np.c_[np.zeros((len(z), 2)), z]) < 0
    assert np.ptp(z[inside]) == pytest.approx(2.0, abs=0.003)


def test_the_vessel_thins_from_five_to_one_and_a_half_millimetres() -> None:
    trunk, twig = np.array([[5.0, 0, 1.0]]), np.array([[-10.0, -8.0, 45.5]])
    assert abs(VESSEL.distance(trunk)[0]) < 0.1
    assert abs(VESSEL.distance(twig)[0]) < 0.1


def test_a_mirrored_ear_is_the_mirror_image() -> None:
    rng = np.random.default_rng(0)
    points = rng.uniform((-8, -8, 0), (8, 8, 16), (200, 3))
    straight = Surface("right", type(EAR_LEFT.field)(**{**_fields(EAR_LEFT.field), "mirrored": False}), EAR_LEFT.low, EAR_LEFT.high, 0.1)
    np.testing.assert_allclose(EAR_LEFT(points), straight(points * (1, -1, 1)))


def test_normals_and_bending_of_the_sphere() -> None:
    points = points_on(SPHERE, 2.0)
    np.testing.assert_allclose(SPHERE.normals(points), points / SPHERE_RADIUS_MM, atol=1e-6)
    np.testing.assert_allclose(SPHERE.bending(points), np.sqrt(2) / SPHERE_RADIUS_MM, rtol=1e-3)


def _fields(instance: Any) -> dict[str, object]:
    return {field.name: getattr(instance, field.name) for field in dataclasses.fields(instance)}
