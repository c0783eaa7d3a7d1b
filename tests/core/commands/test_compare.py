"""``impronta compare``: the contract's JSON, every bad input by its sentence, and what is stored only when it is asked for."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore, Order
from scanner_core.commands import comparing
from scanner_core.comparison.keeping import kept_comparisons
from scanner_core.comparison.report import html, writer
from scanner_core.devices.rig import load_rig, rig_text
from scanner_core.errors import WorkerError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.jobs.registry import resolve, target_of
from scanner_core.mesh_io import write_mesh
from scanner_core.virtual.specimens.arch import TREATMENT, foot
from tests.core.comparison.shapes import cut, egg, scaled, turned_inside_out
from tests.core.comparison.small_arch import noisy, small_arch
from tests.core.geometry.solids import joined, moved
from tests.core.mesh_io.test_meshes import ascii_stl

POSE = RigidTransform.from_vector(np.radians([20.0, -35.0, 110.0]), [12.0, -7.0, 30.0])
Run = Callable[..., tuple[int, dict[str, Any], str]]


@pytest.fixture
def impronta(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    """The command with its job in this process; exit code, JSON, and what it said."""

    def here(job: str, request: object, **listeners: Any) -> object:
        return resolve(target_of(job))(request, **listeners)

    monkeypatch.setattr(comparing, "run_in_worker", here)
    monkeypatch.chdir(tmp_path)

    def run(*words: object) -> tuple[int, dict[str, Any], str]:
        code = main(["compare", "--json", *map(str, words)])
        said = capsys.readouterr()
        return code, json.loads(said.out) if said.out else {}, said.err

    return run


@pytest.fixture
def files(tmp_path: Path) -> Callable[..., list[Path]]:
    """Write meshes as before.stl and after.stl (or the suffix of the name)."""

    def write(before: TriangleMesh, after: TriangleMesh, suffix: str = ".stl") -> list[Path]:
        paths = [tmp_path / f"before{suffix}", tmp_path / f"after{suffix}"]
        for path, mesh in zip(paths, (before, after), strict=True):
            write_mesh(path, mesh, force=True)
        return paths

    return write


def placed(mesh: TriangleMesh) -> TriangleMesh:
    return TriangleMesh(POSE.apply(mesh.vertices), mesh.triangles)


def codes(values: dict[str, Any]) -> list[str]:
    return [doubt["code"] for doubt in values["doubts"]]


def test_moved_teeth_are_found_and_the_report_is_written(
    impronta: Run, files: Callable[..., list[Path]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # letters on paper take most of the time, and the page has tests of its own
    monkeypatch.setattr(writer, "write_pdf", lambda comparison, path, made, cancelled: path.write_text(f"%PDF-1.4 {made}"))
    monkeypatch.setattr(html, "_WIDTH", 90)
    before, after = noisy(small_arch(), 20.0, 1), noisy(small_arch(treated=True, step_mm=0.87), 20.0, 2)
    paths = files(before, placed(after))
    out = tmp_path / "out"
    code, values, said = impronta(*paths, "--out", out, "--jaw", "lower", "--seed", "3", "--dicom")
    assert code == 0
    transform = np.array(values["transform_after_to_before"])
    places = np.array([[-20.0, -20.0, 4.0], [20.0, -20.0, 4.0], [0.0, 18.0, 4.0]])  # of what did not move
    beside = POSE.apply(places) @ transform[:3, :3].T + transform[:3, 3] - places
    assert np.linalg.norm(beside, axis=1).max() < 0.05
    feet = np.array([foot(tooth) for tooth in TREATMENT])
    for area in values["areas"][: len(TREATMENT)]:
        assert np.linalg.norm(feet[:, :2] - area["centroid_mm"][:2], axis=1).min() < 4.0, area["words"]
    assert (values["parameters"]["jaw"], values["parameters"]["seed"], values["alignment"]["frame"]) == ("lower", 3, "auto")
    assert {path.name for path in out.iterdir()} >= {"report.pdf", "deviation.ply", "table.csv"}
    assert [Path(path).name for path in values["files"][-2:]] == ["report.dcm", "after.dcm"]
    assert (out / "report.pdf").read_bytes() in (out / "report.dcm").read_bytes()
    assert [values[which]["unit"] for which in ("before", "after")] == ["mm", "mm"]
    assert all(sentence in said for sentence in values["warnings"])
    held = {path: path.read_bytes() for path in out.iterdir()}
    code, values, said = impronta(*paths, "--out", out)
    assert (code, values) == (1, {})
    assert "exists already" in said
    assert {path: path.read_bytes() for path in out.iterdir()} == held


@pytest.mark.parametrize(
    ("case", "code", "words"),
    [
        ("open", "open", "It is open"),
        ("shells", "several-shells", "2 separate shells"),
        ("inch", "unit-guessed", "taken as inches"),
        ("identical", "identical-files", "identical files"),
    ],
)
def test_odd_input_is_compared_and_named(impronta: Run, files: Callable[..., list[Path]], case: str, code: str, words: str) -> None:
    body, after = (noisy(egg(around=48, across=28), 10.0, seed) for seed in (1, 2))
    mesh = {
        "open": cut(after, 4.0),
        "shells": joined(after, moved(egg(8.0), (50.0, 0.0, 0.0))),
        "inverted": turned_inside_out(after),
        "inch": scaled(after, 1 / 25.4),
        "identical": body,
    }[case]
    before_path, after_path = files(body, mesh)
    if case == "inch":
        after_path.write_bytes(ascii_stl(mesh))
    status, values, said = impronta(before_path, after_path, "--frame", "given")
    assert status == 0
    assert code in codes(values)
    assert words in said
    assert values["reliable"] is (case not in ("identical", "inch"))


def test_surfaces_that_face_inwards_are_named(impronta: Run, files: Callable[..., list[Path]]) -> None:
    body, after = (noisy(egg(around=48, across=28), 10.0, seed) for seed in (1, 2))
    status, _, said = impronta(*files(body, turned_inside_out(after)), "--frame", "given")
    assert status == 1
    assert "after.stl: Its normals point inwards" in said
    status, values, _ = impronta(*files(turned_inside_out(body), turned_inside_out(after)), "--frame", "given")
    assert (status, codes(values).count("normals-inverted"), values["reliable"]) == (0, 2, False)


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ("one triangle", "holds too few triangles for a comparison: 1, but"),
        ("other", "different objects, or opposite sides of one"),
        ("other", "the same object and that the normals of both point outwards"),
        ("mirrored", "is mirrored"),
        ("apart", "do not overlap"),
    ],
)
def test_what_does_not_belong_together_is_refused(impronta: Run, files: Callable[..., list[Path]], tmp_path: Path, case: str, words: str) -> None:
    before, after = noisy(small_arch(), 20.0, 1), noisy(small_arch(step_mm=0.87), 20.0, 2)
    options: list[str] = []
    if case == "one triangle":
        after = TriangleMesh(np.eye(3) * 50, np.array([[0, 1, 2]]))
    elif case == "other":
        after = noisy(egg(40.0, 60, 40), 20.0, 3)
    elif case == "mirrored":
        # the specimen is its own mirror image, but for what the treatment did
        before, after = noisy(small_arch(treated=True), 20.0, 1), noisy(small_arch(treated=True, step_mm=0.87), 20.0, 2)
        before, after = (cut_side(mesh) for mesh in (before, after))
        after = TriangleMesh(after.vertices * (-1, 1, 1), after.triangles[:, ::-1])
    else:
        after, options = moved(after, (200.0, 0.0, 0.0)), ["--frame", "given"]
    status, values, said = impronta(*files(before, after), *options, "--out", tmp_path / "out")
    assert (status, values) == (1, {})
    assert words in said
    assert "Traceback" not in said
    assert not (tmp_path / "out").exists()


def cut_side(mesh: TriangleMesh) -> TriangleMesh:
    """A quadrant and a half of the arch: it has no plane of symmetry."""
    inside = (mesh.vertices[mesh.triangles][:, :, 0] < 8.0).all(axis=1)
    used, index = np.unique(mesh.triangles[inside], return_inverse=True)
    return TriangleMesh(mesh.vertices[used], index.reshape(-1, 3))


def test_what_is_odd_is_said_before_anything_fails(impronta: Run, files: Callable[..., list[Path]], monkeypatch: pytest.MonkeyPatch) -> None:
    """A hundred times as large: whatever the comparison ends with, the sizes were named."""

    def fails(*_: object, **__: object) -> object:
        raise WorkerError("E-JOB-02", details="IndexError", reason="index 0 is out of bounds")

    monkeypatch.setattr(comparing, "run_in_worker", fails)
    body = egg(around=48, across=28)
    status, values, said = impronta(*files(body, scaled(body, 100.0)))
    assert (status, values) == (1, {})
    assert said.index("times as large as the earlier one") < said.index("The worker process failed")
    assert said.count("times as large as the earlier one") == 1


def test_a_series_checks_all_its_files_before_it_computes(impronta: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(comparing, "run_in_worker", lambda *_, **__: pytest.fail("computed"))
    old = tmp_path / "out" / "3-against-1" / "report.pdf"
    old.parent.mkdir(parents=True)
    old.write_bytes(b"old")
    for name in "abc":
        write_mesh(tmp_path / f"{name}.stl", egg(around=48, across=28))
    status, _, said = impronta("a.stl", "b.stl", "c.stl", "--out", tmp_path / "out")
    assert status == 1
    assert "exists already" in said
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == [old]


def test_a_series_is_a_job_of_the_worker(impronta: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def noting(job: str, request: object, **listeners: Any) -> object:
        asked.append(job)
        return resolve(target_of(job))(request, **listeners)

    monkeypatch.setattr(comparing, "run_in_worker", noting)
    for seed, name in enumerate("abc"):
        write_mesh(tmp_path / f"{name}.stl", noisy(egg(around=48, across=28), 10.0, seed))
    status, values, _ = impronta("a.stl", "b.stl", "c.stl", "--frame", "given")
    assert (status, asked, len(values["comparisons"])) == (0, ["compare-series"], 2)


def test_units_are_overruled_for_each(impronta: Run, tmp_path: Path) -> None:
    body = egg(30.0, around=48, across=28)
    (tmp_path / "a.stl").write_bytes(ascii_stl(body))
    (tmp_path / "b.stl").write_bytes(ascii_stl(scaled(noisy(body, 10.0, 2), 0.1)))  # 3 long: inches, by its size
    status, values, _ = impronta("a.stl", "b.stl", "--frame", "given", "--units-after", "cm")
    assert (status, values["after"]["unit"], values["after"]["unit_reason"]) == (0, "cm", "as it was asked for")
    assert "sizes-differ" not in codes(values)
    status, values, _ = impronta("a.stl", "b.stl", "--frame", "given", "--units-before", "mm")
    assert (values["after"]["unit"], "sizes-differ" in codes(values), values["reliable"]) == ("inch", True, False)
    status, values, _ = impronta("a.stl", "a.stl", "--frame", "given", "--units", "cm")
    assert [values[which]["unit"] for which in ("before", "after")] == ["cm", "cm"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--frame", "mask"], "--frame mask and --mask FILE go together"),
        (["--mask", "m.json"], "--frame mask and --mask FILE go together"),
        (["--dicom"], "--dicom needs a folder"),
        (["--keep"], "--keep needs a case as AFTER"),
        (["--null"], "add --rig and --material"),
        (["--null", "--rig", "bench", "--material", "wax"], "'bench' is a preset"),
        (["c.stl", "--null", "--rig", "r.toml", "--material", "wax"], "of two surfaces"),
        (["c.stl", "--keep"], "not kept in a case"),
    ],
)
def test_options_that_do_not_go_together(impronta: Run, options: list[str], words: str) -> None:
    status, values, said = impronta("a.stl", "b.stl", *options)
    assert (status, values) == (2, {})
    assert words in said


def test_a_marked_part_is_held(impronta: Run, files: Callable[..., list[Path]], tmp_path: Path) -> None:
    body, after = (noisy(egg(around=48, across=28), 10.0, seed) for seed in (1, 2))
    paths = files(body, moved(after, (0.3, 0.2, 0.0)))
    (tmp_path / "mask.json").write_text(json.dumps(list(range(600))))
    status, values, said = impronta(*paths, "--frame", "mask", "--mask", "mask.json")
    assert (status, values["alignment"]["frame"]) == (0, "mask"), said
    assert 0.2 < values["alignment"]["stable_area_fraction"] < 0.8


@pytest.fixture
def twice(tmp_path: Path) -> list[Path]:
    """Two cases of one body."""
    paths = [tmp_path / "first.impronta", tmp_path / "second.impronta"]
    for seed, path in enumerate(paths):
        with CaseStore.create(path) as store:
            store.put_order(Order("4711", "P-1", "left", "arch"))
            store.put_mesh(noisy(egg(around=48, across=28), 20.0, seed), {})
    return paths


def test_a_null_comparison_is_stored_with_the_rig_and_shown(impronta: Run, twice: list[Path], tmp_path: Path) -> None:
    rig = tmp_path / "rig.toml"
    rig.write_text(rig_text("bench"), encoding="utf-8")
    status, values, said = impronta("--frame", "given", "--null", "--rig", rig, "--material", "white plaster", *twice)
    assert status == 0, said
    (level,) = load_rig(rig).null_levels
    assert (level.material, level.level_um) == ("white plaster", pytest.approx(values["deviation"]["p95_um"], abs=1e-3))
    assert (values["null"]["id"], values["null_level_um"]) == (level.identity(), None)
    kept = rig.read_bytes()
    status, _, said = impronta("--frame", "given", "--null", "--rig", rig, "--material", "White Plaster", *twice)
    assert (status, rig.read_bytes()) == (2, kept)
    assert "replace it with --force" in said
    status, values, _ = impronta("--frame", "given", "--rig", rig, "--material", "white plaster", *twice)
    assert (status, values["null_level_um"]) == (0, pytest.approx(level.level_um, abs=1e-3))
    status, values, _ = impronta("--frame", "given", "--rig", rig, "--material", "wax", *twice)
    assert "null-other-material" in codes(values)
    status, _, said = impronta("--frame", "given", "--null", "--rig", rig, "--material", "wax", twice[0], twice[0])
    assert (status, rig.read_bytes()) == (1, kept)
    assert "identical files" in said


def test_a_case_is_changed_only_when_it_shall_keep_the_comparison(impronta: Run, twice: list[Path], capsys: pytest.CaptureFixture[str]) -> None:
    before = [path.read_bytes() for path in twice]
    assert impronta("--frame", "given", *twice)[0] == 0
    assert [path.read_bytes() for path in twice] == before
    status, values, _ = impronta("--frame", "given", "--keep", *twice)
    assert status == 0
    assert twice[0].read_bytes() == before[0]
    with CaseStore.open(twice[1], read_only=True) as store:
        (kept,) = kept_comparisons(store)
        assert (kept.id, kept.of_this_mesh, kept.values["deviation"]) == (values["kept"], True, values["deviation"])
    capsys.readouterr()
    assert main(["info", "--json", str(twice[1])]) == 0
    (shown,) = json.loads(capsys.readouterr().out)["comparisons"]
    assert (shown["id"], shown["before"], shown["frame"], shown["reliable"]) == (values["kept"], "first.impronta", "given", values["reliable"])
    assert (shown["rms_um"], shown["shown"], shown["of_this_mesh"]) == (values["deviation"]["rms_um"], True, True)
    assert main(["info", str(twice[1])]) == 0
    assert "second.impronta against first.impronta, frame given, rms " in capsys.readouterr().out


def test_the_worker_process_gives_the_same(files: Callable[..., list[Path]], capsys: pytest.CaptureFixture[str]) -> None:
    paths = files(*(noisy(egg(around=48, across=28), 10.0, seed) for seed in (1, 2)))
    assert main(["compare", "--frame", "given", *map(str, paths)]) == 0
    said = capsys.readouterr()
    assert said.out.startswith("after.stl (")
    assert "not aligned" in said.out
    assert "No serious doubt." in said.out
    assert "Areas of at least 3 mm2 that differ by more than 200 um: none." in said.out
