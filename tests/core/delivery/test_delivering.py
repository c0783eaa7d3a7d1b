"""What is delivered is whole, certified, and never half there."""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import replace
from datetime import date
from importlib import resources
from pathlib import Path

import fastjsonschema
import numpy as np
import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore
from scanner_core.delivery import delivering
from scanner_core.delivery.certificate import DeliveredFile
from scanner_core.delivery.certificate_page import certificate_page, page_style, save_page
from scanner_core.delivery.check import CheckVerdict
from scanner_core.delivery.delivering import all_or_none, deliver
from scanner_core.delivery.file_name import free_stem
from scanner_core.delivery.profile import BUILT_IN, Pose, Profile
from scanner_core.errors import DeliveryError, StorageError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.progress import Cancelled
from scanner_core.mesh_io import read_mesh, read_points
from scanner_core.mesh_io.stated_unit import stated_unit
from tests.core.delivery.cases import ORDER, drop, examination, write_case

MADE = "2026-11-27T16:00:00+00:00"


@pytest.fixture(autouse=True)
def quick_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """The page takes a second; one test draws it."""
    monkeypatch.setattr(delivering, "write_page", lambda _, path: path.write_bytes(b"%PDF-"))


def valid(path: Path) -> dict[str, object]:
    """The JSON of a certificate, as its schema wants it."""
    schema = (resources.files("resources") / "schemas" / "delivery-1.schema.json").read_text(encoding="utf-8")
    told: dict[str, object] = json.loads(path.read_text(encoding="utf-8"))
    fastjsonschema.compile(json.loads(schema))(told)
    return told


def test_the_certificate_says_what_the_file_is(tmp_path: Path) -> None:
    delivery = deliver(examination(), BUILT_IN[0], tmp_path / "new", "a", made=MADE)
    assert sorted(os.listdir(tmp_path / "new")) == ["a.json", "a.pdf", "a.stl"]
    told = valid(tmp_path / "new" / "a.json")
    digest = hashlib.sha256((tmp_path / "new" / "a.stl").read_bytes()).hexdigest()
    assert delivery.sha256 == digest
    assert [(file["name"], file["role"]) for file in told["files"]] == [("a.stl", "mesh"), ("a.pdf", "certificate")]
    assert told["files"][0]["sha256"] == digest
    assert (told["verdict"], told["delivered_anyway"], told["remark"]) == ("ready", False, "")
    assert "SECRET" not in (tmp_path / "new" / "a.json").read_text(encoding="utf-8")
    mesh = read_mesh(tmp_path / "new" / "a.stl")
    laid = np.array(told["surface"]["case_to_file"])
    vertices = drop().vertices @ laid[:3, :3].T + laid[:3, 3]
    assert mesh.vertices.max(axis=0) == pytest.approx(vertices.max(axis=0), abs=1e-5)
    assert mesh.vertices[:, 2].min() == pytest.approx(0.0, abs=1e-6)


def test_the_page_tells_verdict_side_pose_and_hash(tmp_path: Path) -> None:
    found = examination(CheckVerdict.WARN)
    mesh, certificate = delivering._prepared(found, BUILT_IN[0], MADE, anyway=False)
    (tmp_path / "a.stl").write_bytes(b"stl")
    certificate = delivering._with(certificate, DeliveredFile.of(tmp_path / "a.stl", "a.stl", "mesh"))
    with page_style():
        drawn = certificate_page(certificate)
        save_page(drawn, tmp_path / "a.pdf")
    page = (tmp_path / "a.pdf").read_bytes()
    assert page.startswith(b"%PDF")
    assert b"CreationDate" not in page  # the same delivery gives the same bytes
    words = [text.get_text() for text in drawn.figure.texts]
    assert {"READY WITH REMARKS", "Left ear", "canal tip up", "remark"} <= set(words)
    assert f"SHA-256 of a.stl: {certificate.mesh_file.sha256}" in words
    assert not any("SECRET" in word for word in words)
    assert len(mesh.triangles) == len(drop().triangles)


@pytest.mark.parametrize(("suffix", "unit"), [(".stl", "inch"), (".ply", "cm"), (".obj", "m"), (".3mf", "inch")])
def test_a_file_says_its_unit(tmp_path: Path, suffix: str, unit: str) -> None:
    profile = Profile("p", suffix, unit, open_base=True, certificate=False)
    deliver(examination(), profile, tmp_path, "a", made=MADE)
    content = (tmp_path / f"a{suffix}").read_bytes()
    assert stated_unit(suffix, content) == unit
    size = np.ptp(read_mesh(tmp_path / f"a{suffix}").vertices, axis=0) * (1.0 if suffix == ".3mf" else {"inch": 25.4, "cm": 10.0, "m": 1e3}[unit])
    low, high = drop().bounds()
    assert size == pytest.approx(high - low, rel=1e-4)


def test_points_lie_on_the_surface(tmp_path: Path) -> None:
    profile = Profile("p", ".ply", pose=Pose.CANAL_UP, points=True, certificate=False)
    deliver(examination(), profile, tmp_path, "a", made=MADE, cloud=PointCloud(drop().vertices[::3]))
    points, mesh = read_points(tmp_path / "a.xyz").points, read_mesh(tmp_path / "a.ply")
    assert points == pytest.approx(mesh.vertices[::3], abs=1e-5)
    assert set(mesh.vertex_attributes) == {"supported"}
    deliver(examination(), replace(profile, unit="cm"), tmp_path, "b", made=MADE, cloud=PointCloud(drop().vertices[::3]))
    assert read_points(tmp_path / "b.xyz").points == pytest.approx(0.1 * points, abs=1e-5)


