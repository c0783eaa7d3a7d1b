from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from app.palettes import DARK, LIGHT
from app.views.cloud_actor import LIVE_LIMIT, MOVING_LIMIT, CloudActor
from app.views.cloud_points import CloudPoints
from app.views.cloud_store import every
from app.views.colour_maps import MAPS
from app.views.point_colour import PointColour
from app.views.surface_colours import rgb
from scanner_core.geometry.point_cloud import PointCloud

UP = np.array([0.0, 0.0, 1.0])
_DEFICIENT = (
    np.eye(3),
    ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
)


def _line(first: int, count: int) -> NDArray[np.float64]:
    """Points whose x is their number."""
    points = np.zeros((count, 3))
    points[:, 0] = np.arange(first, first + count)
    return points


def _fill(cloud: CloudActor, total: int, step: int) -> None:
    for first in range(0, total, step):
        count = min(step, total - first)
        cloud.append(CloudPoints.plain(_line(first, count), np.tile(UP, (count, 1))))


def test_all_points_are_drawn_while_they_are_few() -> None:
    cloud = CloudActor()
    _fill(cloud, 1000, 7)
    assert len(cloud) == cloud.drawn == 1000
    assert (cloud.live_points()[0][:, 0] == np.arange(1000)).all()


def test_a_growing_cloud_never_draws_more_than_the_limit_and_stays_even() -> None:
    cloud = CloudActor()
    _fill(cloud, 200_000, 997)
    assert len(cloud) == 200_000
    assert LIVE_LIMIT / 2 < cloud.drawn <= LIVE_LIMIT
    kept = cloud.live_points()[0][:, 0]
    assert (kept == np.arange(0, 200_000, kept[1] - kept[0])).all()
    assert len(kept) == cloud.drawn


def test_fewer_are_drawn_while_the_camera_moves_and_all_when_nothing_does() -> None:
    cloud = CloudActor()
    _fill(cloud, 100_000, 1000)
    _light(cloud, stride=8)
    cloud.thin_for_motion(True)
    assert cloud.drawn <= MOVING_LIMIT
    cloud.thin_for_motion(False)
    assert cloud.drawn == 100_000


def test_chunks_of_a_cloud_that_has_grown_or_gone_are_not_drawn() -> None:
    cloud = CloudActor()
    _fill(cloud, 100_000, 1000)
    generation, rest = cloud.generation, every(cloud.parts(), 0, 8)
    _light(cloud, stride=8)
    cloud.append(CloudPoints.plain(_line(100_000, 1), UP[None]))
    assert cloud.drawn < 60_001
    cloud.clear()
    _fill(cloud, 500, 100)
    cloud.take_chunk(rest, rest.towards, generation, first=True)
    assert cloud.drawn == 500


def test_a_cloud_of_a_case_is_held_and_shown_as_if_it_had_been_scanned() -> None:
    cloud = CloudActor()
    whole = PointCloud(_line(0, 150_000), views=np.repeat(np.arange(15, dtype=np.int32), 10_000))
    cloud.hold(whole)
    assert len(cloud) == 150_000
    kept = cloud.live_points()[0][:, 0]
    assert LIVE_LIMIT / 2 < len(kept) == cloud.drawn <= LIVE_LIMIT
    assert (kept == np.arange(0, 150_000, 4)).all()
    rest = every(cloud.parts(), 3, 7)
    assert (rest.points[:, 0] == np.arange(3, 150_000, 7)).all()
    assert (rest.of(PointColour.VIEW) == rest.points[:, 0] // 10_000 % 8).all()
    assert np.isnan(rest.of(PointColour.RESIDUAL)).all()  # nobody knows


def test_what_another_thread_reads_is_what_was_there() -> None:
    cloud = CloudActor()
    _fill(cloud, 70_000, 997)
    before = cloud.parts()
    _fill(cloud, 70_000, 997)
    assert (every(before, 0, 1).points[:, 0] == np.arange(70_000)).all()


def test_one_large_chunk_is_thinned_like_many_small_ones() -> None:
    cloud = CloudActor()
    _fill(cloud, 500_000, 500_000)
    assert LIVE_LIMIT / 2 < cloud.drawn <= LIVE_LIMIT


def _lightness(colours: NDArray[np.uint8]) -> NDArray[np.float64]:
    linear = (colours[:, :3] / 255.0) ** 2.2
    return np.asarray(linear @ [0.2126, 0.7152, 0.0722], np.float64)


def _contrast(colours: NDArray[np.uint8], ground: tuple[int, int, int]) -> NDArray[np.float64]:
    a, b = _lightness(colours), _lightness(np.array([ground]))
    return np.asarray((np.maximum(a, b) + 0.05) / (np.minimum(a, b) + 0.05))


@pytest.mark.parametrize("dark", [True, False])
@pytest.mark.parametrize("by", list(PointColour))
def test_no_colour_sinks_into_the_ground(by: PointColour, dark: bool) -> None:
    palette = DARK if dark else LIGHT
    for ground in (palette.scene_low, palette.scene_high):
        assert _contrast(MAPS[by].table(dark), rgb(ground)).min() > 2.5


@pytest.mark.parametrize("dark", [True, False])
@pytest.mark.parametrize("by", [by for by in PointColour if by is not PointColour.VIEW])
def test_lightness_rises_or_falls_all_the_way(by: PointColour, dark: bool) -> None:
    lightness = _lightness(MAPS[by].table(dark))
    steps = lightness[8:] - lightness[:-8]
    assert (steps > 0).all() or (steps < 0).all()


@pytest.mark.parametrize("dark", [True, False])
def test_views_that_follow_one_another_are_told_apart_by_everybody(dark: bool) -> None:
    """After Machado et al. 2009: as people without red, green or blue cones see them."""
    colours = (MAPS[PointColour.VIEW].table(dark)[:, :3] / 255.0) ** 2.2
    for severe in _DEFICIENT:
        seen = np.clip(colours @ np.array(severe).T, 0, 1) ** (1 / 2.2)
        apart = np.linalg.norm(seen - np.roll(seen, 1, axis=0), axis=1)
        assert apart.min() > 0.16


def _light(cloud: CloudActor, stride: int) -> None:
    """Hand it the whole cloud in chunks."""
    for first in range(stride):
        points = every(cloud.parts(), first, stride)
        cloud.take_chunk(points, points.towards, cloud.generation, first=first == 0)
