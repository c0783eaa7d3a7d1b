from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.views.cloud_actor import LIVE_LIMIT, MOVING_LIMIT, CloudActor
from app.views.height_colours import HEIGHT, table

UP = np.array([0.0, 0.0, 1.0])


def _line(first: int, count: int) -> NDArray[np.float64]:
    """Points whose x is their number."""
    points = np.zeros((count, 3))
    points[:, 0] = np.arange(first, first + count)
    return points


def _fill(cloud: CloudActor, total: int, step: int) -> None:
    for first in range(0, total, step):
        count = min(step, total - first)
        cloud.append(_line(first, count), np.tile(UP, (count, 1)))


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
    cloud.thin_for_motion(True)
    assert cloud.drawn <= MOVING_LIMIT
    cloud.thin_for_motion(False)
    points, towards = cloud.all_points()
    cloud.show_still(towards, cloud.generation)
    assert len(points) == cloud.drawn == 100_000


def test_normals_of_a_cloud_that_was_thinned_meanwhile_are_not_used() -> None:
    cloud = CloudActor()
    _fill(cloud, 1000, 100)
    generation = cloud.generation
    cloud.clear()
    _fill(cloud, 500, 100)
    cloud.show_still(np.tile(UP, (1000, 1)), generation)
    assert cloud.drawn == 500


def test_one_large_chunk_is_thinned_like_many_small_ones() -> None:
    cloud = CloudActor()
    _fill(cloud, 500_000, 500_000)
    assert LIVE_LIMIT / 2 < cloud.drawn <= LIVE_LIMIT


def test_the_height_map_gets_lighter_all_the_way_and_starts_far_from_the_background() -> None:
    linear = (table(HEIGHT)[:, :3] / 255.0) ** 2.2
    lightness = linear @ [0.2126, 0.7152, 0.0722]
    assert (lightness[8:] > lightness[:-8]).all()
    background = (np.array([0x2D, 0x32, 0x38]) / 255.0) ** 2.2 @ [0.2126, 0.7152, 0.0722]
    assert (lightness[0] + 0.05) / (background + 0.05) > 2.5
