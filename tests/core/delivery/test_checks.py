"""Every check can pass, and can say that something is wrong."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.acquisition.mark_visits import MarksReport
from scanner_core.case.processing import Processing
from scanner_core.case.records import MountPose, ScanRecord
from scanner_core.case.removed_points import RemovedPoints
from scanner_core.case.store import CaseStore
from scanner_core.delivery import checks
from scanner_core.delivery.base import coverage, find_base, without_base
from scanner_core.delivery.check import Check, CheckVerdict, Readiness, readiness
from scanner_core.delivery.check_sentences import NAMES, SENTENCES
from scanner_core.delivery.facts import CaseFacts, read_facts
from scanner_core.delivery.other_ear import check_side, judged_sides
from scanner_core.delivery.shape_checks import check_size, shape_checks
from scanner_core.delivery.side import SideFit, SideMatch
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration_age import AgeState, CalibrationAge
from tests.core.delivery.cases import ORDER, VALID, drop, facts
from tests.core.geometry.solids import box, joined, sphere

PASS, WARN, FAIL, OPEN = CheckVerdict.PASS, CheckVerdict.WARN, CheckVerdict.FAIL, CheckVerdict.OPEN
SCAN = ScanRecord(1, "scan", "", {}, "", None, None, None)
EXPIRED = replace(VALID, age=CalibrationAge(40.0, -10.0, AgeState.EXPIRED))


def bare(share: float) -> TriangleMesh:
    """The drop with holes: every so many of its vertices rest on no point."""
    mesh = drop()
    flags = mesh.vertex_attributes["supported"].copy()
    flags[100 : 100 + int(share * 700)] = 0
    return TriangleMesh(mesh.vertices, mesh.triangles, {"supported": flags})


def mount(residual_um: float, number: int = 1, joined_up: bool = True) -> MountPose:
    return MountPose(number, "2026-11-27", RigidTransform.identity() if joined_up else None, {"residual_um": residual_um})


CASES: list[tuple[str, CaseFacts, CheckVerdict]] = [
    ("coverage", facts(), PASS),
    ("coverage", facts(bare(0.1)), WARN),
    ("coverage", facts(bare(0.5)), FAIL),
    ("coverage", facts(sphere(9.0)), OPEN),
    ("noise", facts(), PASS),
    ("noise", facts(report={"expected_error_rms_um": 70.0}), WARN),
    ("noise", facts(report={"expected_error_rms_um": 120.0}), FAIL),
    ("noise", facts(report={"expected_error_rms_um": float("nan")}), FAIL),
    ("noise", facts(report={}), OPEN),
    ("noise", facts(report={"expected_error_rms_um": 70.0, "stopped_early": True}), WARN),
    ("closure", facts(), PASS),
    ("closure", facts(closure_um=80.0), WARN),
    ("closure", facts(closure_um=300.0), FAIL),
    ("closure", facts(closure_um=None), PASS),
    ("closure", facts(closure_um=None, views_um=80.0), WARN),
    ("closure", facts(closure_um=None, views_um=None), OPEN),
    ("calibration", facts(), PASS),
    ("calibration", facts(calibration=replace(VALID, scale_verified=False)), WARN),
    ("calibration", facts(calibration=replace(VALID, age=CalibrationAge(28.0, 2.0, AgeState.EXPIRING))), WARN),
    ("calibration", facts(calibration=replace(VALID, held_out_um=70.0)), WARN),
    ("calibration", facts(calibration=replace(VALID, age=None)), WARN),
    ("calibration", facts(calibration=EXPIRED), FAIL),
    ("calibration", facts(calibration=replace(VALID, held_out_um=170.0)), FAIL),
    ("calibration", facts(calibration=None, scans=()), OPEN),
    ("calibration", facts(calibration=None, scans=(SCAN,)), WARN),
    ("mounts", facts(), OPEN),
    ("mounts", facts(mounts=(mount(12.0),), mount_count=2), PASS),
    ("mounts", facts(mounts=(mount(70.0),), mount_count=2), WARN),
    ("mounts", facts(mounts=(mount(12.0, joined_up=False),)), WARN),
    ("current", facts(), PASS),
    ("current", facts(current=False), WARN),
    ("current", facts(current=None), OPEN),
    ("places", facts(), PASS),
    ("places", facts(accepted=2), WARN),
    ("marks", facts(), OPEN),
    ("marks", facts(marks=MarksReport(4, 8.0, "calibrated", 3.0)), PASS),
    ("marks", facts(marks=MarksReport(4, 80.0, "calibrated", 3.0)), WARN),
    ("edits", facts(), PASS),
    ("edits", facts(removed=50), PASS),
    ("edits", facts(removed=900), WARN),
    ("edits", facts(removed=900, points=0), PASS),
]


@pytest.mark.parametrize(("name", "case", "verdict"), CASES)
def test_a_check_says_what_the_case_tells(name: str, case: CaseFacts, verdict: CheckVerdict) -> None:
    found: Check = getattr(checks, f"check_{name}")(case)
    assert (found.id, found.verdict) == (name, verdict)
    assert "{" not in found.sentence
    assert found.sentence.endswith((".", "?"))
    assert found.as_dict()["verdict"] == verdict.value


def test_what_nobody_knows_is_no_pass() -> None:
    unknown = facts(sphere(9.0), report={}, closure_um=None, views_um=None, calibration=None, current=None)
    assert {check.verdict for check in checks.measured_checks(unknown)} == {OPEN}


SHAPES = [
    ("closed", TriangleMesh(box().vertices, box().triangles[1:])),
    ("manifold", TriangleMesh(box().vertices, box().triangles[[*range(12), 0]])),
    ("shells", joined(box(), box(at=(3.0, 0.0, 0.0)))),
    ("outward", TriangleMesh(box().vertices, box().triangles[:, ::-1].copy())),
    ("intersections", joined(box(), box(at=(0.5, 0.4, 0.3)))),
]


def test_a_sound_shape_passes() -> None:
    assert {check.verdict for check in shape_checks(sphere(9.0))} == {PASS}


@pytest.mark.parametrize(("name", "mesh"), SHAPES)
def test_an_unsound_shape_fails(name: str, mesh: TriangleMesh) -> None:
    found = {check.id: check for check in shape_checks(mesh)}
    assert found[name].verdict is FAIL
    assert "{" not in found[name].sentence


@pytest.mark.parametrize(
    ("kind", "radius_mm", "verdict"),
    [
        ("ear", 12.0, PASS),
        ("ear", 6.0, WARN),
        ("ear", 40.0, WARN),
        ("ear", 120.0, FAIL),
        ("ear", 1.2, FAIL),
        ("arch", 30.0, PASS),
        ("other", 3.0, OPEN),
    ],
)
def test_a_size_is_judged_by_the_type(kind: str, radius_mm: float, verdict: CheckVerdict) -> None:
    found = check_size(sphere(radius_mm), kind)
    assert found.verdict is verdict
    assert "{" not in found.sentence


@pytest.mark.parametrize(
    ("sides", "fit", "verdict"),
    [
        (("left", "right"), SideFit.MIRRORED, PASS),
        (("left", "right"), SideFit.DIRECT, FAIL),
        (("left", "right"), SideFit.UNDECIDED, WARN),
        (("left", "left"), SideFit.MIRRORED, FAIL),
        (("left", "left"), SideFit.DIRECT, OPEN),
    ],
)
def test_two_labels_must_agree_with_two_shapes(sides: tuple[str, str], fit: SideFit, verdict: CheckVerdict) -> None:
    found = judged_sides(*sides, SideMatch(fit, 200.0, 400.0))
    assert found.verdict is verdict
    assert "{" not in found.sentence


def test_without_the_other_ear_the_side_is_not_checked() -> None:
    assert check_side(ORDER, drop(), None).sentence == "Not checked: the other ear of this order is not there yet."
    assert check_side(replace(ORDER, side=""), drop(), None).verdict is WARN
    assert check_side(replace(ORDER, type="arch-after", side="upper"), drop(), None).verdict is OPEN
    assert check_side(replace(ORDER, type="arch", side=""), drop(), None).verdict is WARN


@given(st.lists(st.sampled_from(CheckVerdict)))
def test_a_remark_never_turns_green(verdicts: list[CheckVerdict]) -> None:
    found = readiness([Check("current", verdict, "current.pass") for verdict in verdicts])
    assert (found is Readiness.NOT_READY) == (FAIL in verdicts)
    assert (found is Readiness.READY) == ({FAIL, WARN}.isdisjoint(verdicts))


def test_every_sentence_belongs_to_a_check() -> None:
    assert {code.split(".")[0] for code in SENTENCES} == set(NAMES)


def test_the_base_is_no_hole() -> None:
    mesh = drop()
    base = find_base(mesh)
    assert base is not None
    assert base.outward @ [0, 0, -1] > 0.99
    share = coverage(mesh)
    assert share is not None
    assert share > 0.97
    assert find_base(sphere(9.0)) is None
    opened = without_base(mesh)
    found = check_mesh(opened)
    assert found.boundary_edges > 0
    assert found.components == 1
    assert opened.area() == pytest.approx(mesh.area() - mesh.areas()[base.triangles].sum())
    assert len(opened.vertex_attributes["supported"]) == len(opened.vertices)


def test_a_surface_of_other_points_is_not_current_though_as_many_were_taken_out(tmp_path: Path) -> None:
    one, other = (RemovedPoints.of(np.array([number])) for number in (7, 8))
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.put_order(ORDER)
        store.edit("processing", Processing(removed=one).as_dict(), "Take out")
        store.put_mesh(sphere(9.0), {"scans": [], "processing": {"removed": one.told()}})
        assert read_facts(store).current
        store.edit("processing", Processing(removed=other).as_dict(), "Take out others")
        assert read_facts(store).current is False
