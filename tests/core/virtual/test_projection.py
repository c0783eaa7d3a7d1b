"""Images of lit points: places, the law of the flux, and focus."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.virtual.presets import PRESETS, TARGET
from scanner_core.virtual.projection import ImagePoints, StereoProjection, lens_sigma_px

BENCH = PRESETS["bench"]
NO_SHIFT = np.zeros((2, 1, 2))


def flux_of(index: int, point: np.ndarray, normal: np.ndarray) -> float:
    spot: ImagePoints | None = StereoProjection(BENCH).image(point[None], normal[None], np.ones((2, 1)), NO_SHIFT)[index]
    assert spot is not None
    return float(spot.flux_dn[0])


@pytest.mark.parametrize("name", PRESETS)
def test_places_agree_with_the_camera_model(name: str) -> None:
    preset = PRESETS[name]
    points = np.random.default_rng(4).uniform((-60, -60, 0), (60, 60, 90), (50, 3))
    spots = StereoProjection(preset).image(points, np.tile([0.5, 0, 0.8], (50, 1)), np.ones((2, 50)), NO_SHIFT)
    for spot, camera in zip(spots, preset.cameras, strict=True):
        assert spot is not None
        np.testing.assert_allclose(np.c_[spot.x_px, spot.y_px], camera.project(points), atol=1e-9)


def test_flux_falls_with_cosine_distance_and_field_angle() -> None:
    frontal = []
    for index, camera in enumerate(BENCH.cameras):
        axis = camera.rotation[2]
        eye = camera.centre_mm()
        on_axis = eye + BENCH.distance_mm * axis
        flux = flux_of(index, on_axis, -axis)
        frontal.append(flux)
        tilted = np.cos(np.radians(50)) * -axis + np.sin(np.radians(50)) * camera.rotation[0]
        assert flux_of(index, on_axis, tilted) == pytest.approx(flux * np.cos(np.radians(50)))
        assert flux_of(index, eye + 1.2 * BENCH.distance_mm * axis, -axis) == pytest.approx(flux / 1.44)
        off = eye + BENCH.distance_mm * (axis + 0.2 * camera.rotation[0])
        towards = (eye - off) / np.linalg.norm(eye - off)
        assert flux_of(index, off, towards) == pytest.approx(flux / 1.04**1.5)
    assert frontal[0] == pytest.approx(frontal[1], rel=0.01)


def test_a_surface_that_faces_away_is_dark() -> None:
    assert StereoProjection(BENCH).image(np.array([TARGET]), np.array([[-1.0, 0, 0]]), np.ones((2, 1)), NO_SHIFT) == (None, None)


def test_a_shift_moves_the_image_by_focal_length_over_depth() -> None:
    projection = StereoProjection(BENCH)
    still = projection.image(np.array([TARGET]), np.array([[1.0, 0, 0]]), np.ones((2, 1)), NO_SHIFT)
    moved = projection.image(np.array([TARGET]), np.array([[1.0, 0, 0]]), np.ones((2, 1)), np.array([[[0.03, 0.0]], [[0.0, -0.05]]]))
    for a, b, axis, expected in zip(still, moved, (0, 1), (0.03, -0.05), strict=True):
        assert a is not None
        assert b is not None
        depth = (BENCH.cameras[axis].rotation @ TARGET + BENCH.cameras[axis].translation)[2]
        movement = np.array([b.x_px[0] - a.x_px[0], b.y_px[0] - a.y_px[0]])
        assert movement[axis] == pytest.approx(BENCH.cameras[axis].matrix[axis, axis] * expected / depth)
        assert movement[1 - axis] == 0


def test_defocus_grows_away_from_the_focus() -> None:
    preset = replace(BENCH, lens_sigma_px=(0.3, 0.2), defocus_sigma_px=(0.9, 0.6), focus_mm=300.0)
    np.testing.assert_allclose(lens_sigma_px(preset, 300.0), (0.3, 0.2))
    np.testing.assert_allclose(lens_sigma_px(preset, preset.distance_mm), np.hypot((0.3, 0.2), (0.9, 0.6)))
    depths = [300, 350, 400, 500]
    widths = [lens_sigma_px(preset, depth)[0] for depth in depths]
    assert widths == sorted(widths)
