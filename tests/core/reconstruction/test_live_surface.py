"""The coarse surface of a growing cloud: it follows, it shows what is missing, and it never refuses aloud."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled
from scanner_core.jobs.registry import JOBS, resolve
from scanner_core.reconstruction.live_request import LiveSurface, LiveSurfaceRequest, NoSurfaceReason, NoSurfaceYet
from scanner_core.reconstruction.live_surface import live_surface
from tests.core.reconstruction.shapes import on_sphere

Array = NDArray[np.float64]
RADIUS_MM = 12.0
UP = np.array([0.0, 0.0, RADIUS_MM])
"""The ball stands on the table."""


def made(points: Array, towards: Array, before: TriangleMesh | None = None) -> LiveSurface | NoSurfaceYet:
    request = LiveSurfaceRequest(points.astype(np.float32), towards.astype(np.float32), before)
    return live_surface(request, progress=lambda progress: None, cancelled=lambda: False)


def seen(points: Array, azimuths_deg: tuple[float, ...]) -> tuple[Array, Array]:
    """The points of a ball about the origin that face a camera at these azimuths, 30 degrees above the table."""
    parts = []
    for azimuth in np.radians(azimuths_deg):
        towards = np.array([np.sqrt(0.75) * np.cos(azimuth), np.sqrt(0.75) * np.sin(azimuth), 0.5])
        facing = points[points @ towards > 0.2 * RADIUS_MM]
        parts.append((facing, np.repeat(towards[None], len(facing), axis=0)))
    return np.concatenate([part[0] for part in parts]), np.concatenate([part[1] for part in parts])


def surface(answer: LiveSurface | NoSurfaceYet) -> LiveSurface:
    assert isinstance(answer, LiveSurface), answer
    return answer


def supported(live: LiveSurface) -> NDArray[np.bool_]:
    return np.asarray(live.mesh.vertex_attributes["supported"], np.bool_)


def test_one_view_makes_a_closed_surface_whose_far_side_is_not_supported() -> None:
    points, towards = seen(on_sphere(RADIUS_MM, 6000, 0.02, 1), (0.0,))
    live = surface(made(points + UP, towards))
    checks = check_mesh(live.mesh)
    assert checks.closed
    assert checks.outward
    assert checks.genus == 0
    assert checks.self_intersections == 0
    along = (live.mesh.vertices - UP) @ towards[0] / RADIUS_MM
    assert supported(live)[along > 0.4].mean() > 0.98
    assert supported(live)[along < 0.0].mean() < 0.02
    radii = np.linalg.norm(live.mesh.vertices[along > 0.4] - UP, axis=1)
    assert np.abs(radii - RADIUS_MM).max() < 0.5


def test_it_follows_the_cloud_and_the_supported_share_grows_to_what_was_seen() -> None:
    ball = on_sphere(RADIUS_MM, 6000, 0.02, 2)
    before: TriangleMesh | None = None
    shares = []
    for views in ((0.0,), (0.0, 60.0), (0.0, 60.0, 120.0, 180.0), tuple(range(0, 360, 45))):
        points, towards = seen(ball, views)
        live = surface(made(points + UP, towards, before))
        assert live.followed == (before is not None)
        before = live.mesh
        shares.append(live.supported_area)
    assert all(later > earlier for earlier, later in pairwise(shares))
    # what no camera sees is a cap below: those directions whose best view is more than 78 degrees off
    directions = on_sphere(1.0, 20_000, 0.0, 3)
    truth = len(np.unique(seen(RADIUS_MM * directions, tuple(range(0, 360, 45)))[0], axis=0)) / len(directions)
    assert shares[-1] == pytest.approx(truth, abs=0.05)
    assert before is not None
    assert check_mesh(before).genus == 0
    assert 1000 < len(before.triangles) < 4000


def test_a_hole_in_the_scan_is_a_hole_in_what_is_supported() -> None:
    ball = on_sphere(RADIUS_MM, 8000, 0.02, 4)
    hole = np.array([1.0, 0.0, 0.3]) / np.linalg.norm([1.0, 0.0, 0.3])
    points, towards = seen(ball[ball @ hole < 0.9 * RADIUS_MM], tuple(range(0, 360, 45)))
    live = surface(made(points + UP, towards))
    along = (live.mesh.vertices - UP) @ hole / np.linalg.norm(live.mesh.vertices - UP, axis=1)
    assert not supported(live)[along > 0.95].any()
    assert supported(live)[(along < 0.85) & (live.mesh.vertices[:, 2] > RADIUS_MM)].mean() > 0.98


def test_a_surface_of_another_place_is_not_followed() -> None:
    points, towards = seen(on_sphere(RADIUS_MM, 4000, 0.02, 5), tuple(range(0, 360, 45)))
    elsewhere = surface(made(points + UP + (100.0, 0, 0), towards))
    live = surface(made(points + UP, towards, elsewhere.mesh))
    assert not live.followed
    assert np.abs(live.mesh.vertices.mean(axis=0) - UP).max() < 1.0


def test_what_makes_no_surface_says_why() -> None:
    ball = on_sphere(RADIUS_MM, 3000, 0.02, 6)
    points, towards = seen(ball, (0.0,))
    flat = np.column_stack([points[:, :2], np.zeros(len(points))])
    for cloud, why in (
        (points[:100], NoSurfaceReason.FEW_POINTS),
        (flat, NoSurfaceReason.NO_BODY),
        (np.repeat(points[:1], len(points), axis=0), NoSurfaceReason.FEW_POINTS),
        (np.full_like(points, np.nan), NoSurfaceReason.FEW_POINTS),
    ):
        answer = made(cloud, towards[: len(cloud)])
        assert isinstance(answer, NoSurfaceYet)
        assert answer.reason is why


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6), count=st.integers(0, 900), flat=st.floats(1e-4, 1.0), strays=st.integers(0, 20))
def test_no_cloud_is_refused_aloud(seed: int, count: int, flat: float, strays: int) -> None:
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(count + strays, 3)) * (10, 6, 10 * flat)
    points[count:] *= 1e3
    towards = rng.normal(size=points.shape)
    towards /= np.linalg.norm(towards, axis=1)[:, None]
    answer = made(points, towards)
    assert isinstance(answer, NoSurfaceYet) or np.isfinite(answer.mesh.vertices).all()


def test_it_is_a_job_and_stops_when_asked() -> None:
    job = resolve(JOBS["live-surface"])
    points, towards = seen(on_sphere(RADIUS_MM, 3000, 0.02, 7), (0.0,))
    request = LiveSurfaceRequest(points.astype(np.float32), towards.astype(np.float32))
    with pytest.raises(Cancelled):
        job(request, progress=lambda progress: None, cancelled=lambda: True)
