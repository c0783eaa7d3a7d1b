"""What a running scan tells of its points at once."""

from __future__ import annotations

import numpy as np

from scanner_core.acquisition.handover import PointLog
from scanner_core.acquisition.live_points import LivePoints, standard_uncertainty_um


def test_a_log_gives_every_point_once_with_all_that_is_known_of_it() -> None:
    log, rng, parts, taken = PointLog(), np.random.default_rng(3), [], 0
    for view in range(40):
        covariances = np.tile(np.diag([1e-4, 4e-4, 4e-4]), (257, 1, 1))
        log.append(LivePoints.of_view(rng.normal(size=(257, 3)), 9.0 * view, view, rng.normal(size=257), covariances))
        if view % 7 == 0:
            parts.append(log.since(taken))
            taken = len(log)
    parts.append(log.since(taken))
    assert len(log) == sum(len(part) for part in parts) == 40 * 257
    whole = log.since(0)
    for name in ("points", "table_deg", "views", "epipolar_sigmas", "uncertainty_um"):
        assert (np.concatenate([getattr(part, name) for part in parts]) == getattr(whole, name)).all()
    assert (whole.table_deg == 9.0 * whole.views).all()
    assert np.allclose(whole.uncertainty_um, 1e3 * np.sqrt(3e-4))


def test_what_nobody_knows_is_no_number() -> None:
    points = LivePoints.of_view(np.zeros((3, 3)), 0.0, 1)
    assert np.isnan(points.epipolar_sigmas).all()
    assert np.isnan(points.uncertainty_um).all()


def test_the_uncertainty_is_that_of_one_coordinate_in_any_frame() -> None:
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    covariance = np.diag([1e-6, 4e-6, 4e-6])[None]
    assert np.allclose(standard_uncertainty_um(covariance), standard_uncertainty_um(turn @ covariance @ turn.T))
