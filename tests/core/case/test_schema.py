"""An old case keeps everything, and everything that a case holds comes back."""

from __future__ import annotations

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from scanner_core import __version__
from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case import surfaces
from scanner_core.case.schema import APPLICATION_ID, MIGRATIONS, VERSION
from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import CaseError, CaseFormatError
from tests.core.case.lives import PLAN, mesh, observations
from tests.core.case.old_case import MESHES, OBSERVATIONS, write_old_case

OLD_TABLES = ("info", "order_entry", "calibration", "scan", "view", "verdict", "observation", "mesh", "audit")


def content(path: Path) -> dict[str, list[tuple[object, ...]]]:
    with closing(sqlite3.connect(path)) as connection:
        return {table: connection.execute(f"SELECT * FROM {table}").fetchall() for table in OLD_TABLES}


def test_an_old_case_is_migrated_and_keeps_everything(tmp_path: Path) -> None:
    path = tmp_path / "old.impronta"
    write_old_case(path)
    before = content(path)
    with CaseStore.open(path) as store:
        order = Order("17", 'P-"0142"', "left", "ear", "line\none")
        assert store.order() == order
        assert store.value("order") == {"number": "17", "patient_code": 'P-"0142"', "side": "left", "type": "ear", "remarks": "line\none"}
        assert store.undoable is None
        assert len(store.exposed_ids(1)) == OBSERVATIONS
        assert len(store.mesh()[0].vertices) == MESHES[-1]
        assert store.mesh()[1] == {"seed": 1}
        assert [line.event for line in store.audit_trail()] == ["created", "migrated"]
    after = content(path)
    after["audit"].pop()
    assert [row[-1] for row in after["scan"]] == [0] * len(after["scan"])  # all on the first mount
    after["scan"] = [row[:-1] for row in after["scan"]]
    assert after == before
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("PRAGMA user_version").fetchone() == (VERSION,)
        assert connection.execute("PRAGMA application_id").fetchone() == (APPLICATION_ID,)
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    with CaseStore.open(path) as store:
        store.put_mesh(mesh(9), {})
        store.undo()
        assert len(store.mesh()[0].vertices) == MESHES[-1]


def test_migrated_and_new_cases_have_the_same_tables(tmp_path: Path) -> None:
    write_old_case(tmp_path / "old.impronta")
    CaseStore.open(tmp_path / "old.impronta").close()
    CaseStore.create(tmp_path / "new.impronta").close()
    tables = []
    for name in ("old", "new"):
        with closing(sqlite3.connect(tmp_path / f"{name}.impronta")) as connection:
            tables.append(connection.execute("SELECT name, sql FROM sqlite_schema ORDER BY name").fetchall())
    assert tables[0] == tables[1]


