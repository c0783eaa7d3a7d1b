"""From lit points to 8 bits."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import dblquad

from scanner_core.virtual.image_formation import ImageSensor
from scanner_core.virtual.presets import PRESETS, look_at
from scanner_core.virtual.projection import ImagePoints, StereoProjection
from scanner_core.virtual.scene import Scene

BENCH = PRESETS["bench"]


@pytest.fixture(scope="module")
def sensor() -> ImageSensor:
    return ImageSensor(BENCH, 0, seed=5)


def one(x: float, y: float, flux: float, sigma: tuple[float, float] = (0.9, 0.7)) -> ImagePoints:
    return ImagePoints(np.array([x]), np.array([y]), np.array([flux]), sigma)


def total(sensor: ImageSensor, points: ImagePoints) -> np.ndarray:
    image = np.zeros(sensor.camera.size_px[::-1])
    for left, top, signal in sensor.windows(points):
        image[top : top + signal.shape[0], left : left + signal.shape[1]] += signal
    return image


def test_a_pixel_holds_the_integral_over_its_box(sensor: ImageSensor) -> None:
    image = total(sensor, one(100.3, 50.7, 800.0))

    def bell(y: float, x: float) -> float:
        return 800 * np.exp(-0.5 * ((x - 100.3) / 0.9) ** 2 - 0.5 * ((y - 50.7) / 0.7) ** 2) / (2 * np.pi * 0.9 * 0.7)

    for column, row in [(100, 51), (101, 50), (98, 52)]:
        expected, _ = dblquad(bell, column - 0.5, column + 0.5, row - 0.5, row + 0.5)
        assert image[row, column] == pytest.approx(expected, rel=1e-6)
    assert image.sum() == pytest.approx(800, rel=1e-5)


def test_moments_of_the_image_are_those_of_the_point_and_the_pixel(sensor: ImageSensor) -> None:
    image = total(sensor, one(300.21, 120.64, 1000.0))
    rows, columns = np.indices(image.shape)
    weight = image / image.sum()
    x, y = (weight * columns).sum(), (weight * rows).sum()
    assert (x, y) == pytest.approx((300.21, 120.64), abs=1e-4)
    assert (weight * (columns - x) ** 2).sum() == pytest.approx(0.81 + 1 / 12, abs=1e-3)
    assert (weight * (rows - y) ** 2).sum() == pytest.approx(0.49 + 1 / 12, abs=1e-3)


@pytest.mark.parametrize("index", [0, 1])
def test_the_bench_s_spot_has_sigma_1_0_by_0_8_px_and_its_peak(index: int) -> None:
    """A matt white wall that faces the camera at R, lit head-on: total image sigma and 75-80 % of full scale."""
    camera = BENCH.cameras[index]
    axis = camera.rotation[2]
    place = camera.centre_mm() + BENCH.distance_mm * axis
    sensor, projection = ImageSensor(BENCH, index, seed=0), StereoProjection(BENCH)
    offsets, weights = Scene(BENCH, None)._nodes
    points = place + offsets @ camera.rotation[:2]
    shares = np.zeros((2, len(weights)))
    shares[index] = weights
    spot = projection.image(points, np.tile(-axis, (len(points), 1)), shares, np.zeros((2, len(points), 2)))[index]
    assert spot is not None
    image = total(sensor, spot)
    rows, columns = np.indices(image.shape)
    weight = image / image.sum()
    x, y = (weight * columns).sum(), (weight * rows).sum()
    sigma = np.sqrt([(weight * (columns - x) ** 2).sum(), (weight * (rows - y) ** 2).sum()])
    np.testing.assert_allclose(sigma, (1.0, 0.8), atol=0.02)
    # moved so that a pixel's middle is the spot's
    centred = replace(spot, x_px=spot.x_px - x + round(x), y_px=spot.y_px - y + round(y))
    assert 0.75 * 255 < total(sensor, centred).max() + BENCH.black_dn < 0.82 * 255


def test_light_far_apart_and_light_together_add_up(sensor: ImageSensor) -> None:
    rng = np.random.default_rng(6)
    x, y, flux = rng.uniform(20, 580, 30), rng.uniform(20, 270, 30), rng.uniform(5, 500, 30)
    x[:10], y[:10] = rng.uniform(200, 206, 10), rng.uniform(100, 105, 10)
    sigma = (0.9, 0.7)
    together = total(sensor, ImagePoints(x, y, flux, sigma))
    apart = sum(total(sensor, one(*values, sigma)) for values in zip(x, y, flux, strict=True))
    np.testing.assert_allclose(together, apart, atol=1e-3)
    windows = sensor.windows(ImagePoints(x, y, flux, sigma))
    cover = np.zeros(sensor.camera.size_px[::-1], int)
    for left, top, signal in windows:
        cover[top : top + signal.shape[0], left : left + signal.shape[1]] += 1
    assert cover.max() == 1


@pytest.mark.parametrize("place", [(-2.0, 50.0), (603.6, 100.0), (300.0, -1.5), (300.0, 294.2), (-40.0, 20.0), (300.0, 900.0)])
def test_a_spot_at_the_border_is_cut_there(sensor: ImageSensor, place: tuple[float, float]) -> None:
    points = one(*place, 900.0)
    x = np.arange(-60, 700)
    column_share = np.exp(-0.5 * ((x - place[0]) / 0.95) ** 2)
    inside = column_share[(x >= 0) & (x < 604)].sum() / column_share.sum()
    y = np.arange(-60, 1000)
    row_share = np.exp(-0.5 * ((y - place[1]) / 0.75) ** 2)
    inside *= row_share[(y >= 0) & (y < 294)].sum() / row_share.sum()
    assert total(sensor, points).sum() == pytest.approx(900 * inside, abs=20)
    assert sensor.frame(points, 1).shape == (294, 604)


def test_a_dark_frame_has_the_black_level_and_the_read_noise(sensor: ImageSensor) -> None:
    frame = sensor.frame(None, 17).astype(float)
    assert frame.mean() == pytest.approx(BENCH.black_dn, abs=0.02)
    assert frame.std() == pytest.approx(np.hypot(BENCH.read_noise_dn, np.sqrt(1 / 12)), rel=0.01)


def test_gain_amplifies_light_and_noise_but_not_the_black_level(sensor: ImageSensor) -> None:
    dark = sensor.frame(None, 17, gain=2.0).astype(float)
    assert dark.mean() == pytest.approx(BENCH.black_dn, abs=0.05)
    assert dark.std() == pytest.approx(2 * BENCH.read_noise_dn, rel=0.03)
    spot = one(300.0, 100.0, 200.0)
    once, twice = (np.mean([sensor.frame(spot, key, gain)[100, 300] for key in range(200)]) - BENCH.black_dn for gain in (1.0, 2.0))
    assert twice == pytest.approx(2 * once, rel=0.02)


def test_shot_noise_grows_with_the_signal(sensor: ImageSensor) -> None:
    spot = one(300.0, 100.0, 700.0)
    signal = total(sensor, spot)[100, 300]
    values = np.array([sensor.frame(spot, key)[100, 300] for key in range(3000)], float)
    assert values.mean() == pytest.approx(signal + BENCH.black_dn, abs=0.1)
    expected = signal / BENCH.electrons_per_dn + BENCH.read_noise_dn**2 + 1 / 12
    assert values.var() == pytest.approx(expected, rel=0.08)


def test_too_much_light_saturates(sensor: ImageSensor) -> None:
    assert sensor.frame(one(300.0, 100.0, 5000.0), 3).max() == 255


def test_frames_repeat_by_seed_and_key() -> None:
    spot = one(100.0, 100.0, 500.0)
    first, again, other = (ImageSensor(BENCH, 0, seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first.frame(spot, 9), again.frame(spot, 9))
    assert not np.array_equal(first.frame(spot, 9), first.frame(spot, 10))
    assert not np.array_equal(first.frame(spot, 9), other.frame(spot, 9))
    assert not np.array_equal(first.frame(spot, 9), ImageSensor(BENCH, 1, 1).frame(spot, 9))


def test_a_frame_in_daylight_has_its_signal(sensor: ImageSensor) -> None:
    signal = np.full((294, 604), 100, np.float32)
    frame = sensor.lit_frame(signal, 4)
    assert frame.dtype == np.uint8
    assert frame.mean() == pytest.approx(100 + BENCH.black_dn, abs=0.05)


def test_the_middle_of_the_volume_is_seen_upright() -> None:
    """A camera's image has +x to the right and +z up (rows count downwards)."""
    pose = look_at((400.0, 0.0, 200.0), (0.0, 0.0, 25.0))
    right, up = pose.rotate(np.array([[0.0, 1, 0], [0, 0, 1]]))
    assert right[0] == pytest.approx(1)
    assert up[1] < -0.8


def test_room_light_adds_a_level_and_its_shot_noise() -> None:
    preset = replace(BENCH, electrons_per_dn=5.0)
    sensor = ImageSensor(preset, 0, seed=5)
    dark, lit = sensor.frame(None, 1), sensor.frame(None, 1, 1.0, 20.0)
    assert lit.mean() - dark.mean() == pytest.approx(20.0, abs=0.1)
    assert lit.std() == pytest.approx(np.sqrt(preset.read_noise_dn**2 + 20.0 / 5.0 + 1 / 12), rel=0.02)
    spot = sensor.frame(one(100.3, 50.7, 800.0), 1, 1.0, 20.0)
    assert int(spot.max()) - int(sensor.frame(one(100.3, 50.7, 800.0), 1).max()) == pytest.approx(20, abs=8)


def test_without_saturation_a_spot_that_is_too_bright_stays_below_full_scale() -> None:
    bright = one(100.0, 50.0, 6000.0)
    assert ImageSensor(BENCH, 0, seed=5).frame(bright, 1).max() == 255
    assert 215 < ImageSensor(BENCH.without("saturation"), 0, seed=5).frame(bright, 1).max() < 255
