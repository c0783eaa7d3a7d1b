"""The result of a comparison in lines for a person."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.commands import comparing
from scanner_core.commands.comparing import comparison_summary, series_summary
from scanner_core.comparison.arch_frame import ArchFrame
from scanner_core.comparison.parameters import ComparisonParameters, Jaw
from scanner_core.comparison.series import Series
from scanner_core.comparison.tracks import tracks_of
from tests.core.comparison.made import made

ARCH = ArchFrame(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0]), np.zeros((3, 3)))
ADVICE = "Say --jaw upper or lower for right, left, cheek and tongue."


def test_uncertainties_are_expanded() -> None:
    """Standard ones of the made comparison: 4.2 um of the alignment, 11 um and 0.12 degrees of a motion."""
    words = "\n".join(comparison_summary(made()))
    assert "uncertainty +- 8.4 um" in words
    assert "moved 0.900 mm +- 22 um, turned 2.50 deg +- 0.24 deg" in words
    assert words.count("(k = 2)") == 1


def test_the_jaw_is_asked_for_where_it_would_tell_more(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ADVICE not in comparison_summary(made())  # a plate
    monkeypatch.setattr(comparing, "arch_frame", lambda mesh, supported: ARCH)
    monkeypatch.setattr(comparing, "shift_sentences", lambda comparison: ())
    assert ADVICE in comparison_summary(made())
    assert ADVICE not in comparison_summary(made(areas=0))
    assert ADVICE not in comparison_summary(replace(made(), parameters=ComparisonParameters(jaw=Jaw.LOWER)))


def test_every_value_of_a_series_names_its_file() -> None:
    times = (made(areas=1), made(areas=2))
    tracks = tracks_of(times)
    lost = replace(tracks[1], p95_um=(float("nan"), 880.0))
    series = Series(("a.stl", "b.stl", "c.stl"), ("", "", ""), times, (), None, (), (), (tracks[0], lost))
    lines = series_summary(series)
    assert [line.partition("um, ")[2] for line in lines[1:3]] == [
        "95 % below 850.0 um, 1 area of difference.",
        "95 % below 850.0 um, 2 areas of difference.",
    ]
    assert lines[3].endswith("mm; 95 % below: b.stl 900 um, c.stl 900 um")
    assert lines[4].endswith("mm; 95 % below: b.stl without counterpart, c.stl 880 um")


def test_a_series_table_has_expanded_uncertainties() -> None:
    """The made motion has 11 um."""
    track = tracks_of((made(areas=1),))[0]
    assert track.cells(0)[-2:] == ["22", "2.5"]
