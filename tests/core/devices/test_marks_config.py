"""The table [marks] of a rig file: round trips to the last digit, and what makes no marks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.devices.marks_config import MarksConfig, distances_mm, shipped_marks
from scanner_core.devices.rig import PRESETS, dump_rig, load_preset, parse_rig
from scanner_core.errors import UsageError
from scanner_core.virtual.rim_balls import true_centres_mm

MARKS = shipped_marks("bench")
BARE = replace(load_preset("bench"), calibration=None)
TABLE = """
[marks]
diameter_mm = 10
radius_mm = 90
azimuth_deg = [15, 120, 240]
height_mm = 4
"""


def read(table: str) -> MarksConfig:
    marks = parse_rig(dump_rig(BARE) + table, "test").marks
    assert marks is not None
    return marks


@pytest.mark.parametrize("preset", PRESETS)
def test_the_shipped_rigs_have_none_and_their_shipped_marks_fit_them(preset: str) -> None:
    rig = load_preset(preset)
    assert rig.marks is None
    assert "marks" not in dump_rig(rig)
    marks = shipped_marks(preset)
    assert parse_rig(dump_rig(replace(rig, marks=marks)), "test").marks == marks
    assert marks.distances_mm is not None
    np.testing.assert_allclose(distances_mm(true_centres_mm(marks)), np.array(marks.distances_mm), atol=1e-3)


@given(st.floats(2.0, 12.0), st.floats(85.0, 140.0), st.floats(0.0, 60.0), st.floats(31.0, 100.0), st.none() | st.floats(-1.0, 1.0))
def test_marks_survive_to_the_last_digit(diameter: float, radius: float, first: float, gap: float, off: float | None) -> None:
    marks = MarksConfig(diameter, radius, (first, first + gap, first + 2 * gap + 6.0), 0.4 * diameter)
    if off is not None:
        a, b, c = (marks.nominal_distances_mm() + off).tolist()
        marks = replace(marks, distances_mm=(a, b, c), distance_uncertainty_um=abs(off) + 0.5)
    again = parse_rig(dump_rig(replace(BARE, marks=marks)), "test")
    assert again.marks == marks
    assert dump_rig(again) == dump_rig(replace(BARE, marks=marks))


def test_what_is_left_out_is_not_known() -> None:
    assert read(TABLE) == replace(MARKS, distances_mm=None, distance_uncertainty_um=5.0)


@pytest.mark.parametrize(
    ("written", "instead", "said"),
    [
        ("[15, 120, 240]", "[0, 120, 240]", r"in \[marks\] the gaps of 'azimuth_deg' \(120, 120, 120 degrees\) must differ"),
        ("[15, 120, 240]", "[15, 240, 120]", "must rise from ball to ball by at least 30 degrees"),
        ("[15, 120, 240]", "[15, 120]", "must be 3 finite numbers"),
        ("radius_mm = 90", "radius_mm = 79", "'radius_mm' must be more than 80 mm, or the balls reach into the volume"),
        ("radius_mm = 90", "radius = 90", "'radius' is unknown; is 'radius_mm' meant"),
        ("height_mm = 4", "", r"'height_mm' of \[marks\] is missing"),
        ("height_mm = 4", "height_mm = 4\ndistances_mm = [150, 155.8, 166]", "of balls 1 and 2 is 150 mm, but by their places it is 142.8 mm"),
        ("diameter_mm = 10", "diameter_mm = '10'", "'diameter_mm' must be a number from 1 to 100"),
    ],
)
def test_what_makes_no_marks_is_refused_with_a_sentence(written: str, instead: str, said: str) -> None:
    with pytest.raises(UsageError, match=said) as refused:
        read(TABLE.replace(written, instead))
    assert refused.value.code == "E-RIG-01"
