"""Passes where the error is: what is planned on simple bodies, and what may never be planned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.acquisition.allocation import Demand, water_fill
from scanner_core.acquisition.beam_rows import beam_rows
from scanner_core.acquisition.next_pass import NextPass, next_pass
from scanner_core.acquisition.surface_places import SurfacePlaces
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.optics.calibration import StereoCalibration
from tests.core.reconstruction.shapes import sphere

RIG = load_preset("bench")
assert RIG.calibration is not None
CALIBRATION: StereoCalibration = RIG.calibration
RATE_HZ, WANTED_UM = 60.0, 20.0
_BALL = sphere(10.0, 4)
BALL = TriangleMesh(_BALL.vertices + np.array([0, 0, 30.0]), _BALL.triangles)
OUTWARD = _BALL.vertices / 10.0


def scanned(uncertainty_um: np.ndarray, seed: int = 0) -> tuple[TriangleMesh, PointCloud]:
    """The ball with the uncertainty (v,) of its vertices, and points of it: the fewer, the more uncertain it is."""
    rng = np.random.default_rng(seed)
    supported = OUTWARD[:, 2] > -0.5
    share = np.where(supported, uncertainty_um ** (-2 / 0.7), 0.0)
    points = BALL.vertices[rng.choice(len(share), 3000, p=share / share.sum())] + 0.02 * rng.standard_normal((3000, 3))
    attributes: dict[str, np.ndarray] = {"standard_uncertainty_um": uncertainty_um.astype(np.float32), "supported": supported.astype(np.uint8)}
    return replace(BALL, vertex_attributes=attributes), PointCloud(points, np.tile(4e-4 * np.eye(3), (3000, 1, 1)))


def planned(uncertainty_um: np.ndarray, budget: int = 2000, wanted_um: float = WANTED_UM) -> NextPass:
    surface, cloud = scanned(uncertainty_um)
    return next_pass(surface, cloud, RIG, CALIBRATION, RATE_HZ, wanted_um, budget, 7, 1000)


UNEVEN = np.where(OUTWARD[:, 0] > 0.3, 40.0, 15.0)


@pytest.fixture(scope="module")
def uneven() -> NextPass:
    return planned(UNEVEN)


def test_ids_and_views_count_on_and_rows_keep_the_limits(uneven: NextPass) -> None:
    rows = [row for view in uneven.views for row in view.rows]
    assert [i for row in rows for i in range(row.first_id, row.first_id + row.count)] == list(range(1000, 1000 + sum(row.count for row in rows)))
    assert [{row.view for row in view.rows} for view in uneven.views] == [{7 + k} for k in range(len(uneven.views))]
    (x_low, x_high), (y_low, y_high) = RIG.limits.x_deg, RIG.limits.y_deg
    assert all(x_low <= row.x_from_deg < row.x_to_deg <= x_high and y_low <= row.y_deg <= y_high for row in rows)
    assert all(0 < (view.sweep_speed_deg_s or 0) <= RIG.limits.sweep_speed_deg_s for view in uneven.views)
    for view in uneven.views:
        steps = [(row.x_to_deg - row.x_from_deg) / (row.count - 1) for row in view.rows]
        np.testing.assert_allclose(steps, (view.sweep_speed_deg_s or 0) / RATE_HZ, rtol=1e-6)


def test_only_where_a_table_that_may_not_turn_on_can_stand() -> None:
    surface, cloud = scanned(UNEVEN)
    rig = replace(RIG, limits=replace(RIG.limits, table_deg=(-100.0, 45.0)))
    plan = next_pass(surface, cloud, rig, CALIBRATION, RATE_HZ, WANTED_UM, 2000, 7, 1000)
    assert plan.views
    assert all(view.table_deg <= 45.0 or view.table_deg >= 260.0 for view in plan.views)


def test_the_budget_is_kept_and_the_gain_is_told(uneven: NextPass) -> None:
    assert 0 < uneven.points <= 2000
    assert sum(view.quota or 0 for view in uneven.views) == uneven.points
    assert uneven.within_now < uneven.within_predicted <= 1
    assert uneven.seconds > sum(row.count for view in uneven.views for row in view.rows) / RATE_HZ


def _beam_hits(plan: NextPass) -> np.ndarray:
    """Vertices next to the planned beams, as often as there are exposures."""
    lines = Sightlines(RIG, CALIBRATION, BALL)
    hits = []
    for view in plan.views:
        sight = lines.at(view.table_deg)
        seen = np.flatnonzero(sight.measurable)
        for row in view.rows:
            x = np.linspace(row.x_from_deg, row.x_to_deg, row.count)
            away = np.hypot(sight.beam_deg[seen, 0][:, None] - x, sight.beam_deg[seen, 1][:, None] - row.y_deg)
            hits.append(seen[away.argmin(axis=0)])
    return np.concatenate(hits)


def test_points_go_where_the_surface_is_uncertain(uneven: NextPass) -> None:
    hits = _beam_hits(uneven)
    assert (OUTWARD[hits, 0] > 0.2).mean() > 0.9


def test_a_surface_that_is_as_wanted_is_left_alone() -> None:
    plan = planned(np.full(len(OUTWARD), 12.0))
    low = _beam_hits(plan) if plan.views else np.zeros(0, int)
    assert (OUTWARD[low, 2] < 0).all()  # the rim that no point bears out
    assert not planned(np.full(len(OUTWARD), 12.0), wanted_um=1e6).views


def test_nothing_is_planned_below_where_no_light_gets() -> None:
    assert (OUTWARD[_beam_hits(planned(np.full(len(OUTWARD), 30.0))), 2] > -0.75).all()


def test_points_off_the_surface_make_their_place_uncertain() -> None:
    """A fit that has bridged a gap does not doubt itself, but the points behind it do."""
    surface, cloud = scanned(np.full(len(OUTWARD), 15.0))
    off = np.array([0.0, 9.3, 30.0]) + np.random.default_rng(1).normal(0, 0.3, (40, 3)) * [1, 0.1, 1]
    both = PointCloud(np.concatenate([cloud.points, off]), np.tile(4e-4 * np.eye(3), (3040, 1, 1)))
    plain, doubted = SurfacePlaces.of(surface, cloud), SurfacePlaces.of(surface, both)
    there = np.linalg.norm(plain.points - [0, 10, 30], axis=1) < 0.4
    elsewhere = np.linalg.norm(plain.points - [0, 10, 30], axis=1) > 4
    assert (doubted.demand.uncertainty_um[there] > 2 * plain.demand.uncertainty_um[there]).all()
    np.testing.assert_allclose(doubted.demand.uncertainty_um[elsewhere], plain.demand.uncertainty_um[elsewhere], rtol=0.2)


demands = st.integers(0, 10_000).map(
    lambda seed: (
        Demand(*np.exp(np.random.default_rng(seed).normal(size=(3, 40)) * [[0.5], [1.0], [0.7]] + [[0.0], [-5.0], [3.0]])),
        np.exp(np.random.default_rng(seed + 1).normal(size=40)) * 20,
    )
)


@settings(max_examples=30, deadline=None)
@given(demand=demands, budget=st.floats(1, 1e5), wanted_um=st.floats(1, 60))
def test_water_filling(demand: tuple[Demand, np.ndarray], budget: float, wanted_um: float) -> None:
    """Within the budget, never beyond what is wanted, monotone in the budget, and no exchange of points is better."""
    known, sd_um = demand
    sd_um = np.where(np.arange(40) % 7 == 0, np.inf, sd_um)
    added = water_fill(known, sd_um, budget, wanted_um)
    cost = known.area_mm2 * np.where(np.isfinite(sd_um), sd_um, 0) ** 2
    assert (added >= 0).all()
    assert (added[::7] == 0).all()
    assert cost @ added <= budget * (1 + 1e-9)
    assert (known.after(added) >= np.minimum(wanted_um, known.uncertainty_um) * (1 - 1e-9)).all()
    sparse = water_fill(known, sd_um, budget, wanted_um, densest_mm2=0.5)
    assert (sparse * np.where(np.isfinite(sd_um), sd_um, 0) ** 2 <= 0.5 * (1 + 1e-9)).all()
    more = water_fill(known, sd_um, 1.5 * budget, wanted_um)
    assert (more >= added * (1 - 1e-6) - 1e-12).all()
    gain = np.where(cost > 0, known.area_mm2 * known.after(added) ** 2 / (known.information + added) / np.maximum(cost, 1e-300), 0.0)
    open_ended = (cost > 0) & (added < known.most(wanted_um) * (1 - 1e-6))
    bought = (cost > 0) & (added > 1e-9)
    if open_ended.any() and bought.any():
        assert gain[open_ended].max() <= gain[bought].min() * 1.001


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 1000), dense=st.floats(300, 3000), ratio=st.floats(0.1, 1.0))
def test_rows_hold_as_many_exposures_as_are_wanted(seed: int, dense: float, ratio: float) -> None:
    """Two halves of a square with different densities, at a spacing of places as surfaces have it."""
    rng = np.random.default_rng(seed)
    places = rng.uniform(-1, 1, (1500, 2))
    density = np.where(places[:, 0] < 0, dense, ratio * dense)
    wanted = float(2 * dense * (1 + ratio))
    found = beam_rows(places, density, wanted, 0.1, (1e-3, 1.0), ((-16, 16), (-12, 16)), 3, 50)
    assert abs(found.exposures - wanted) < 0.12 * wanted + 40
    left = sum(row.count for row in found.rows if row.x_to_deg < 0)
    whole = sum(row.count for row in found.rows if row.x_from_deg < -0.1 and row.x_to_deg > 0.1)
    assert left + whole >= 0.3 * found.exposures
