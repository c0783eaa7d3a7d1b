from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.errors import ReconstructionError, UsageError
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.proximity import closest_points
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.reconstruction.facets import facet_sag_mm
from scanner_core.reconstruction.observations import observations_of
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import Reconstruction, reconstruct
from scanner_core.reconstruction.repair import triangle_qualities
from tests.core.reconstruction.shapes import horseshoe, impression, on_sphere, run, sampled, unit_sphere

NOISE_MM = 0.17


@pytest.fixture(scope="module")
def seen() -> list[Progress]:
    return []


@pytest.fixture(scope="module")
def ear(seen: list[Progress]) -> Reconstruction:
    return run(sampled(impression(), 3500, NOISE_MM, 1), seen=seen)


def rms_um(result: Reconstruction, truth: TriangleMesh, supported_only: bool = False) -> float:
    mesh = result.mesh
    centroids = mesh.vertices[mesh.triangles].mean(axis=1)
    if supported_only:
        centroids = centroids[(mesh.vertex_attributes["supported"][mesh.triangles] == 1).all(axis=1)]
    distance = closest_points(truth, centroids).distances_mm
    return 1e3 * float(np.sqrt((distance**2).mean()))


def assert_sound(result: Reconstruction) -> None:
    checks = check_mesh(result.mesh)
    assert checks.closed
    assert checks.manifold
    assert checks.outward
    assert checks.components == 1
    assert checks.genus == 0
    assert checks.self_intersections == 0


def test_impression_is_closed_and_its_error_is_far_below_the_noise(ear: Reconstruction) -> None:
    assert_sound(ear)
    assert rms_um(ear, impression()) < 0.5 * 1e3 * NOISE_MM
    assert ear.report.noise_sigma_um == pytest.approx(170, rel=0.08)
    assert ear.report.supported_area_fraction > 0.99
    assert ear.report.outliers_rejected < 20


def test_predicted_error_is_of_the_size_of_the_true_one(ear: Reconstruction) -> None:
    true = rms_um(ear, impression())
    assert 0.5 * true < ear.report.expected_error_rms_um < 2 * true
    uncertainty = ear.mesh.vertex_attributes["standard_uncertainty_um"]
    assert uncertainty.dtype == np.float32
    assert uncertainty.shape == (len(ear.mesh.vertices),)
    assert float(uncertainty.min()) > 0


def test_progress_names_the_three_phases_in_order_and_never_goes_back(ear: Reconstruction, seen: list[Progress]) -> None:
    names = [p.phase for p in seen]
    assert list(dict.fromkeys(names)) == ["inflate", "refine", "smooth"]
    fractions = [p.fraction for p in seen]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    first = next(p.preview for p in seen if p.preview is not None)
    assert len(first.vertices) == 12
    assert len(first.triangles) == 20


def test_report_has_the_keys_of_the_command_line(ear: Reconstruction) -> None:
    report = ear.report.as_dict()
    assert set(report) == {
        "points", "outliers_rejected", "noise_sigma_um", "vertices", "triangles", "closed", "genus", "self_intersections",
        "supported_area_fraction", "residual_rms_um", "expected_error_rms_um", "phases", "seconds", "peak_memory_mb", "warnings",
        "volume_mm3", "facet_sag_um", "stopped_early", "distances", "remarks",
    }  # fmt: skip
    assert [p.name for p in ear.report.phases] == ["inflate", "refine", "smooth"]
    assert report["triangles"] == len(ear.mesh.triangles)


def test_same_points_and_seed_give_the_same_bytes() -> None:
    points = sampled(impression(), 800, NOISE_MM, 4)
    one, two = (run(points, ReconstructionParameters(triangles=4000, seed=5)) for _ in range(2))
    assert one.mesh.vertices.tobytes() == two.mesh.vertices.tobytes()
    assert one.mesh.triangles.tobytes() == two.mesh.triangles.tobytes()


