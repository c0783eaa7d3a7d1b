from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.reconstruction.forecast import carried_after, carried_by
from scanner_core.reconstruction.parameters import ReconstructionParameters
from tests.core.reconstruction.shapes import impression, on_sphere, run, sampled


def test_forecast_of_fewer_triangles_is_what_they_give() -> None:
    points = sampled(impression(), 2500, 0.05, 2)
    report = run(points).report
    carried = carried_after(report.as_dict(), ReconstructionParameters().as_dict())
    assert carried is not None
    assert carried.measured
    assert carried.triangles == report.triangles
    fewer = run(points, ReconstructionParameters(detail=0.125)).report
    told = carried.error_um(fewer.triangles)
    assert told == pytest.approx(fewer.expected_error_rms_um, rel=0.25)
    assert told > 1.05 * report.expected_error_rms_um


def test_rule_of_thumb_says_more_of_more_points_and_nothing_without_their_noise() -> None:
    few, many = (on_sphere(10.0, count, 0.1, 1) for count in (1000, 100_000))
    noise = np.repeat((0.1**2 * np.eye(3))[None], 100_000, axis=0)
    assert carried_by(PointCloud(few)).error_um(5000) is None
    rough, fine = carried_by(PointCloud(few, noise[:1000])), carried_by(PointCloud(many, noise))
    assert fine.triangles == 104_000
    assert not fine.measured
    assert rough.smooth_um == pytest.approx(10 * (fine.smooth_um or 0))
    errors = [fine.error_um(triangles) or 0 for triangles in (2000, 20_000, 104_000, 400_000)]
    assert errors == sorted(errors, reverse=True)


def test_what_was_stopped_or_counted_tells_nothing_of_what_the_points_carry() -> None:
    report = {"triangles": 24_000, "expected_error_rms_um": 9.0, "facet_sag_um": 4.0}
    usual = ReconstructionParameters().as_dict()
    assert carried_after(report, usual) is not None
    assert carried_after(report | {"stopped_early": True}, usual) is None
    assert carried_after(report, ReconstructionParameters(triangles=8000).as_dict()) is None
    assert carried_after({}, usual) is None
