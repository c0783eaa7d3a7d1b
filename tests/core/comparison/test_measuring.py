from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given as for_all
from hypothesis import settings
from hypothesis import strategies as st

from scanner_core.comparison.measuring import deviation_statistics, measure_deviation, weighted_percentiles
from scanner_core.comparison.parameters import ComparisonParameters
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.subdivision import subdivide_uniform
from tests.core.comparison.aligned import given, plane, pose, surface
from tests.core.geometry.solids import sphere, torus

PARAMETERS = ComparisonParameters()


def test_two_spheres_read_the_difference_of_their_radii() -> None:
    inner, outer = sphere(5.0, 96, 48), sphere(5.4, 96, 48)
    result = measure_deviation(surface(inner), surface(outer), given(outer), PARAMETERS)
    sag = 1e3 * 5.4 * (1 - np.cos(np.pi / 48))  # a facet lies under the sphere by this at most
    assert result.signed_um == pytest.approx(np.full(len(outer.vertices), 400.0), abs=sag)
    assert result.before_signed_um == pytest.approx(np.full(len(inner.vertices), -400.0), abs=sag)
    assert result.statistics.mean_um == pytest.approx(400.0, abs=sag)
    assert result.statistics.area_above_mm2["250"] == pytest.approx(outer.area())
    assert result.statistics.area_above_mm2["500"] == 0
    assert result.statistics.no_counterpart_fraction == 0


def test_what_has_no_counterpart_is_left_out_of_every_number() -> None:
    before, after = plane(10.0, 0.5), plane(14.0, 0.5, 0.1)
    high = after.vertices.copy()
    peak = np.linalg.norm(high[:, :2], axis=1) < 0.1
    high[peak, 2] = 3.5  # farther than 3 mm
    after = TriangleMesh(high, after.triangles)
    result = measure_deviation(surface(before), surface(after), given(after), PARAMETERS)
    outside = (np.abs(after.vertices[:, :2]) >= 5.0).any(axis=1)
    assert np.isnan(result.signed_um[outside | peak]).all()
    assert result.signed_um[~outside & ~peak] == pytest.approx(100.0)
    statistics = result.statistics
    assert (statistics.max_um, statistics.rms_um, statistics.p50_um) == pytest.approx((100.0, 100.0, 100.0))
    assert statistics.hausdorff_after_to_before_um == pytest.approx(100.0)
    assert statistics.points == (~outside & ~peak).sum()
    assert 0.4 < statistics.no_counterpart_fraction < 0.7


def test_of_the_same_open_surface_nothing_is_left_out() -> None:
    mesh = plane(10.0, 0.5)
    result = measure_deviation(surface(mesh), surface(mesh), given(mesh), PARAMETERS)
    assert result.statistics.no_counterpart_fraction == 0
    assert np.isfinite(result.before_signed_um).all()
    assert result.statistics.max_um == 0


def test_unsupported_parts_of_either_surface_do_not_count() -> None:
    before, after = plane(10.0, 0.5), plane(9.0, 0.5, 0.2)
    before_supported = before.vertices[:, 0] < 1.9
    after_supported = after.vertices[:, 0] > -2.1
    result = measure_deviation(surface(before, before_supported), surface(after, after_supported), given(after), PARAMETERS)
    assert np.array_equal(np.isfinite(result.signed_um), (after.vertices[:, 0] > -2.1) & (after.vertices[:, 0] < 1.6))
    assert np.isnan(result.before_signed_um[~before_supported]).all()


def test_statistics_weigh_by_area_not_by_vertices() -> None:
    """A fine patch of ten thousand vertices at 0.4 mm counts as what it covers: a quarter of the surface."""
    signed = np.concatenate([np.full(30, 100.0), np.full(10000, -400.0)])
    area = np.concatenate([np.full(30, 1.0), np.full(10000, 1e-3)])
    statistics = deviation_statistics(signed, np.array([50.0, np.nan, -70.0]), area)
    assert statistics.mean_um == pytest.approx((30 * 100 - 10 * 400) / 40)
    assert statistics.rms_um == pytest.approx(np.sqrt((30 * 100**2 + 10 * 400**2) / 40))
    assert statistics.p50_um == pytest.approx(100.0)
    assert statistics.p95_um == pytest.approx(400.0)
    assert statistics.area_above_mm2 == pytest.approx({"100": 10.0, "250": 10.0, "500": 0.0})
    assert statistics.hausdorff_before_to_after_um == 70.0


def test_percentiles_of_equal_weights_are_the_usual_ones() -> None:
    values = np.random.default_rng(3).normal(size=4001)
    found = weighted_percentiles(values, np.full(4001, 2.0), (5.0, 50.0, 95.0))
    assert found == pytest.approx(np.percentile(values, [5, 50, 95], method="hazen"), abs=1e-9)


def test_level_of_detection_joins_noise_and_alignment_and_is_never_zero() -> None:
    before, after = plane(6.0, 0.5), plane(5.0, 0.5)
    both = measure_deviation(surface(before), surface(after), given(after, noise_um=30.0, sd_um=40.0), PARAMETERS)
    assert both.level_um == pytest.approx(1.96 * 50.0)
    assert both.detection_level_um == pytest.approx(1.96 * 50.0)
    same = measure_deviation(surface(after), surface(after), given(after), PARAMETERS)
    assert 0 < same.detection_level_um < 2
    assert same.statistics.max_um < same.detection_level_um


def test_where_a_surface_states_a_greater_uncertainty_of_its_own_the_level_follows_it() -> None:
    before, after = plane(6.0, 0.5), plane(5.0, 0.5)
    bad = np.where(after.vertices[:, 0] > 0.1, 90.0, 5.0).astype(np.float32)
    after.vertex_attributes["standard_uncertainty_um"] = bad
    before.vertex_attributes["standard_uncertainty_um"] = np.full(len(before.vertices), 40.0, np.float32)
    level = measure_deviation(surface(before), surface(after), given(after, noise_um=50.0), PARAMETERS).level_um
    assert level[bad > 50] == pytest.approx(1.96 * np.hypot(90.0, 40.0), rel=1e-5)
    assert level[bad < 50] == pytest.approx(1.96 * 50.0, rel=1e-5)


@settings(max_examples=8, deadline=None)
@for_all(st.integers(0, 2**32 - 1))
def test_poses_do_not_matter_and_swapping_the_surfaces_swaps_the_two_directions(seed: int) -> None:
    before, after = torus(5.0, 2.0, 24, 12), subdivide_uniform(torus(5.0, 2.2, 15, 10))
    here = measure_deviation(surface(before), surface(after), given(after), PARAMETERS)
    motion = pose(seed)
    posed = TriangleMesh(motion.inverse().apply(after.vertices), after.triangles)
    there = measure_deviation(surface(before), surface(posed), given(posed, motion), PARAMETERS)
    assert there.signed_um == pytest.approx(here.signed_um, abs=1e-5)
    swapped = measure_deviation(surface(after), surface(before), given(before), PARAMETERS)
    assert swapped.signed_um == pytest.approx(here.before_signed_um, abs=1e-9)
    assert swapped.before_signed_um == pytest.approx(here.signed_um, abs=1e-9)
    assert here.statistics.mean_um > 0 > swapped.statistics.mean_um