def test_a_migration_that_fails_leaves_the_old_case(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "old.impronta"
    write_old_case(path)
    before = content(path)
    with monkeypatch.context() as patch:
        patch.setattr("scanner_core.case.connection.MIGRATIONS", (MIGRATIONS[0], "CREATE TABLE one (a); CREATE TABLE info (b);"))
        with pytest.raises(CaseFormatError, match="E-CASE-01"):
            CaseStore.open(path)
    assert content(path) == before
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("PRAGMA user_version").fetchone() == (1,)
        assert connection.execute("SELECT count(*) FROM sqlite_schema WHERE name = 'one'").fetchone() == (0,)
    CaseStore.open(path).close()


def killed(path: Path, script: str) -> Path:
    """A copy of the case as a program leaves it that is killed after the script."""
    left = path.with_name("left.impronta")
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")
        connection.execute("PRAGMA journal_mode = WAL")
        connection.executescript(script)
        for end in ("", "-wal"):
            shutil.copyfile(f"{path}{end}", f"{left}{end}")
    return left


def test_an_old_case_that_an_old_program_left_open_is_migrated(tmp_path: Path) -> None:
    write_old_case(tmp_path / "old.impronta")
    left = killed(tmp_path / "old.impronta", "UPDATE order_entry SET number = '18'; DELETE FROM mesh WHERE id = 2;")
    for read_only in (True, False):
        with CaseStore.open(left, read_only=read_only) as store:
            assert store.order().number == "18"
            assert store.mesh_id() == 1
        assert left.with_name("left.impronta-wal").exists() == read_only


def test_a_newer_case_that_is_still_in_its_log_is_refused_and_kept(tmp_path: Path) -> None:
    CaseStore.create(tmp_path / "new.impronta").close()
    left = killed(tmp_path / "new.impronta", f"PRAGMA user_version = {VERSION + 1}; CREATE TABLE tomorrow (a);")
    for read_only in (True, False):
        with pytest.raises(CaseFormatError, match=r"left\.impronta .*E-CASE-03"):
            CaseStore.open(left, read_only=read_only)
    with closing(sqlite3.connect(left)) as connection:
        assert connection.execute("PRAGMA user_version").fetchone() == (VERSION + 1,)
        assert connection.execute("SELECT count(*) FROM tomorrow").fetchone() == (0,)


def test_the_audit_trail_tells_what_happened(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        scan = store.begin_scan("scan", "rig", "abc", "calibration", PLAN)
        store.end_scan(scan, FinishReason.COMPLETED, ScanCounts(9, 7, {"no_spot": 2}))
        store.put_registration(scan, "abc", {})
        store.audit("exported", "mesh.stl")
        lines = [(line.event, line.detail) for line in store.audit_trail()]
    assert lines == [
        ("created", f"impronta {__version__}"),
        ("scan begun", "scan 1, scan, calibration abc"),
        ("scan ended", "scan 1, completed, 7 measured"),
        ("views registered", "scan 1, calibration abc"),
        ("exported", "mesh.stl"),
    ]


def test_registrations_masks_and_comparisons_come_back(tmp_path: Path) -> None:
    inside = np.random.default_rng(2).uniform(size=1001) < 0.3
    deviation = np.random.default_rng(3).normal(size=500)
    deviation[7] = np.nan
    before, after = {"file": "a.stl", "sha256": "00"}, {"mesh": 3, "sha256": "11"}
    with CaseStore.create(tmp_path / "a.impronta") as store:
        scan = store.begin_scan("scan", "name = 'rig'", "abc", "calibration", PLAN)
        for residual in (9.0, 7.0):
            store.put_registration(scan, "abc", {"residual_after_um": residual})
        store.put_mask("teeth", {"mesh": 3}, np.ones(3, np.bool_))
        store.put_mask("teeth", {"mesh": 3}, inside)
        store.put_mask("gone", {"mesh": 3}, inside)
        store.undo()
        number = store.put_comparison(before, after, {"tolerance_um": 250}, {"rms_um": 4.5}, deviation)
    with CaseStore.open(tmp_path / "a.impronta") as store:
        assert store.rig_toml(scan) == "name = 'rig'"
        assert [(record.calibration_id, record.report) for record in store.registrations(scan)] == [
            ("abc", {"residual_after_um": 9.0}),
            ("abc", {"residual_after_um": 7.0}),
        ]
        assert store.mask_names() == ["teeth"]
        assert store.mask("gone") is None
        assert store.mask("never") is None
        found = store.mask("teeth")
        assert found is not None
        assert found[0] == {"mesh": 3}
        assert np.array_equal(found[1], inside)
        (record,) = store.comparisons()
        assert (record.id, record.before, record.after, record.result) == (number, before, after, {"rms_um": 4.5})
        assert record.parameters["tolerance_um"] == 250
        assert store.comparison_id() == number
        assert store.deviation_um(number).tobytes() == deviation.tobytes()
        store.undo()
        assert store.comparison_id() is None
        store.undo()
        again = store.mask("teeth")
        assert again is not None
        assert again[1].tolist() == [True] * 3


def test_a_mesh_tells_where_it_comes_from(tmp_path: Path) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.put_mesh(mesh(5), {"seed": 3})
        assert "scans" not in store.mesh()[1]
        empty = [store.begin_scan(kind, "rig", "abc", "calibration", PLAN) for kind in ("locate", "scan", "scan")]
        store.append(empty[1], observations(0, 9))
        store.put_mesh(mesh(5), {"seed": 4, "parameters": {"triangles": 7}})
        provenance = store.mesh()[1]
        store.put_mesh(mesh(5), {"seed": 4, "scans": [1, 2], "calibration": "other"})
        assert store.mesh()[1]["scans"] == [1, 2]
        assert store.mesh()[1]["calibration"] == "other"
    versions = provenance["versions"]
    assert isinstance(versions, dict)
    assert versions["impronta"] == __version__
    assert versions["schema"] == VERSION
    assert versions["numpy"] == np.__version__
    assert set(versions) == {"impronta", "schema", "numpy", "scipy", "opencv", "vtk"}
    assert (provenance["seed"], provenance["scans"], provenance["calibration"]) == (4, [2], "abc")


def test_a_mesh_does_not_guess_where_it_comes_from(tmp_path: Path) -> None:
    """What the case's choices settle, and nothing else."""
    with CaseStore.create(tmp_path / "a.impronta") as store:
        for number, calibration in enumerate(("abc", "abc", "def"), 1):
            store.append(store.begin_scan("scan", "rig", calibration, "calibration", PLAN), observations(100 * number, 9))

        def told(**given: object) -> tuple[object, object]:
            store.put_mesh(mesh(5), given)
            provenance = store.mesh()[1]
            return provenance.get("scans"), provenance.get("calibration")

        assert told() == ([3], "def")
        store.edit("discarded_scans", [3], "")
        assert told() == ([2], "abc")
        store.edit("processing", {"calibration": None, "scans": [1, 2]}, "")
        assert told() == ([1, 2], "abc")
        store.edit("processing", {"calibration": None, "scans": [3, 1]}, "")
        assert told() == ([1, 3], None)  # there are two
        store.edit("processing", {"calibration": "ghi", "scans": []}, "")
        assert told() == ([2], "ghi")
        assert told(scans=[1]) == ([1], None)
        assert told(calibration="def") == (None, "def")
        for damaged in ([], {"scans": [9]}, {"scans": [[]]}, {"scans": ["x"]}):
            store.edit("processing", damaged, "")
            assert told() == (None, None)


def test_a_mesh_that_is_too_large_is_refused_in_its_own_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        store.put_mesh(mesh(5), {})
        for name, most in (("LONGEST_VALUE", 4500), ("LARGEST", 1000)):
            with monkeypatch.context() as patch:
                patch.setattr(surfaces, name, most)
                with pytest.raises(CaseError, match="E-CASE-07"):
                    store.put_mesh(mesh(500), {})
        assert store.mesh_count() == 1


@pytest.mark.parametrize(
    "damage",
    [
        "UPDATE mesh SET vertices = x'00'",
        "UPDATE mesh SET vertices = substr(vertices, 1, 20)",
        "UPDATE mesh SET triangles = vertices",
        'UPDATE mesh SET attributes_json = \'[["a", "O"]]\'',
        'UPDATE mesh SET attributes_json = \'[["a", "<f8"], ["b", "<f8"]]\'',
        "UPDATE mesh SET attributes_json = '{'",
        "UPDATE mesh SET provenance_json = ''",
        "DELETE FROM mesh WHERE id = 1",
    ],
)
def test_a_damaged_mesh_is_refused_in_one_sentence(tmp_path: Path, damage: str) -> None:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        store.put_mesh(mesh(5), {})
    with closing(sqlite3.connect(path)) as connection:
        connection.execute(damage)
        connection.commit()
    with CaseStore.open(path) as store, pytest.raises(CaseFormatError, match="E-CASE-01"):
        store.mesh()


def test_a_verdict_of_a_batch_that_failed_is_not_taken_for_known(tmp_path: Path) -> None:
    """A batch that was refused leaves nothing, also not in the program's memory."""
    with CaseStore.create(tmp_path / "a.impronta") as store:
        scan = store.begin_scan("scan", "rig", "abc", "calibration", PLAN)
        with pytest.raises(CaseFormatError):
            store.append(scan, observations(0, 9) * 2)  # every trigger id is unique
        store.append(scan, observations(0, 9))
        assert sum(store.verdict_counts(scan).values()) == 9


def test_what_was_closed_is_not_written(tmp_path: Path) -> None:
    store = CaseStore.create(tmp_path / "a.impronta")
    store.close()
    for act in (store.undo, store.mesh, lambda: store.limit_growth(None)):
        with pytest.raises(CaseError, match="E-CASE-06"):
            act()
