"""``impronta coverage`` tells of a case's surface which places are not as wanted, and changes nothing."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore
from scanner_core.commands.coverage import coverage_summary
from scanner_core.coverage.place import CoveragePlace
from scanner_core.coverage.reason import Reason
from scanner_core.coverage.report import CoverageReport
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.case.test_processing import small_case
from tests.core.reconstruction.shapes import sphere


def case_with(path: Path, attributes: bool) -> Path:
    """The small case with a ball of 11 mm for its surface, measured above its middle."""
    path.write_bytes(small_case())
    ball = sphere(11.0, 3)
    vertices = ball.vertices + np.array([0.0, 0.0, 16.0])
    seen = vertices[:, 2] > 16.0
    told = {"standard_uncertainty_um": np.full(len(seen), 25.0, np.float32), "supported": seen.astype(np.uint8)}
    with CaseStore.open(path) as store:
        store.put_mesh(TriangleMesh(vertices, ball.triangles, dict(told) if attributes else {}), {})
    return path


def test_places_are_told_with_their_reasons(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = case_with(tmp_path / "a.impronta", attributes=True)
    before = path.read_bytes()
    assert main(["coverage", str(path), "--until-um", "30", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["case"] == str(path)
    assert told["wanted_um"] == 30.0
    assert 0.4 < told["within_fraction"] < 0.5 < told["reachable_within_fraction"] < 1.0
    assert {place["reason"] for place in told["places"]} <= {reason.value for reason in Reason}
    assert any(place["reason"] == "below" and place["tilt_deg"] > 75 for place in told["places"])
    areas = [place["area_mm2"] for place in told["places"]]
    assert areas == sorted(areas, reverse=True)
    assert path.read_bytes() == before


def test_a_person_reads_the_largest_places_and_how_many_more_there_are() -> None:
    places = tuple(CoveragePlace(Reason.BEAM_SHADOWED, (1.0, 2.0, 12.0), (0.0, 1.0, 0.0), 20.0 - k, None, 40.0) for k in range(14))
    first, second, *_, last = coverage_summary(CoverageReport(40.0, np.zeros(3, np.uint8), 0.8, 0.95, places))
    assert first == "80.0 % of the surface is within 40 um; of what can be reached as the object stands, 95.0 %."
    assert second == (
        "  20.0 mm2 on the side that faces the laser at 270 deg of the table, 12 mm up: "
        "the object itself stands before the laser at every angle; tilt the object by about 40 deg."
    )
    assert last == "  and 2 smaller places of together 15.0 mm2."


def test_what_has_no_answer_is_said_in_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.impronta"
    path.write_bytes(small_case())
    assert main(["coverage", str(path)]) == 1
    assert "holds no mesh yet" in capsys.readouterr().err
    assert main(["coverage", str(case_with(path, attributes=False))]) == 1
    assert "does not say how certain it is" in capsys.readouterr().err