def test_sphere_has_the_true_radius() -> None:
    rng = np.random.default_rng(7)
    directions = rng.normal(size=(3500, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    result = run(11.133 * directions + 0.1 * rng.normal(size=(3500, 3)) + (100.0, -50.0, 30.0))
    assert_sound(result)
    radius = (result.mesh.volume() * 3 / (4 * np.pi)) ** (1 / 3)
    # 3,500 points with 100 um know the radius to 1.7 um
    assert radius == pytest.approx(11.133, abs=0.006)
    areas = result.mesh.areas()
    centre = (areas[:, None] * result.mesh.vertices[result.mesh.triangles].mean(axis=1)).sum(axis=0) / areas.sum()
    np.testing.assert_allclose(centre, (100, -50, 30), atol=0.02)


def test_horseshoe_fills_from_one_inside_point() -> None:
    truth = horseshoe()
    result = run(sampled(truth, 4000, 0.05, 2))
    assert_sound(result)
    assert rms_um(result, truth) < 50
    assert result.mesh.volume() == pytest.approx(truth.volume(), rel=0.01)


def test_unscanned_base_gets_a_flat_cap_that_is_marked() -> None:
    truth = impression()
    base = -5.0
    result = run(sampled(truth, 3500, 0.1, 3, keep=lambda p: p[:, 2] > base))
    assert_sound(result)
    supported = result.mesh.vertex_attributes["supported"] == 1
    assert 0.6 < result.report.supported_area_fraction < 0.97
    assert any("not scanned" in warning for warning in result.report.warnings)
    assert rms_um(result, truth, supported_only=True) < 120
    cap = result.mesh.vertices[~supported]
    assert np.ptp(cap[:, 2]) < 0.8  # a soap film over 12 mm: flat, no bulge
    assert np.all(np.abs(cap[:, 2] - base) < 1.2)


def test_open_holes_leaves_the_cap_away() -> None:
    points = sampled(impression(), 1500, 0.1, 3, keep=lambda p: p[:, 2] > -5.0)
    opened = run(points, ReconstructionParameters(open_holes=True, triangles=3000))
    assert check_mesh(opened.mesh).boundary_edges > 20
    assert not opened.report.closed
    assert np.all(opened.mesh.vertex_attributes["supported"] == 1)


def test_stray_points_do_not_move_the_surface() -> None:
    truth = impression()
    points = sampled(truth, 3500, 0.1, 5)
    rng = np.random.default_rng(6)
    low, high = points.min(axis=0), points.max(axis=0)
    points[rng.choice(3500, 70, replace=False)] = low + rng.random((70, 3)) * (high - low)
    result = run(points)
    assert_sound(result)
    assert rms_um(result, truth) < 75
    assert 30 < result.report.outliers_rejected < 110


@pytest.mark.parametrize("triangles", [600, 5001, 30000])
def test_triangle_budget_is_met_within_two_per_cent(triangles: int) -> None:
    result = run(sampled(impression(), 2000, 0.05, 8), ReconstructionParameters(triangles=triangles))
    assert 0.98 * triangles <= len(result.mesh.triangles) <= triangles
    assert len(result.mesh.triangles) % 2 == 0
    assert_sound(result)


def test_tolerance_bounds_the_sag_of_the_facets() -> None:
    points = sampled(impression(), 2000, 0.05, 8)
    coarse, fine = (run(points, ReconstructionParameters(tolerance_um=tolerance)) for tolerance in (40.0, 10.0))
    assert facet_sag_mm(coarse.mesh) < 1.3 * 0.040
    assert facet_sag_mm(fine.mesh) < 1.3 * 0.010
    assert len(fine.mesh.triangles) > 2 * len(coarse.mesh.triangles)


def unevenly_noisy(seed: int, share: float = 0.5) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points of which a share has 0.1 mm and the rest 0.5 mm of noise, the covariances that say so, and which are the good ones."""
    rng = np.random.default_rng(seed)
    good = rng.random(4000) < share
    sigma = np.where(good, 0.1, 0.5)
    points = sampled(impression(), 4000, 0.0, seed) + sigma[:, None] * rng.normal(size=(4000, 3))
    return points, sigma[:, None, None] ** 2 * np.eye(3), good


EIGHT_THOUSAND = ReconstructionParameters(triangles=8000)


@pytest.fixture(scope="module")
def weighted() -> Reconstruction:
    points, covariances, _ = unevenly_noisy(0)
    return run(points, EIGHT_THOUSAND, covariances=covariances)


def test_covariances_are_weights(weighted: Reconstruction) -> None:
    assert_sound(weighted)
    assert rms_um(weighted, impression()) < 0.87 * rms_um(run(unevenly_noisy(0)[0], EIGHT_THOUSAND), impression())


def test_bad_points_with_covariances_do_no_harm() -> None:
    points, covariances, good = unevenly_noisy(0, 0.4)
    all_of_them = run(points, EIGHT_THOUSAND, covariances=covariances)
    assert rms_um(all_of_them, impression()) < 1.05 * rms_um(run(points[good], EIGHT_THOUSAND), impression())


def test_scale_of_the_covariances_does_not_matter_and_bytes_repeat(weighted: Reconstruction) -> None:
    points, covariances, _ = unevenly_noisy(0)
    again, wrong = (run(points, EIGHT_THOUSAND, covariances=factor * covariances) for factor in (1.0, 64.0))
    for name in ("vertices", "triangles"):
        assert getattr(again.mesh, name).tobytes() == getattr(weighted.mesh, name).tobytes()
        assert getattr(wrong.mesh, name).tobytes() == getattr(weighted.mesh, name).tobytes()
    other = run(points, EIGHT_THOUSAND, covariances=3.7 * covariances)
    assert rms_um(other, impression()) == pytest.approx(rms_um(weighted, impression()), rel=0.01)


@pytest.mark.parametrize("count", [200, 1000, *(pytest.param(count, marks=pytest.mark.long) for count in (500, 2000, 4000))])
def test_sphere_without_noise(count: int) -> None:
    result = run(on_sphere(10.0, count, 0.0, 1))
    assert_sound(result)
    assert result.mesh.volume() == pytest.approx(4 / 3 * np.pi * 1000, rel=1e-3)
    assert result.report.supported_area_fraction > 0.99
    uncertainty = result.mesh.vertex_attributes["standard_uncertainty_um"]
    assert np.all(np.isfinite(uncertainty))
    assert float(uncertainty.min()) > 0


def test_many_points_are_merged_and_say_no_less_than_fewer() -> None:
    many = sampled(impression(), 300_000, NOISE_MM, 5)
    assert 60_000 < len(observations_of(many, None)) < 130_000
    parameters = ReconstructionParameters(triangles=12_000)
    one, two, fewer = run(many, parameters), run(many, parameters), run(sampled(impression(), 60_000, NOISE_MM, 5), parameters)
    assert_sound(one)
    assert one.report.points == 300_000
    assert one.report.noise_sigma_um == pytest.approx(170, rel=0.03)
    assert one.mesh.vertices.tobytes() == two.mesh.vertices.tobytes()
    assert one.mesh.triangles.tobytes() == two.mesh.triangles.tobytes()
    assert rms_um(one, impression()) < rms_um(fewer, impression())


@pytest.mark.parametrize("noise_mm", [0.17, 1.0])
def test_triangles_are_well_shaped_and_uncertainties_finite(noise_mm: float) -> None:
    result = run(sampled(impression(), 3500, noise_mm, 11))
    assert_sound(result)
    assert float(triangle_qualities(result.mesh.vertices, result.mesh.triangles).min()) >= 0.15
    uncertainty = result.mesh.vertex_attributes["standard_uncertainty_um"]
    assert np.all(np.isfinite(uncertainty))
    assert float(uncertainty.min()) > 0


def test_boundary_of_open_holes_is_at_the_rim_of_the_points() -> None:
    points = sampled(impression(), 3500, 0.1, 3, keep=lambda p: p[:, 2] > -5.0)
    mesh = run(points, ReconstructionParameters(open_holes=True)).mesh
    sides = np.sort(mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    rim = mesh.vertices[np.unique(edges[count == 1])]
    assert float(np.abs(rim[:, 2] + 5.0).max()) < 1.0
    assert np.all(mesh.vertex_attributes["supported"] == 1)
    checks = check_mesh(mesh)
    assert checks.components == 1
    assert checks.manifold


def even_pattern(directions: np.ndarray, seed: int, size: float) -> np.ndarray:
    """A random mixture of low harmonics, relative to one, at unit directions (n, 3)."""
    rng = np.random.default_rng(seed)
    x, y, z = directions.T
    waves = np.stack([x * y, y * z, z * x, x**2 - y**2, 3 * z**2 - 1, x * (5 * z**2 - 1), z * (5 * z**2 - 3), x * y * z], axis=1)
    return np.asarray(1 + size * waves @ rng.uniform(-1, 1, 8) / np.sqrt(8))


@settings(max_examples=8)
@given(seed=st.integers(0, 10_000), count=st.integers(300, 2500), noise=st.floats(0.0, 0.05), size=st.floats(0.0, 0.7), scale=st.floats(3.0, 60.0))
def test_any_star_shaped_body_gives_a_sound_mesh_or_one_sentence(seed: int, count: int, noise: float, size: float, scale: float) -> None:
    body = unit_sphere(5)
    truth = TriangleMesh(scale * even_pattern(body.vertices, seed, size)[:, None] * body.vertices, body.triangles)
    result, refusal = None, ""
    try:
        result = run(sampled(truth, count, noise * scale, seed), ReconstructionParameters(triangles=3000))
    except ReconstructionError as error:
        refusal = str(error)
    if result is None:
        assert refusal
        assert "\n" not in refusal
    else:
        assert_sound(result)
        assert result.mesh.volume() == pytest.approx(truth.volume(), rel=0.05)


class Hesitant:
    """A caller who asks to stop when a phase has looked for that so many times."""

    def __init__(self, phase: str, looks: int) -> None:
        self._phase = phase
        self._looks = looks
        self._current = ""
        self.after = 0

    def told(self, progress: Progress) -> None:
        self._current = progress.phase

    def cancelled(self) -> bool:
        if self._current == self._phase:
            self._looks -= 1
        self.after += self._looks < 0
        return self._looks < 0


@pytest.mark.parametrize(("phase", "looks"), [("inflate", 20), ("refine", 3), ("refine", 60), ("refine", 200), ("smooth", 2), ("smooth", 10)])
def test_cancel_stops_in_the_midst_of_a_phase(phase: str, looks: int) -> None:
    caller = Hesitant(phase, looks)
    with pytest.raises(Cancelled):
        reconstruct(PointCloud(POINTS_TO_STOP), ReconstructionParameters(), progress=caller.told, cancelled=caller.cancelled)
    assert caller.after == 1


POINTS_TO_STOP = sampled(impression(), 1500, 0.1, 9)


class Content:
    """A caller who is content with the surface that he sees first in a phase, once it has so many triangles."""

    def __init__(self, phase: str, triangles: int = 0) -> None:
        self._phase, self._triangles = phase, triangles
        self._content = False
        self.seen: list[Progress] = []

    def told(self, progress: Progress) -> None:
        self.seen.append(progress)
        if progress.phase == self._phase and (progress.preview is not None and len(progress.preview.triangles) >= self._triangles):
            self._content = True

    def enough(self) -> bool:
        return self._content


@pytest.mark.parametrize(("caller", "fewest", "most"), [(Content("inflate"), 1000, 3000), (Content("refine", 4000), 4000, 8000)])
def test_what_is_kept_early_is_whole_and_knows_that_it_is_coarser(caller: Content, fewest: int, most: int) -> None:
    points = sampled(impression(), 3500, 0.05, 1)
    result = reconstruct(PointCloud(points), ReconstructionParameters(), progress=caller.told, cancelled=lambda: False, enough=caller.enough)
    assert_sound(result)
    report = result.report
    assert report.stopped_early
    assert fewest < report.triangles < most
    assert list(dict.fromkeys(p.phase for p in caller.seen)) == ["inflate", "refine", "smooth"]
    assert report.supported_area_fraction > 0.99
    true = rms_um(result, impression())
    assert 0.8 * true < report.expected_error_rms_um < 2.5 * true
    assert float(np.min(result.mesh.vertex_attributes["standard_uncertainty_um"])) > 0


def test_nobody_who_waits_is_told_of_an_early_end(ear: Reconstruction) -> None:
    assert not ear.report.stopped_early


def test_distances_of_the_points_come_with_the_previews_and_shrink_to_the_noise(ear: Reconstruction, seen: list[Progress]) -> None:
    told = [p.distances for p in seen if p.distances is not None]
    assert all(p.preview is not None for p in seen if p.distances is not None)
    assert told[0].median_um > 1000  # a small ball amid the points
    last = ear.report.distances
    assert last is not None
    assert sum(last.counts) == 2000
    # the median of what is normal with sigma is 0.6745 sigma, 95 of 100 are within 1.96
    assert last.median_um == pytest.approx(0.6745 * 170, rel=0.1)
    assert last.p95_um == pytest.approx(1.96 * 170, rel=0.1)


def test_detail_asks_for_so_many_times_the_triangles_that_the_points_carry() -> None:
    points = sampled(impression(), 1500, 0.1, 9)
    whole, half = (run(points, ReconstructionParameters(detail=detail)).report for detail in (1.0, 0.5))
    assert 0.48 * whole.triangles < half.triangles <= 0.5 * whole.triangles
    # the triangles are larger, and so is what they depart from the surface
    assert half.facet_sag_um == pytest.approx(2 * whole.facet_sag_um, rel=0.35)


def test_a_higher_threshold_of_support_counts_less_as_measured() -> None:
    points = sampled(impression(), 1500, 0.1, 3, keep=lambda p: p[:, 2] > -5.0)
    usual, strict = (run(points, ReconstructionParameters(triangles=3000, least_support=least)).report for least in (0.45, 0.8))
    assert strict.supported_area_fraction < usual.supported_area_fraction - 0.01


class Impatient:
    """A caller who asks to stop as soon as a phase has begun."""

    def __init__(self, phase: str) -> None:
        self._phase = phase
        self.phases: list[str] = []

    def told(self, progress: Progress) -> None:
        self.phases.append(progress.phase)

    def cancelled(self) -> bool:
        return self._phase in self.phases


def test_cancel_stops_in_every_phase() -> None:
    points = PointCloud(sampled(impression(), 1500, 0.1, 9))
    for phase in ("inflate", "refine", "smooth"):
        caller = Impatient(phase)
        with pytest.raises(Cancelled):
            reconstruct(points, ReconstructionParameters(), progress=caller.told, cancelled=caller.cancelled)
        assert caller.phases[-1] == phase


def refused(points: np.ndarray) -> ReconstructionError:
    with pytest.raises(ReconstructionError) as caught:
        run(points)
    assert "\n" not in str(caught.value)
    return caught.value


def test_what_cannot_be_a_body_is_refused_with_one_sentence() -> None:
    rng = np.random.default_rng(0)
    assert refused(rng.normal(size=(49, 3))).code == "E-REC-01"
    broken = rng.normal(size=(200, 3))
    broken[3, 1] = np.nan
    assert refused(broken).code == "E-REC-04"
    plane = rng.uniform(-10, 10, size=(2000, 3)) * (1, 1, 0)
    assert refused(plane).code == "E-REC-02"
    assert refused(plane + 0.05 * rng.normal(size=plane.shape)).code == "E-REC-02"
    assert refused(np.linspace(0, 1, 500)[:, None] * (1.0, 2.0, 3.0)).code == "E-REC-02"
    assert refused(np.zeros((500, 3))).code == "E-REC-01"  # one point, five hundred times


def test_a_ring_is_refused_because_a_balloon_has_no_hole() -> None:
    rng = np.random.default_rng(1)
    around, tube = rng.uniform(0, 2 * np.pi, size=(2, 6000))
    ring = 10 + 3 * np.cos(tube)
    points = np.stack([ring * np.cos(around), ring * np.sin(around), 3 * np.sin(tube)], axis=1)
    error = refused(points + 0.03 * rng.normal(size=points.shape))
    assert error.code == "E-REC-03"
    assert "1 hole" in str(error)


def test_impossible_requests_are_refused() -> None:
    with pytest.raises(UsageError):
        ReconstructionParameters(triangles=10)
    with pytest.raises(UsageError):
        ReconstructionParameters(tolerance_um=0)
    with pytest.raises(UsageError):
        ReconstructionParameters(detail=0.0)
    with pytest.raises(UsageError):
        ReconstructionParameters(smoothing_rounds=-1)
    with pytest.raises(UsageError):
        ReconstructionParameters(pass_band=1.5)
    with pytest.raises(UsageError):
        ReconstructionParameters(least_support=0.0)


def test_unit_sphere_of_the_tests_is_round() -> None:
    assert unit_sphere(4).volume() == pytest.approx(4 / 3 * np.pi, rel=0.005)
