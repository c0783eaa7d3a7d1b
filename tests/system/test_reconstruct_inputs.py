"""``impronta reconstruct`` with inputs that are damaged, lie, or hold no body: one sentence, exit 1, no file, no memory."""

from __future__ import annotations

import io
import json
import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from scanner_core.__main__ import main
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import read_mesh
from tests.core.mesh_io.test_hostile_files import damage, damaged
from tests.core.reconstruction.shapes import impression, sampled
from tests.system.impronta import Outcome, environment, impronta, one_sentence

MOST_MEMORY = 6 << 30
"""Address space of each process; the libraries alone map two."""

RNG = np.random.default_rng(4)
POINTS = sampled(impression(), 800, 0.05, 3)
BALL = RNG.normal(size=(500, 3))
BALL *= 10 / np.linalg.norm(BALL, axis=1)[:, None]


ONE_AFTER_ANOTHER = """
import contextlib, io, json, sys
from app.__main__ import main

def run(words):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = main(words)
        except SystemExit as ended:
            code = ended.code
    return code, out.getvalue(), err.getvalue()

if __name__ == "__main__":
    told = [run(words) for words in json.load(sys.stdin)]
    print(json.dumps(told))
"""


def limited(commands: list[list[str]], folder: Path) -> list[Outcome]:
    """Run ``impronta`` with these words where memory is short, all in one process: imports would take most of the time."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))

    program = folder / "one_after_another.py"
    program.write_text(ONE_AFTER_ANOTHER)
    done = subprocess.run(
        [sys.executable, str(program)],
        input=json.dumps(commands),
        capture_output=True,
        text=True,
        timeout=300,
        check=True,
        preexec_fn=limit,
        env=environment() | {"OPENBLAS_NUM_THREADS": "2"},
    )
    assert done.stderr == ""
    return [Outcome(*told) for told in json.loads(done.stdout)]


def npy(values: np.ndarray) -> bytes:
    file = io.BytesIO()
    np.save(file, values)
    return file.getvalue()


def xyz(points: np.ndarray) -> bytes:
    return "\n".join(" ".join(map(repr, row)) for row in points.tolist()).encode()


def ply(count: object, body: bytes, order: str = "binary_little_endian", kind: str = "float") -> bytes:
    properties = "".join(f"property {kind} {axis}\n" for axis in "xyz")
    return f"ply\nformat {order} 1.0\nelement vertex {count}\n{properties}end_header\n".encode() + body


BODY = POINTS.astype("<f4").tobytes()
NPY = npy(POINTS)
BROKEN = POINTS.copy()
BROKEN[5, 1] = np.nan
ENDLESS = POINTS.copy()
ENDLESS[5, 1] = np.inf
PLANE = RNG.uniform(-10, 10, size=(600, 3)) * (1, 1, 0)
BAD = {
    "empty.xyz": (b"", "E-FILE-04"),
    "empty.ply": (b"", "E-FILE-04"),
    "empty.npy": (b"", "E-FILE-04"),
    "blank.csv": (b"\n \n", "E-FILE-04"),
    "few.xyz": (xyz(POINTS[:49]), "E-REC-01"),
    "repeated.npy": (npy(np.repeat(POINTS[:40], 20, axis=0)), "E-REC-01"),
    "nan.xyz": (xyz(BROKEN), "E-FILE-04"),
    "nan.npy": (npy(BROKEN), "E-FILE-04"),
    "inf.npy": (npy(ENDLESS), "E-FILE-04"),
    "inf.ply": (ply(len(ENDLESS), ENDLESS.astype("<f4").tobytes()), "E-FILE-04"),
    "plane.npy": (npy(PLANE), "E-REC-02"),
    "far-noisy-plane.npy": (npy(PLANE @ np.linalg.qr(RNG.normal(size=(3, 3)))[0] + 0.1 * RNG.normal(size=PLANE.shape) + 1e6), "E-REC-02"),
    "line.xyz": (xyz(np.linspace(0, 1, 300)[:, None] * (10.0, 20.0, 5.0)), "E-REC-02"),
    "two.npy": (npy(np.concatenate([BALL, 0.5 * BALL[:200] + np.array([60.0, 0, 0])])), "E-REC-05"),
    "filled.npy": (npy(RNG.uniform(-10, 10, size=(3000, 3))), "E-REC-02"),
    "short.ply": (ply(len(POINTS) + 1, BODY), "E-FILE-04"),
    "cut.ply": (ply(len(POINTS), BODY)[:-500], "E-FILE-04"),
    "cut-in-header.ply": (ply(len(POINTS), BODY)[:60], "E-FILE-04"),
    "trillion.ply": (ply(10**12, BODY), "E-FILE-04"),
    "endless.ply": (ply(10**30, BODY), "E-FILE-04"),
    "negative.ply": (ply(-5, BODY), "E-FILE-04"),
    "words.ply": (ply("many", BODY), "E-FILE-04"),
    "wrong-type.ply": (ply(len(POINTS), BODY, kind="double"), "E-FILE-04"),
    "unknown-type.ply": (ply(len(POINTS), BODY, kind="quaternion"), "E-FILE-04"),
    "trillion-ascii.ply": (ply(10**12, xyz(POINTS), "ascii"), "E-FILE-04"),
    "cut.npy": (NPY[:-1000], "E-FILE-04"),
    "trillion.npy": (NPY.replace(b"(800, 3), }" + b" " * 10, b"(1000000000000, 3), }"), "E-FILE-04"),
    "objects.npy": (NPY.replace(b"'<f8'", b"'|O8'"), "E-FILE-04"),
    "negative.npy": (NPY.replace(b"(800, 3)", b"(-80, 3)"), "E-FILE-04"),
    "uneven.xyz": (xyz(POINTS) + b"\n1 2", "E-FILE-04"),
    "letters.csv": (xyz(POINTS) + b"\n1 2 three", "E-FILE-04"),
    "binary.txt": (bytes(range(256)) * 40, "E-FILE-04"),
    "points.las": (b"LASF", "E-FILE-04"),
}


@pytest.fixture(scope="module")
def ended(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Outcome, list[str]]]:
    """How ``reconstruct`` of each bad input ended, and the files in its folder afterwards."""
    base = tmp_path_factory.mktemp("bad")
    commands = []
    for index, (name, (content, _)) in enumerate(BAD.items()):
        folder = base / str(index)
        folder.mkdir()
        (folder / name).write_bytes(content)
        commands.append(["reconstruct", str(folder / name), "--out", str(folder / "a.ply"), "--json"])
    outcomes = limited(commands, base)
    return {
        name: (outcome, [path.name for path in (base / str(index)).iterdir()])
        for index, (name, outcome) in enumerate(zip(BAD, outcomes, strict=True))
    }


@pytest.mark.parametrize("name", list(BAD))
def test_bad_inputs_end_in_one_sentence(ended: dict[str, tuple[Outcome, list[str]]], name: str) -> None:
    outcome, left = ended[name]
    one_sentence(outcome, BAD[name][1])
    assert left == [name]  # neither a mesh nor a part of one


def test_a_bad_input_ends_the_program_with_exit_1(tmp_path: Path) -> None:
    (tmp_path / "cut.ply").write_bytes(BAD["cut.ply"][0])
    one_sentence(impronta("reconstruct", tmp_path / "cut.ply", "--out", tmp_path / "a.ply", "--json"), BAD["cut.ply"][1])
    assert [path.name for path in tmp_path.iterdir()] == ["cut.ply"]


def test_two_objects_are_counted_with_share_and_gap(ended: dict[str, tuple[Outcome, list[str]]]) -> None:
    told = ended["two.npy"][0].err
    assert "2 separate objects" in told
    assert "29 %" in told
    assert "45" in told  # mm from sphere to sphere


def test_wrong_usage(tmp_path: Path) -> None:
    (tmp_path / "a.xyz").write_bytes(xyz(POINTS))
    with pytest.raises(SystemExit) as ended:
        main(["reconstruct", str(tmp_path / "a.xyz"), "--out", str(tmp_path / "a.stl"), "--units", "cm"])
    assert ended.value.code == 2
    assert main(["reconstruct", str(tmp_path / "a.impronta"), "--out", str(tmp_path / "a.stl"), "--units", "m"]) == 2
    assert not (tmp_path / "a.stl").exists()


SAMPLES = {".ply": ply(60, POINTS[:60].astype("<f4").tobytes()), ".npy": npy(POINTS[:60]), ".xyz": xyz(POINTS[:60])}


@pytest.mark.parametrize("suffix", list(SAMPLES))
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(faults=st.lists(damage, min_size=1, max_size=3), count=st.sampled_from([49, 60]))
def test_damaged_files_never_end_in_a_traceback(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, faults: list[tuple[str, float, bytes]], count: int
) -> None:
    """In this process, and up to the worker, which a file with sixty points would keep busy for nothing."""
    monkeypatch.setattr("scanner_core.commands.reconstruct.run_reconstruction", _too_sparse)
    (tmp_path / f"a{suffix}").write_bytes(damaged(SAMPLES[suffix], faults))
    assert main(["reconstruct", str(tmp_path / f"a{suffix}"), "--out", str(tmp_path / "a.stl")]) == 1
    assert not (tmp_path / "a.stl").exists()


def _too_sparse(_console: object, cloud: PointCloud, parameters: object) -> None:
    from scanner_core.errors import ReconstructionError
    from scanner_core.reconstruction.acceptance import accept

    accept(cloud.points, 0, lambda: None)
    raise ReconstructionError("E-REC-02", reason="the test takes none")


MADE = ["--triangles", "1000", "--json"]


def made(capsys: pytest.CaptureFixture[str], folder: Path, content: bytes, source: str, out: str, *words: object) -> tuple[Outcome, dict[str, Any]]:
    (folder / source).write_bytes(content)
    code = main(["reconstruct", str(folder / source), "--out", str(folder / out), *MADE, *map(str, words)])
    outcome = Outcome(code, *capsys.readouterr())
    assert outcome.code == 0, outcome.err
    return outcome, json.loads(outcome.out)


@pytest.fixture(scope="module")
def true(tmp_path_factory: pytest.TempPathFactory) -> TriangleMesh:
    """The mesh of the points as they are."""
    folder = tmp_path_factory.mktemp("true")
    (folder / "a.npy").write_bytes(npy(POINTS))
    assert main(["reconstruct", str(folder / "a.npy"), "--out", str(folder / "a.ply"), *MADE]) == 0
    return read_mesh(folder / "a.ply")


def test_units_and_their_warning(tmp_path: Path, true: TriangleMesh, capsys: pytest.CaptureFixture[str]) -> None:
    _, values = made(capsys, tmp_path, npy(POINTS / 1000), "m.npy", "m.ply", "--units", "m")
    assert not any("--units" in warning for warning in values["warnings"])
    made(capsys, tmp_path, xyz(POINTS / 25.4), "inch.xyz", "inch.ply", "--units", "inch")
    for name in ("m.ply", "inch.ply"):
        mesh = read_mesh(tmp_path / name)
        assert np.array_equal(mesh.triangles, true.triangles)
        assert np.abs(mesh.vertices - true.vertices).max() < 1e-5
    outcome, values = made(capsys, tmp_path, npy(POINTS / 1000), "m.npy", "small.ply")
    assert any("--units m" in warning for warning in values["warnings"])
    assert "--units m" in outcome.err


def test_far_from_the_origin(tmp_path: Path, true: TriangleMesh, capsys: pytest.CaptureFixture[str]) -> None:
    outcome, values = made(capsys, tmp_path, npy(POINTS + 1e6), "far.npy", "far.ply")
    far = read_mesh(tmp_path / "far.ply")
    assert np.abs(far.vertices - 1e6 - true.vertices).max() < 1e-5
    assert any("from the origin" in warning for warning in values["warnings"])
    assert "from the origin" in outcome.err
    code = main(["reconstruct", str(tmp_path / "far.npy"), "--out", str(tmp_path / "far.stl")])
    one_sentence(Outcome(code, *capsys.readouterr()), "E-FILE-07")
    assert not (tmp_path / "far.stl").exists()
    outcome, values = made(capsys, tmp_path, npy(POINTS + 2e4), "middle.npy", "middle.stl")
    assert any("STL" in warning for warning in values["warnings"])
    assert check_mesh(read_mesh(tmp_path / "middle.stl")).closed
