"""The predicted uncertainty of a scan's points is the size of their errors, whatever the rig's light is like."""

from __future__ import annotations

from typing import Any

import pytest

from tests.bench.optics.point_uncertainty import z_scores


@pytest.mark.parametrize(("preset", "changes"), [("bench", {"surface_um": 50.0}), pytest.param("workshop", {"speckle": 0.3}, marks=pytest.mark.long)])
def test_errors_have_the_predicted_size(preset: str, changes: dict[str, Any]) -> None:
    """A short scan: 900 points tell a standard deviation to 3 %; the full tables come from the bench."""
    z, _, noise = z_scores(preset, changes, "sphere", 900, 4, seed=11)
    assert 0.87 < z.std() < 1.13
    assert noise.pairs >= 850
