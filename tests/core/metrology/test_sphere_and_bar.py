"""Verdicts of the sphere and the ball bar on synthetic measurements with known errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.devices.rig import PRESETS, AcceptanceLimits, VolumeConfig, dump_rig, load_preset, parse_rig
from scanner_core.errors import AcquisitionError, UsageError
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.ball_bar import bar_positions, measure_bar
from scanner_core.metrology.decision import Verdict
from scanner_core.metrology.reference_sphere import Reference, SphereResult, evaluate_acquisition
from scanner_core.toml_text import without_table
from tests.core.metrology.artefacts import SPACING, R, acceptance_result, ball, sphere_result

RIG = replace(load_preset("bench"), acceptance=AcceptanceLimits(form_um=250, dispersion_um=120, size_um=20, spacing_um=20))


def test_a_good_sphere_passes_with_its_figures() -> None:
    result = sphere_result(RIG)
    assert result.verdict is Verdict.PASS
    assert result.mean_radius_mm == pytest.approx(R, abs=0.001)
    assert result.residual_rms_um == pytest.approx(25, rel=0.02)
    assert result.dispersion_um == pytest.approx(2 * 1.96 * 25, rel=0.03)
    assert result.coverage_deg > 110
    told = result.as_dict()
    acquisitions = told["acquisitions"]
    assert isinstance(acquisitions, list)
    assert {"points", "radius_mm", "residual_rms_um", "coverage_deg"} <= acquisitions[0].keys()


@pytest.mark.parametrize(("bias_um", "verdict"), [(5.0, Verdict.PASS), (10.5, Verdict.UNDECIDED), (20.0, Verdict.FAIL), (-20.0, Verdict.FAIL)])
def test_a_wrong_size_is_decided_with_its_uncertainty(bias_um: float, verdict: Verdict) -> None:
    assert sphere_result(RIG, R + 1e-3 * bias_um).verdict is verdict


def test_the_standard_error_of_the_mean_radius_is_right() -> None:
    results = [sphere_result(RIG, acquisitions=4)]
    u = results[0].mean_radius_uncertainty_mm
    # from the fit alone: sigma / sqrt(n) times the factor of a cap to 115 degrees, about 1.2, over 4 acquisitions
    assert 0.0002 < u < 0.0008


def test_the_correction_for_the_spot_is_taken_off_stated_and_uncertain() -> None:
    rng = np.random.default_rng(8)
    cloud = PointCloud(ball(rng, np.array([0.0, 0, 13]), R - 0.009, 0.02, 3000))
    plain = evaluate_acquisition(cloud, R)
    corrected = evaluate_acquisition(cloud, R, bias=lambda centre, radius_mm: np.full(len(cloud), -0.009))
    assert corrected.radius_mm - plain.radius_mm == pytest.approx(0.009, abs=1e-5)
    assert corrected.spot_correction_um == pytest.approx(9.0)
    sizes = [SphereResult((one,), Reference(R, 0.001), RIG.acceptance).characteristics()[0] for one in (plain, corrected)]
    grown = np.sqrt(sizes[1].expanded_uncertainty_um ** 2 - sizes[0].expanded_uncertainty_um ** 2)
    assert grown == pytest.approx(2 * 0.2 * 9.0, rel=0.05)


def test_a_cap_proves_nothing() -> None:
    result = sphere_result(RIG, lowest_deg=70.0, acquisitions=3)
    assert not result.covered
    assert result.verdict is Verdict.UNDECIDED


def test_a_single_acquisition_has_no_spread() -> None:
    result = sphere_result(RIG, acquisitions=1)
    assert result.radius_sd_mm is None
    assert result.as_dict()["radius_sd_mm"] is None
    assert np.isfinite([c.expanded_uncertainty_um for c in result.characteristics()]).all()


def test_a_good_bar_passes_in_seven_positions() -> None:
    result = acceptance_result(RIG)
    assert result.verdict is Verdict.PASS
    assert len(result.spheres) == 14
    assert max(abs(e) for e in result.spacing_errors_um()) < 5
    assert max(abs(e) for e in result.size_errors_um()) < 10
    for sphere in result.spheres:
        assert sphere.discarded == int(0.003 * (sphere.points + sphere.discarded))
        assert sphere.form_um >= sphere.dispersion_um
    assert [c.name for c in result.characteristics()] == ["form", "dispersion", "size", "spacing"]


def test_a_wrong_scale_fails_and_few_positions_prove_nothing() -> None:
    wrong = acceptance_result(RIG, SPACING * 1.001, positions=2)
    assert wrong.verdict is Verdict.FAIL
    np.testing.assert_allclose(wrong.spacing_errors_um(), 80, atol=5)
    assert acceptance_result(RIG, positions=2).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("preset", PRESETS)
def test_the_bar_fits_every_rig_in_all_positions(preset: str) -> None:
    volume = load_preset(preset).volume
    positions = bar_positions(volume, SPACING, R)
    assert len(positions) == 7
    for position in positions:
        centres = position.centres(SPACING)
        assert np.linalg.norm(centres[1] - centres[0]) == pytest.approx(SPACING)
        assert (np.hypot(centres[:, 0], centres[:, 1]) + R < volume.radius_mm).all()
        assert (centres[:, 2] > R).all()
        assert (centres[:, 2] + R < volume.height_mm).all()


def test_a_bar_that_does_not_fit_is_refused() -> None:
    with pytest.raises(UsageError, match="does not fit"):
        bar_positions(VolumeConfig(40, 60), SPACING, R)


def test_a_missing_sphere_and_a_wrong_bar_are_named() -> None:
    rng = np.random.default_rng(9)
    position = bar_positions(RIG.volume, SPACING, R)[0]
    first, second = position.centres(SPACING)
    alone = PointCloud(ball(rng, first, R, 0.02))
    longer = PointCloud(np.concatenate([ball(rng, first, R, 0.02), ball(rng, second + np.array([0, 9, 0]), R, 0.02)]))
    with pytest.raises(AcquisitionError) as missing:
        measure_bar(alone, position, 1, SPACING, R)
    with pytest.raises(AcquisitionError) as wrong:
        measure_bar(longer, position, 1, SPACING, R)
    assert (missing.value.code, wrong.value.code) == ("E-MET-06", "E-MET-07")


def test_limits_stand_in_the_rig_file_and_may_be_absent() -> None:
    assert parse_rig(dump_rig(RIG), "test").acceptance == RIG.acceptance
    bare = "\n".join(without_table(dump_rig(RIG), "acceptance"))
    assert "[acceptance]" not in bare
    assert parse_rig(bare, "test").acceptance == AcceptanceLimits()
    with pytest.raises(UsageError):
        parse_rig(dump_rig(RIG).replace("size_um = 20", "size_um = -1"), "test")


def test_a_reference_must_make_sense() -> None:
    with pytest.raises(UsageError):
        Reference(11.0, 12.0)
