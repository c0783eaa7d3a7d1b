"""What is refused before any work, what is only remarked on, and what must not be taken for a fault."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from scanner_core.errors import ReconstructionError
from scanner_core.jobs.progress import Cancelled
from scanner_core.reconstruction.acceptance import Accepted, accept, check_fit
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.remarks import RemarkKind
from scanner_core.virtual.specimens import load_specimen
from tests.core.reconstruction.shapes import impression, run, sampled, unit_sphere

Array = NDArray[np.float64]
SPACING = np.sqrt(4 * np.pi * 100 / 4000)
"""Of `ball(4000)`."""


def ball(count: int, radius: float = 10.0, seed: int = 0) -> Array:
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(radius * points / np.linalg.norm(points, axis=1)[:, None])


def taken(points: Array) -> Accepted:
    return accept(points, 0, lambda: None)


def refused(points: Array) -> ReconstructionError:
    with pytest.raises(ReconstructionError) as caught:
        taken(points)
    assert "\n" not in str(caught.value)
    return caught.value


def scattered(points: Array, count: int, seed: int = 0) -> Array:
    """The cloud with `count` of its points spread evenly through its box."""
    rng = np.random.default_rng(seed)
    low, high = points.min(axis=0), points.max(axis=0)
    points = points.copy()
    points[rng.choice(len(points), count, replace=False)] = low + rng.random((count, 3)) * (high - low)
    return points


# ----------------------------------------------------------------------------------------------- number and place


def test_too_few_and_broken_points() -> None:
    assert refused(np.empty((0, 3))).fields["points"] == 0
    assert refused(ball(49)).code == "E-REC-01"
    assert len(taken(ball(50)).points) == 50
    for value in (np.nan, np.inf, -np.inf, 1e300):
        broken = ball(200)
        broken[7, 2] = value
        error = refused(broken)
        assert (error.code, error.fields["count"]) == ("E-REC-04", 1)


def test_points_that_repeat_are_counted_once() -> None:
    points = sampled(impression(), 1500, 0.1, 3)
    again = np.concatenate([points, points[::-1], points[:100]])
    accepted = taken(again)
    np.testing.assert_allclose(accepted.points + accepted.centre_mm, points, atol=1e-5)
    assert [remark.kind for remark in accepted.remarks] == [RemarkKind.COPIES]
    assert refused(np.repeat(ball(49), 100, axis=0)).code == "E-REC-01"
    assert refused(np.zeros((500, 3))).code == "E-REC-01"
    assert "1 different points" in str(refused(np.zeros((500, 3))))


def test_repeated_points_give_the_same_mesh() -> None:
    points = sampled(impression(), 800, 0.1, 3)
    parameters = ReconstructionParameters(triangles=2000)
    once, thrice = run(points, parameters), run(np.repeat(points, 3, axis=0), parameters)
    assert once.mesh.vertices.tobytes() == thrice.mesh.vertices.tobytes()
    assert thrice.report.points == 2400


# ----------------------------------------------------------------------------------------------- flat


@settings(max_examples=30)
@given(
    shape=st.sampled_from(["plane", "disc", "line", "clustered line"]),
    noise=st.sampled_from([0.0, 1e-6, 0.01, 0.1, 0.3]),
    turn=st.integers(0, 1000),
    offset=st.sampled_from([0.0, 1e3, 1e6]),
    strays=st.sampled_from([0, 20]),
)
def test_planes_and_lines_are_refused_however_they_lie(shape: str, noise: float, turn: int, offset: float, strays: int) -> None:
    rng = np.random.default_rng(turn)
    points = rng.uniform(-10, 10, size=(1000, 3)) * {"plane": (1, 1, 0), "disc": (1, 0.5, 0)}.get(shape, (1, 0, 0))
    if shape == "disc":
        points = points[(points[:, 0] / 10) ** 2 + (points[:, 1] / 5) ** 2 < 1]
    if shape == "clustered line":
        points **= 3
    points = points + noise * rng.normal(size=points.shape)
    points[:strays] = rng.uniform(-10, 10, size=(strays, 3))
    points = Rotation.random(random_state=turn).apply(points) + offset
    assert refused(points).code == "E-REC-02"


def test_a_thin_plate_is_a_body() -> None:
    rng = np.random.default_rng(1)
    plate = rng.uniform(-20, 20, size=(6000, 3))
    plate[:, 2] = np.sign(rng.normal(size=6000))
    assert len(taken(plate + 0.05 * rng.normal(size=plate.shape)).points) == 6000


# ----------------------------------------------------------------------------------------------- objects


@pytest.mark.parametrize(("share", "count"), [(1.0, 4000), (0.1, 400), (0.06, 240)])
@pytest.mark.parametrize("gap", [11.5, 30, 1000])
def test_a_second_object_is_refused_with_its_share_and_gap(share: float, count: int, gap: float) -> None:
    radius = 10 * np.sqrt(share)
    second = ball(count, radius, 1) + np.array([10 + radius + gap * SPACING, 0, 0])
    error = refused(np.concatenate([ball(4000), second]))
    assert error.code == "E-REC-05"
    assert error.fields["count"] == 2
    assert float(str(error.fields["share"])) == pytest.approx(100 * count / (4000 + count), abs=0.51)
    assert float(str(error.fields["gap_mm"])) == pytest.approx(gap * SPACING, abs=0.3, rel=0.02)


def test_three_objects_and_objects_with_strays_between_them() -> None:
    points = ball(4000)
    assert refused(np.concatenate([points, points + np.array([40, 0, 0]), points + np.array([0, 50, 0])])).fields["count"] == 3
    two = np.concatenate([points, points + np.array([20 + 20 * SPACING, 0, 0])])
    assert refused(scattered(two, 160)).fields["count"] == 2


def test_near_parts_are_one_object() -> None:
    points = ball(4000)
    accepted = taken(np.concatenate([points, points + np.array([20 + 7 * SPACING, 0, 0])]))
    assert accepted.strays == 0


@pytest.mark.parametrize("gap", [12, 200])
def test_a_small_far_group_is_left_out_with_a_warning(gap: float) -> None:
    points = ball(4000)
    accepted = taken(np.concatenate([points, ball(150, 2.0, 1) + np.array([12 + gap * SPACING, 0, 0])]))
    assert accepted.strays == 150
    assert len(accepted.points) == 4000
    np.testing.assert_allclose(accepted.centre_mm, 0.5 * (points.min(axis=0) + points.max(axis=0)))
    assert any("150 points (3.6 %)" in remark.words() and "strays" in remark.words() for remark in accepted.remarks)


def test_left_out_strays_are_counted_and_do_not_move_the_mesh() -> None:
    points = sampled(impression(), 1500, 0.1, 3)
    parameters = ReconstructionParameters(triangles=2000)
    alone = run(points, parameters)
    with_strays = run(np.concatenate([points, 0.1 * ball(40) + np.array([300, 0, 0])]), parameters)
    assert with_strays.mesh.vertices.tobytes() == alone.mesh.vertices.tobytes()
    assert with_strays.report.outliers_rejected == alone.report.outliers_rejected + 40
    assert any("40 points" in warning for warning in with_strays.report.warnings)


@pytest.mark.parametrize("name", ["ear", "arch", "heart", "sphere"])
@pytest.mark.parametrize(
    ("count", "noise_mm"),
    [(3500, 1.0), (20_000, 0.05), pytest.param(3500, 0.05, marks=pytest.mark.long), pytest.param(20_000, 0.5, marks=pytest.mark.long)],
)
def test_the_specimens_are_one_object(name: str, count: int, noise_mm: float) -> None:
    points = sampled(load_specimen(name).mesh, count, noise_mm, 3)
    assert taken(points).strays <= 0.002 * count
    assert taken(scattered(points, count // 50)).strays <= 0.02 * count


def test_density_that_changes_tenfold_and_more() -> None:
    rng = np.random.default_rng(3)
    points = sampled(impression(), 60_000, 0.05, 2)
    step = points[rng.random(60_000) < np.where(points[:, 2] > 0, 0.2, 0.02)]
    assert taken(step).strays == 0
    steep = points[rng.random(60_000) < np.where(points[:, 0] > 0, 0.5, 0.01)]
    assert taken(steep).strays <= 0.015 * len(steep)


def test_points_in_lines_and_in_clumps_are_one_object() -> None:
    rows = []
    for z in np.arange(-9, 9.1, 0.5):
        radius = np.sqrt(100 - z * z)
        angle = np.linspace(0, 2 * np.pi, int(300 * radius), endpoint=False)
        rows.append(np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(len(angle), z)], axis=1))
    assert taken(np.concatenate(rows)).strays < 0.04 * sum(map(len, rows))
    clumps = np.repeat(sampled(impression(), 3500, 0.1, 3), 10, axis=0)
    assert taken(clumps + 1e-4 * np.random.default_rng(0).normal(size=clumps.shape)).strays == 0


@pytest.mark.parametrize("count", [200_000, pytest.param(1_000_000, marks=pytest.mark.long)])
def test_very_many_points_and_the_wish_to_stop(count: int) -> None:
    rng = np.random.default_rng(0)
    points = rng.normal(size=(count, 3))
    points = 10 * points / np.linalg.norm(points, axis=1)[:, None] + 0.02 * rng.normal(size=points.shape)
    assert taken(points).strays == 0
    assert refused(np.concatenate([points[: count // 2], points[: count // 2] + np.array([25, 0, 0])])).code == "E-REC-05"
    calls = 0

    def impatient() -> None:
        nonlocal calls
        calls += 1
        if calls == 4:
            raise Cancelled

    with pytest.raises(Cancelled):
        accept(points, 0, impatient)


@settings(max_examples=60)
@given(
    count=st.integers(0, 400),
    seed=st.integers(0, 10_000),
    kind=st.sampled_from(["normal", "cauchy", "lattice", "walk", "few places", "two scales"]),
    scale=st.sampled_from([1e-9, 1e-3, 1.0, 1e6]),
    offset=st.sampled_from([0.0, 1e9]),
)
def test_any_cloud_is_taken_or_refused(count: int, seed: int, kind: str, scale: float, offset: float) -> None:
    rng = np.random.default_rng(seed)
    shape = (count, 3)
    points = {
        "normal": lambda: rng.normal(size=shape),
        "cauchy": lambda: rng.standard_cauchy(size=shape),
        "lattice": lambda: rng.integers(0, 5, size=shape).astype(float),
        "walk": lambda: np.cumsum(rng.normal(size=shape), axis=0),
        "few places": lambda: rng.normal(size=(60, 3))[rng.integers(0, 60, count)],
        "two scales": lambda: rng.normal(size=shape) * np.where(rng.random((count, 1)) < 0.5, 1, 1e-6),
    }[kind]()
    try:
        accepted = taken(scale * points + offset)
    except ReconstructionError:
        return
    assert len(accepted.points) >= 50
    assert np.isfinite(accepted.points).all()
    assert np.abs(accepted.points.min(axis=0) + accepted.points.max(axis=0)).max() <= 1e-6 * np.abs(accepted.points).max() + 1e-15 * offset


# ----------------------------------------------------------------------------------------------- no inside


def filled(kind: str, count: int) -> Array:
    rng = np.random.default_rng(5)
    if kind == "box":
        return rng.uniform(-10, 10, size=(count, 3))
    if kind == "rod":
        return rng.uniform(-10, 10, size=(count, 3)) * (1, 0.2, 0.2)
    if kind == "blob":
        return 5 * rng.normal(size=(count, 3))
    return ball(count) * rng.random((count, 1)) ** (1 / 3)


@pytest.mark.parametrize("kind", ["box", "rod", "blob", "ball"])
def test_points_that_fill_a_volume_are_refused(kind: str) -> None:
    with pytest.raises(ReconstructionError, match=r"deep inside|no common body|no inside") as caught:
        run(filled(kind, 3000))
    assert caught.value.code == "E-REC-02"


def sheet(kind: str) -> Array:
    rng = np.random.default_rng(6)
    u, v = rng.uniform(-10, 10, size=(2, 3000))
    if kind == "saddle":
        return np.stack([u, v, (u**2 - v**2) / 15], axis=1)
    if kind == "waves":
        return np.stack([u, v, 2 * np.sin(u) * np.cos(v)], axis=1)
    if kind == "spiral":
        angle = 1 + (u + 10) / 20 * 6 * np.pi
        return np.stack([angle * np.cos(angle) / 2, angle * np.sin(angle) / 2, v], axis=1)
    return np.stack([5 * np.cos(u), 5 * np.sin(u), u], axis=1) + 0.02 * rng.normal(size=(3000, 3))


@pytest.mark.parametrize("kind", ["saddle", "waves", "spiral", "helix"])
def test_a_sheet_is_refused(kind: str) -> None:
    with pytest.raises(ReconstructionError) as caught:
        run(sheet(kind), ReconstructionParameters(triangles=3000))
    assert caught.value.code in {"E-REC-02", "E-REC-03"}
    assert "\n" not in str(caught.value)


def test_a_half_shell_is_capped_and_marked_because_it_may_be_a_dome_that_stands_on_a_table() -> None:
    points = ball(4000) + 0.05 * np.random.default_rng(6).normal(size=(4000, 3))
    result = run(points[points[:, 2] > 0], ReconstructionParameters(triangles=3000))
    assert result.report.supported_area_fraction < 0.75
    assert any("not scanned" in warning for warning in result.report.warnings)


def test_a_surface_that_no_point_confirms_is_refused() -> None:
    mesh = unit_sphere(2)
    nowhere, everywhere = np.zeros(len(mesh.vertices), bool), np.ones(len(mesh.vertices), bool)
    check_fit(mesh, everywhere, 0.01, standing=False, open_holes=False)
    scattered = everywhere.copy()  # most vertices, and not one whole triangle
    while np.any(whole := scattered[mesh.triangles].all(axis=1)):
        scattered[np.argmax(np.bincount(mesh.triangles[whole].ravel()))] = False
    for supported, noise_mm, standing, code in (
        (nowhere, 0.01, False, "E-REC-02"), (scattered, 0.01, True, "E-REC-03"), (everywhere, 0.9, False, "E-REC-02"),
    ):  # fmt: skip
        with pytest.raises(ReconstructionError, match=code):
            check_fit(mesh, supported, noise_mm, standing=standing, open_holes=False)
    half = mesh.vertices[:, 2] > 0
    check_fit(mesh, half, 0.01, standing=True, open_holes=False)
    with pytest.raises(ReconstructionError, match="cover only 45 %"):
        check_fit(mesh, half, 0.01, standing=False, open_holes=False)


def test_a_dental_arch_without_its_base_is_a_body() -> None:
    arch = load_specimen("arch").mesh
    base = float(arch.vertices[:, 2].min()) + 0.3
    result = run(sampled(arch, 4000, 0.05, 3, keep=lambda p: p[:, 2] > base), ReconstructionParameters(triangles=3000))
    assert result.report.closed
    assert any("not scanned" in warning for warning in result.report.warnings)


# ----------------------------------------------------------------------------------------------- warnings


def told(points: Array) -> str:
    return " ".join(remark.words() for remark in taken(points).remarks)


def test_sizes_of_other_units() -> None:
    points = sampled(impression(), 1000, 0.05, 3)  # 22 mm
    assert told(points) == ""
    assert "--units m." in told(points / 1000)
    assert "metres" in told(points / 1000)
    assert "--units inch." in told(points / 25.4)
    assert "inches" in told(points / 25.4)
    assert "micrometres" in told(points * 1000)
    assert "--units mm" in told(points * 1000)
    assert told(points * 3 / 22) == "" or "--units" in told(points * 3 / 22)
    assert told(points * 10) == ""


def test_a_far_origin_is_remarked_on_and_costs_no_precision() -> None:
    points = sampled(impression(), 800, 0.05, 3)
    parameters = ReconstructionParameters(triangles=2000)
    here, there = run(points, parameters), run(points + np.array([1e6, -2e6, 0]), parameters)
    assert np.array_equal(here.mesh.triangles, there.mesh.triangles)
    assert np.abs(there.mesh.vertices - (1e6, -2e6, 0) - here.mesh.vertices).max() < 1e-5
    assert not any("origin" in warning for warning in here.report.warnings)
    assert any("from the origin" in warning for warning in there.report.warnings)
    assert "from the origin" in told(points + 2e5)
    assert "from the origin" in told(points / 1000 + 30)
    assert "from the origin" not in told(points + 1000)


@pytest.mark.parametrize("scale", [1000.0, 25.4])
def test_other_units_give_the_same_mesh(scale: float) -> None:
    points = sampled(impression(), 800, 0.05, 3)
    parameters = ReconstructionParameters(triangles=2000)
    here, there = run(points, parameters), run(points / scale * scale, parameters)
    assert np.array_equal(here.mesh.triangles, there.mesh.triangles)
    assert np.abs(there.mesh.vertices - here.mesh.vertices).max() < 1e-8


@pytest.mark.parametrize("scale", [1.0, 1000.0, 25.4])
def test_coordinates_rounded_to_single_precision_far_away_are_remarked_on(scale: float) -> None:
    points = sampled(impression(), 3500, 0.05, 3)
    far = points + np.array([1e6, 0, 0])
    rounded = (far / scale).astype(np.float32).astype(np.float64) * scale
    assert "single precision" in told(rounded)
    assert "single precision" not in told(far)
    assert "single precision" not in told(points.astype(np.float32).astype(np.float64))
    assert "single precision" not in told((points + 1000).astype(np.float32).astype(np.float64))
