"""A comparison told with another jaw and threshold: nothing is measured again."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.comparison.compare import with_terms
from scanner_core.comparison.parameters import ComparisonParameters, Frame, Jaw
from tests.core.comparison.made import made


def test_the_measurement_stays_and_the_threshold_has_its_area() -> None:
    comparison = made()
    told = with_terms(comparison, ComparisonParameters(frame=Frame.WHOLE, tolerance_um=890.0, jaw=Jaw.UPPER))
    assert told.alignment is comparison.alignment
    assert told.deviation.signed_um is comparison.deviation.signed_um
    assert told.parameters == replace(comparison.parameters, tolerance_um=890.0, jaw=Jaw.UPPER)  # the frame is what was held fixed
    above = told.deviation.statistics.area_above_mm2
    assert {key: above[key] for key in ("100", "250", "500")} == comparison.deviation.statistics.area_above_mm2
    # of the two patches, 900 and 880 um high, one is above: the area of its vertices, each a third of the triangles around it
    mesh, higher = comparison.after.mesh, set(comparison.areas[0].vertices.tolist())
    shares = [area * sum(corner in higher for corner in triangle) / 3 for area, triangle in zip(mesh.areas(), mesh.triangles.tolist(), strict=True)]
    assert above["890"] == pytest.approx(float(np.sum(shares)))


def test_words_of_areas_follow_the_jaw_only_where_there_is_an_arch() -> None:
    told = with_terms(made(), ComparisonParameters(jaw=Jaw.LOWER))
    assert all("lower" not in area.words for area in told.areas)