def test_what_is_not_ready_is_delivered_only_when_a_person_says_so(tmp_path: Path) -> None:
    bad = examination(CheckVerdict.FAIL)
    with pytest.raises(DeliveryError, match="not ready to be delivered: Up to date"):
        deliver(bad, BUILT_IN[0], tmp_path, "a", made=MADE)
    assert os.listdir(tmp_path) == []
    delivery = deliver(bad, BUILT_IN[0], tmp_path, "a", made=MADE, anyway=True)
    told = valid(tmp_path / "a.json")
    assert delivery.anyway
    assert told["delivered_anyway"] is True
    assert "a person decided" in str(told["remark"])
    assert told["verdict"] == "not ready"


def test_anyway_says_nothing_where_it_was_ready(tmp_path: Path) -> None:
    delivery = deliver(examination(CheckVerdict.WARN), BUILT_IN[0], tmp_path, "a", made=MADE, anyway=True)
    assert not delivery.anyway
    assert valid(tmp_path / "a.json")["verdict"] == "ready with remarks"


def test_nothing_is_overwritten_unasked(tmp_path: Path) -> None:
    (tmp_path / "a.pdf").write_text("mine")
    with pytest.raises(StorageError) as fault:
        deliver(examination(), BUILT_IN[0], tmp_path, "a", made=MADE)
    assert fault.value.code == "E-DISK-03"
    assert os.listdir(tmp_path) == ["a.pdf"]
    deliver(examination(), BUILT_IN[0], tmp_path, "a", made=MADE, replace=True)
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


def test_a_revision_counts_all_files_of_a_delivery(tmp_path: Path) -> None:
    suffixes, today = BUILT_IN[0].suffixes, date(2026, 11, 27)
    (tmp_path / "2026-0142_left-1.json").write_text("")
    assert free_stem(tmp_path, "{order}_{side}-{rev}", ORDER, suffixes, today) == "2026-0142_left-2"


def test_a_name_that_is_too_long_counts_too(tmp_path: Path) -> None:
    order = replace(ORDER, number="x" * 400)
    for _ in range(3):
        stem = free_stem(tmp_path, "{order}-{rev}", order, [".stl"], date(2026, 11, 27))
        assert len(stem) <= 120
        (tmp_path / f"{stem}.stl").touch(exist_ok=False)


def test_a_disk_that_gets_full_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(delivering, "write_page", full)
    with pytest.raises(StorageError) as fault:
        deliver(examination(), BUILT_IN[0], tmp_path, "a", made=MADE)
    assert fault.value.code == "E-DISK-01"
    assert os.listdir(tmp_path) == []


def test_a_cancelled_delivery_leaves_nothing(tmp_path: Path) -> None:
    asked = iter([False, True])
    with pytest.raises(Cancelled):
        deliver(examination(), BUILT_IN[0], tmp_path, "a", made=MADE, cancelled=lambda: next(asked))
    assert os.listdir(tmp_path) == []


def test_a_folder_that_cannot_be_made_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError) as fault:
        deliver(examination(), BUILT_IN[0], tmp_path / "file" / "under", "a", made=MADE)
    assert fault.value.code == "E-DISK-02"


def test_files_that_were_put_are_taken_back_when_another_cannot_be(tmp_path: Path) -> None:
    def write() -> None:
        with all_or_none(tmp_path, ["a", "b"], replace=False) as beside:
            for path in beside.values():
                path.write_text("new")
            (tmp_path / "b").write_text("another program's")

    with pytest.raises(StorageError):
        write()
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"b": "another program's"}


def test_what_was_replaced_comes_back_when_another_file_cannot_be_put(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("first")
    (tmp_path / "b").write_text("first")

    def write() -> None:
        with all_or_none(tmp_path, ["a", "b"], replace=True) as beside:
            for path in beside.values():
                path.write_text("second")
            (tmp_path / "b").unlink()
            (tmp_path / "b").mkdir()  # as a page that another program has open, it cannot be replaced

    with pytest.raises(StorageError):
        write()
    assert sorted(os.listdir(tmp_path)) == ["a", "b"]
    assert (tmp_path / "a").read_text() == "first"


def test_the_command_checks_delivers_and_remembers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = write_case(tmp_path / "c.impronta", drop())
    assert main(["deliver", str(case), "--profile", "ear", "--out", str(tmp_path / "out"), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["verdict"] == "ready"
    assert all((tmp_path / "out" / name).exists() for name in told["delivery"]["files"])
    valid(next((tmp_path / "out").glob("*.json")))
    with CaseStore.open(case, read_only=True) as store:
        assert store.value("delivery") == told["delivery"]
        assert store.undoable == "Delivered"


def test_the_command_says_when_it_is_not_ready(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mesh = drop()
    case = write_case(tmp_path / "c.impronta", TriangleMesh(mesh.vertices, mesh.triangles[5:], mesh.vertex_attributes))
    out = tmp_path / "out"
    assert main(["deliver", str(case), "--out", str(out)]) == 3
    assert "FAIL  Closed" in capsys.readouterr().out
    assert not out.exists()
    assert main(["deliver", str(case)]) == 3
    assert main(["deliver", str(case), "--out", str(out), "--anyway"]) == 0
    assert valid(next(out.glob("*.json")))["delivered_anyway"] is True
    assert main(["deliver", str(case), "--profile", "nothing", "--out", str(out)]) == 1
