"""Several surfaces in time: one frame, one stable region, and what moved when."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from scanner_core.comparison import series as series_module
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.series import Series, measure_series
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.comparison.tracks import tracks_of
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.progress import Cancelled
from tests.core.comparison.compared import area_at, compared, named
from tests.core.comparison.shapes import egg
from tests.core.comparison.small_arch import noisy, small_arch

BULGE = np.array([-18.0, -14.0, 9.0])
"""On a molar of the arch."""


def bulged(height_mm: float, step_mm: float, seed: int) -> TriangleMesh:
    """The arch with a bump of 4 mm radius, turned and shifted by the seed."""
    mesh = noisy(small_arch(step_mm=step_mm), 15.0, seed)
    weight = np.exp(-0.5 * (np.linalg.norm(mesh.vertices - BULGE, axis=1) / 2.0) ** 2)
    turn = RigidTransform.from_vector(np.random.default_rng(seed).normal(0, 0.4, 3), [seed, -seed, 2 * seed])
    return TriangleMesh(turn.apply(mesh.vertices + height_mm * weight[:, None] * mesh.vertex_normals()), mesh.triangles)


@pytest.fixture(scope="module")
def surfaces() -> list[ComparedSurface]:
    made = [bulged(height, step, seed) for seed, (height, step) in enumerate([(0.0, 0.8), (0.5, 0.87), (1.0, 0.93)])]
    return [named(mesh, f"visit {number}", date=f"2026-0{number + 1}-01T10:00:00+00:00") for number, mesh in enumerate(made)]


@pytest.fixture(scope="module")
def series(surfaces: list[ComparedSurface]) -> Series:
    return measure_series(surfaces)


def test_what_grows_is_one_track(series: Series, surfaces: list[ComparedSurface]) -> None:
    track = series.tracks[0]
    first = RigidTransform.from_vector(np.random.default_rng(0).normal(0, 0.4, 3), [0, 0, 0])
    assert np.linalg.norm(track.centroid_mm - first.apply(BULGE[None])[0]) < 3.0
    assert track.listed == (True, True)
    assert track.p95_um[1] > 1.6 * track.p95_um[0] > 400
    assert len(series.tracks) == 1
    assert series.common_region is not None
    assert 0.5 < series.common_region.mean() < 1.0


def test_the_ways_close(series: Series) -> None:
    assert len(series.to_first) == 2
    assert len(series.to_previous) == 1
    assert series.closure_um[0] < 3 * series.closure_uncertainty_um[0] < 20.0
    assert series.reliable


def test_the_search_is_not_forgotten(series: Series) -> None:
    """Its result is handed on as a start, which is no point that anybody picked."""
    assert {one.alignment.frame for one in series.to_first} == {Frame.MASK}
    assert {one.alignment.method for one in series.to_first} <= {"principal axes", "point-pair features"}


def test_doubts_of_the_search_stay_and_a_speck_is_no_common_region(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of three balls no pose is sure; where the carried region is too small, each keeps its own and nobody is asked to paint."""
    doubt = Doubt("pose-ambiguous", "Another pose fits about as well.", serious=True)
    bodies = [named(noisy(egg(around=32, across=20), 5.0, seed), name) for seed, name in enumerate("abc")]

    def searched(first: ComparedSurface, after: ComparedSurface, *rest: Any, **more: Any) -> Alignment:
        return replace(compared(first, after).alignment, method="principal axes", doubts=(doubt,))

    monkeypatch.setattr(series_module, "align", searched)
    for least, frame, codes in ((20.0, Frame.MASK, []), (1e6, Frame.AUTO, ["series-no-common-region"])):
        monkeypatch.setattr(series_module, "LEAST_MM2", least)
        found = measure_series(bodies)
        assert [one.code for one in found.doubts if one.code == "series-no-common-region"] == codes
        for one in found.to_first:
            assert (one.alignment.frame, one.alignment.method) == (frame, "principal axes")
            assert [one.code for one in one.alignment.doubts].count("pose-ambiguous") == 1
        assert not found.reliable


def test_as_json_and_table(series: Series) -> None:
    values = json.loads(json.dumps(series.as_dict(), allow_nan=False))
    assert [one["name"] for one in values["surfaces"]] == ["visit 0", "visit 1", "visit 2"]
    rows = list(csv.DictReader(io.StringIO(series.csv())))
    assert [(row["surface"], row["listed"]) for row in rows] == [("visit 1", "1"), ("visit 2", "1")]
    assert float(rows[1]["p95_um"]) == pytest.approx(series.tracks[0].p95_um[1], rel=1e-3)


def test_no_text_of_a_series_becomes_a_formula(series: Series) -> None:
    evil = replace(series, names=("a", "=1+1", "+x"), dates=("", "@now", "2026"), tracks=(replace(series.tracks[0], words='-"cmd", a'),))
    rows = list(csv.DictReader(io.StringIO(evil.csv())))
    assert [(row["words"], row["surface"], row["date"]) for row in rows] == [('\'-"cmd", a', "'=1+1", "'@now"), ('\'-"cmd", a', "'+x", "2026")]


def test_a_series_can_be_stopped(surfaces: list[ComparedSurface]) -> None:
    with pytest.raises(Cancelled):
        measure_series(surfaces, cancelled=lambda: True)


def test_places_of_one_time_are_never_one_track() -> None:
    first, after = named(egg(), "a"), egg(60.2)
    left, right, beside = (-20.0, 0.0, 25.0), (20.0, 0.0, 25.0), (18.0, 0.0, 25.0)
    early = compared(first, named(after, "b"), areas=(area_at(after, left), area_at(after, beside, 2)))
    late = compared(first, named(after, "c"), areas=(area_at(after, right), area_at(after, (15.0, 0.0, 26.0), 2)))
    tracks = tracks_of([early, late])
    assert [(track.words, track.listed) for track in tracks] == [("place 1", (True, True)), ("place 2", (False, True)), ("place 1", (True, False))]
    assert tracks[1].p95_um[0] > 0  # what lies there although it is no area
    assert np.isnan(tracks[1].volume_mm3[0])
    assert tracks[0].cells(0)[0] == "1"


def test_a_surface_that_does_not_close_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison of neighbours is made to lie by a tenth of a millimetre."""
    honest = series_module.compare

    def lying(before: ComparedSurface, after: ComparedSurface, *rest: Any, **more: Any) -> Comparison:
        found = honest(before, after, *rest, **more)
        if before.name == "a":
            return found
        shifted = RigidTransform.from_vector([0, 0, 0], [0.1, 0, 0]) @ found.alignment.transform
        return replace(found, alignment=replace(found.alignment, transform=shifted))

    monkeypatch.setattr(series_module, "compare", lying)
    given = ComparisonParameters(Frame.GIVEN)
    found = measure_series([named(noisy(egg(around=48, across=28), 10.0, seed), name) for seed, name in enumerate("abc")], given)
    assert found.closure_um[0] == pytest.approx(100.0)
    assert [doubt.code for doubt in found.doubts] == ["series-does-not-close"]
    assert not found.reliable
