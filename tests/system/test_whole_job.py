"""The main job from two cameras' frames to an STL, headless, as the contract promises it."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.store import CaseStore
from scanner_core.geometry.checks import check_mesh
from scanner_core.mesh_io import read_mesh, read_points
from tests.system.impronta import Outcome, balanced, command, environment, impronta, one_sentence

DEMO_KEYS = {
    "views", "planned", "measured", "rejected", "skipped", "points", "rate_hz", "seconds", "realtime_factor", "case", "finish_reason",
    "calibration", "registration", "reconstruct", "error_vs_truth_um",
}  # fmt: skip
RECONSTRUCT_KEYS = {
    "points", "outliers_rejected", "noise_sigma_um", "vertices", "triangles", "closed", "genus", "self_intersections", "supported_area_fraction",
    "residual_rms_um", "expected_error_rms_um", "phases", "seconds", "peak_memory_mb", "warnings",
}  # fmt: skip


@pytest.fixture(scope="module")
def demo(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Outcome]:
    folder = tmp_path_factory.mktemp("demo") / "sphere"
    return folder, impronta("demo", "--specimen", "sphere", "--points", 4000, "--out", folder, "--seed", 7, "--json")


def test_the_sphere_from_frames_to_a_mesh(demo: tuple[Path, Outcome]) -> None:
    folder, outcome = demo
    assert outcome.code == 0, outcome.err
    values = outcome.json()
    assert set(values) >= DEMO_KEYS
    balanced(values)
    assert values["finish_reason"] == "completed"
    assert values["measured"] == 4000
    report, error = values["reconstruct"], values["error_vs_truth_um"]
    assert isinstance(report, dict)
    assert isinstance(error, dict)
    assert set(report) >= RECONSTRUCT_KEYS
    assert [phase["name"] for phase in report["phases"]] == ["inflate", "refine", "smooth"]
    assert report["closed"]
    assert report["self_intersections"] == 0
    assert report["supported_area_fraction"] >= 0.85
    assert error["mesh_rms"] < 30
    assert sorted(path.name for path in folder.iterdir()) == ["case.impronta", "mesh.ply", "mesh.stl", "report.pdf"]
    assert (folder / "report.pdf").read_bytes().startswith(b"%PDF")


def test_the_written_meshes_are_what_the_contract_says(demo: tuple[Path, Outcome]) -> None:
    folder, _ = demo
    stl = (folder / "mesh.stl").read_bytes()
    assert b"UNITS=mm" in stl[:80]
    mesh = read_mesh(folder / "mesh.stl")
    checks = check_mesh(mesh)
    assert checks.closed
    assert checks.manifold
    assert checks.outward
    # A plane cap at 42 degrees below the equator cuts 7.6 % off the ball.
    assert 0.90 < mesh.volume() / (4 / 3 * np.pi * 11.133**3) < 0.97
    ply = read_mesh(folder / "mesh.ply")
    assert {"standard_uncertainty_um", "supported"} <= set(ply.vertex_attributes)


def test_the_case_gives_the_same_again(demo: tuple[Path, Outcome], tmp_path: Path) -> None:
    folder, _ = demo
    case = folder / "case.impronta"
    told = impronta("info", case, "--json").json()
    assert told["kind"] == "case"
    again = impronta("reconstruct", case, "--out", tmp_path / "again.stl", "--seed", 7, "--json")
    assert again.code == 0, again.err
    assert (tmp_path / "again.stl").read_bytes() == (folder / "mesh.stl").read_bytes()
    assert impronta("export", case, "--out", tmp_path / "points.xyz").code == 0
    assert len(read_points(tmp_path / "points.xyz")) == 4000
    assert impronta("export", case, "--out", tmp_path / "mesh.obj").code == 0
    one_sentence(impronta("export", case, "--out", tmp_path / "mesh.obj"), "E-DISK-03")
    assert impronta("export", case, "--out", tmp_path / "mesh.obj", "--force").code == 0
    assert impronta("info", tmp_path / "mesh.obj", "--json").json()["closed"] is True


def test_a_scan_that_is_interrupted_keeps_what_it_has(tmp_path: Path) -> None:
    case = tmp_path / "a.impronta"
    words = command("scan", "--rig", "bench", "--specimen", "sphere", "--speed", 1, "--out", case, "--json")
    running = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment())
    end_s = time.monotonic() + 60
    while not Path(f"{case}-wal").exists() and time.monotonic() < end_s:
        time.sleep(0.1)
    time.sleep(3.0)
    os.kill(running.pid, signal.SIGINT)
    out, err = running.communicate(timeout=60)
    outcome = Outcome(running.returncode, out, err)
    assert outcome.code == 130, outcome
    values = outcome.json()
    balanced(values)
    assert values["finish_reason"] == "cancelled"
    assert "Traceback" not in err
    with CaseStore.open(case) as store:
        assert sum(sum(store.verdict_counts(scan.id).values()) for scan in store.scans()) > 0


def test_a_second_program_on_the_case_is_refused(demo: tuple[Path, Outcome], tmp_path: Path) -> None:
    case = demo[0] / "case.impronta"
    with CaseStore.open(case):
        one_sentence(impronta("info", case), "E-CASE-02")
        one_sentence(impronta("reconstruct", case, "--out", tmp_path / "b.stl"), "E-CASE-02")
    assert not (tmp_path / "b.stl").exists()


def test_wrong_inputs_get_one_sentence(tmp_path: Path) -> None:
    text = tmp_path / "letter.stl"
    text.write_text("Dear colleague,\n")
    one_sentence(impronta("demo", "--specimen", text, cwd=tmp_path), "E-FILE-02")
    empty = tmp_path / "empty.obj"
    empty.write_text("v 0 0 0\n")
    one_sentence(impronta("demo", "--specimen", empty, cwd=tmp_path), "E-FILE-03")
    one_sentence(impronta("demo", "--specimen", tmp_path / "none.stl", cwd=tmp_path), "E-FILE-01")
    large = tmp_path / "large.obj"
    large.write_text("v 0 0 0\nv 900 0 0\nv 0 900 0\nv 0 0 900\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    refused = impronta("demo", "--specimen", large, cwd=tmp_path)
    one_sentence(refused, "E-RIG-02")
    assert "900" in refused.err
    one_sentence(impronta("reconstruct", text, "--out", tmp_path / "a.ply"), "E-FILE")
    one_sentence(impronta("info", tmp_path / "none.impronta"), "E-CASE-04")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["empty.obj", "large.obj", "letter.stl"]


def test_wrong_usage_is_exit_2(tmp_path: Path) -> None:
    assert impronta("demo", "--points", 0).code == 2
    assert impronta("paint").code == 2
    assert impronta("demo", "--specimen", "ear", "--treated", cwd=tmp_path).code == 2
    assert impronta("demo", "--preset", "moon", cwd=tmp_path).code == 2


def test_the_doctor_on_the_virtual_rig() -> None:
    outcome = impronta("doctor", "--json")
    values = outcome.json()
    assert outcome.code == 0, values
    names = " ".join(check["name"] for check in values["checks"])  # type: ignore[attr-defined]
    for word in ("handshake", "move", "laser"):
        assert word in names
    assert values["controller"]["transcript"]  # type: ignore[index]
