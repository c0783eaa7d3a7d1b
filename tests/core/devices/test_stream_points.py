"""The virtual rig seen through two network cameras: the same points as without them."""

from __future__ import annotations

import numpy as np

from tests.bench.cameras.stream_points import measure


def test_points_through_streams_are_those_of_the_rig() -> None:
    points = measure(6, quality=95, seed=3)
    assert len(points.direct) >= 3
    assert np.isfinite(points.streamed).all()
    assert points.apart_um < 150.0  # noise and speckle of two exposures; a pixel is 500 um
