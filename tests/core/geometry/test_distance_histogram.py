from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.geometry.distance_histogram import CLASSES, LEAST_UM, MOST_UM, distance_histogram


@given(st.lists(st.floats(-100, 100), min_size=1, max_size=50))
def test_every_distance_counts_once_in_the_class_that_holds_it(distances_mm: list[float]) -> None:
    told = distance_histogram(np.array(distances_mm))
    assert sum(told.counts) == len(distances_mm)
    edges = np.geomspace(LEAST_UM, MOST_UM, CLASSES + 1)
    lengths = np.clip(np.abs(distances_mm) * 1e3, LEAST_UM, MOST_UM)
    for low, high, count in zip(edges[:-1], edges[1:], told.counts, strict=True):
        least = np.count_nonzero((lengths > low * (1 + 1e-9)) & (lengths < high * (1 - 1e-9)))
        most = np.count_nonzero((lengths >= low * (1 - 1e-9)) & (lengths <= high * (1 + 1e-9)))
        assert least <= count <= most


def test_percentiles_are_those_of_the_distances() -> None:
    told = distance_histogram(np.linspace(-0.1, 0.1, 2001))
    assert told.median_um == pytest.approx(50, abs=0.2)
    assert told.p95_um == pytest.approx(95, abs=0.2)
    assert told.as_dict()["counts"] == list(told.counts)
