"""Cases from outside: whatever stands in the database, reading it ends in a value or in E-CASE-01, and runs nothing."""

from __future__ import annotations

import json
import sqlite3
import tracemalloc
import zlib
from pathlib import Path

import pytest

from scanner_core.case import vetting
from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseFormatError, ImprontaError
from tests.fuzz.corpus import samples
from tests.fuzz.readers import read_everything


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "a.impronta").write_bytes(samples("case")[0])
    return tmp_path / "a.impronta"


def _change(path: Path, *statements: str, values: tuple[object, ...] = ()) -> None:
    connection = sqlite3.connect(path, isolation_level=None)
    for statement in statements:
        connection.execute(statement, values if "?" in statement else ())
    connection.close()


def test_a_sound_case_passes(path: Path) -> None:
    with CaseStore.open(path) as store:
        read_everything(store)


FOREIGN = [
    ("CREATE TRIGGER t AFTER INSERT ON audit BEGIN DELETE FROM observation; END", "a trigger 't'"),
    ("CREATE VIEW v AS SELECT 1", "a view 'v'"),
    ("CREATE VIRTUAL TABLE v USING fts5(a)", "a table 'v'"),
    ("CREATE INDEX i ON audit (time)", "a index 'i'"),
    ("CREATE TABLE t (a, b AS (a + 1))", "a table 't'"),
    ("ALTER TABLE audit ADD COLUMN c AS (event || detail)", "its table 'audit' is not defined as in a case"),
    ("DROP TABLE mask", "its table 'mask' is missing"),
    ("PRAGMA user_version = 0", "it has the version 0"),
    ("PRAGMA user_version = -5", ""),
    ("PRAGMA application_id = 7", "another program"),
]


@pytest.mark.parametrize(("statement", "reason"), FOREIGN, ids=[statement for statement, _ in FOREIGN])
@pytest.mark.parametrize("read_only", [True, False])
def test_a_schema_of_somebody_else_is_refused_and_left_alone(path: Path, statement: str, reason: str, read_only: bool) -> None:
    _change(path, statement)
    before = path.read_bytes()
    with pytest.raises(CaseFormatError) as caught:
        CaseStore.open(path, read_only=read_only)
    assert reason in str(caught.value)
    assert str(path) in str(caught.value)
    assert str(caught.value).isprintable()
    assert path.read_bytes() == before
    assert [file.name for file in path.parent.iterdir()] == [path.name]


def test_a_view_that_hides_a_table_is_refused(path: Path) -> None:
    _change(path, "ALTER TABLE observation RENAME TO other", "CREATE VIEW observation AS SELECT * FROM other, other")
    with pytest.raises(CaseFormatError, match="E-CASE-01"):
        CaseStore.open(path)


def test_a_schema_that_was_written_by_hand_is_refused(path: Path) -> None:
    _change(path, "PRAGMA writable_schema = ON", "UPDATE sqlite_schema SET sql = 'CREATE TABLE audit (id INTEGER PRIMARY KEY)' WHERE name = 'audit'")
    with pytest.raises(CaseFormatError, match="E-CASE-01"):
        CaseStore.open(path)


def test_pages_that_are_used_twice_are_found(path: Path) -> None:
    """Such a tree makes a small file seem endless."""
    connection = sqlite3.connect(path)
    size = connection.execute("PRAGMA page_size").fetchone()[0]
    roots = dict(connection.execute("SELECT name, rootpage FROM sqlite_schema WHERE type = 'table'").fetchall())
    connection.close()
    content = bytearray(path.read_bytes())
    page = (roots["audit"] - 1) * size
    content[page] = 5  # an inner page whose one child is itself
    content[page + 1 : page + 12] = bytes(2) + bytes(2) + bytes(3) + roots["audit"].to_bytes(4, "big")
    path.write_bytes(content)
    with pytest.raises(CaseFormatError, match=r"damaged|malformed"):
        CaseStore.open(path)


def test_a_check_that_takes_too_long_ends(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(vetting, "CHECK_S", -1e9)
    monkeypatch.setattr(vetting, "_STEPS", 1)
    with pytest.raises(CaseFormatError, match="could not be checked within"):
        CaseStore.open(path)


BOMB = zlib.compress(bytes(100_000_000), 9)

VALUES = [
    ("UPDATE scan SET plan_json = ?", "[" * 100_000, "its list of scans is damaged"),
    ("UPDATE scan SET plan_json = ?", '{"views": [{"rows": [{"first_id": 1e5, "count": 1}]}]}', "its list of scans is damaged"),
    ("UPDATE scan SET plan_json = ?", '{"views": [{"rows": [{"first_id": -7, "count": 1}]}]}', "a first_id of -7"),
    ("UPDATE scan SET counts_json = ?", '{"measured": NaN}', "the number NaN"),
    ("UPDATE scan SET counts_json = ?", '{"measured": 1e999}', "a number beyond all bounds"),
    ("UPDATE scan SET started = ?", b"\xff\xfe", "bytes instead of a text"),
    ("UPDATE scan SET started = CAST(? AS TEXT)", b"\xff\xfe", "E-CASE-01"),
    ("UPDATE calibration SET toml = ?", "[" * 50_000, "its calibration is damaged"),
    ("UPDATE calibration SET toml = ?", "name = '\x1b[31m'", "its calibration is damaged"),
    ("UPDATE observation SET left_x_px = ? WHERE trigger_id = 4", "here", "its list of observations is damaged"),
    ("UPDATE observation SET left_x_px = ? WHERE trigger_id = 4", float("inf"), "a centroid of inf in row"),
    ("UPDATE observation SET left_x_px = ? WHERE trigger_id = 4", None, "a centroid of nan in row"),
    ("UPDATE observation SET left_u_upx = ? WHERE trigger_id = 4", -3, "a uncertainty of -3 in row"),
    ("UPDATE observation SET view = ? WHERE trigger_id = 4", 2**40, "a view of 1.09951e+12"),
    ("UPDATE observation SET view = ? WHERE trigger_id = 4", 50_000, "a view of 50000"),  # every pair of views is compared
    ("UPDATE observation SET trigger_id = ? WHERE trigger_id = 4", -1, "E-CASE-01"),
    ("UPDATE view SET correction_json = ?", "[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]", "no rigid motion"),
    ("UPDATE mesh SET attributes_json = ?", '[["a", "O8"]]', "an attribute holds no numbers"),
    ("UPDATE mesh SET triangles = ?", zlib.compress(b"\xff" * 24), "a vertex that is not there"),
    ("UPDATE mesh SET vertices = ?", BOMB, "larger than it may be"),
    ("UPDATE mesh SET attributes = ?", BOMB, "larger than it may be"),
    ("UPDATE mask SET bits = ?", BOMB, "larger than it may be"),
    ("UPDATE mask SET count = ?", 2**62, "its mask stable is damaged"),
    ("UPDATE comparison SET deviation = ?", BOMB, "larger than it may be"),
    ("UPDATE current_value SET value_json = ?", "{" * 5000, "its choice of"),
    ("UPDATE edit SET after_json = ?", "{]", "its journal of edits is damaged"),
]


SOUND = {"view": 0, "first_id": 0, "count": 9, "y_deg": 0.0, "x_from_deg": -1.0, "x_to_deg": 1.0}
PLANS = [
    ({"views": [{"table_deg": 0.0, "quota": None, "rows": []}] * 361}, "more than 360 views"),
    ({"views": {}}, "more than 360 views, or none"),
    ({"sweep_speed_deg_s": 0.0}, "a sweep_speed_deg_s of 0"),
    ({"sweep_speed_deg_s": -3.0}, "a sweep_speed_deg_s of -3"),
    ({"sweep_speed_deg_s": 1001}, "a sweep_speed_deg_s of 1001"),
    ({"sweep_speed_deg_s": "3"}, "no number"),
    ({"table_deg": 1441.0}, "a table_deg of 1441"),
    ({"quota": 10**8}, "a quota of 100000000"),
    ({"count": 20_000_001}, "a count of 20000001"),
    ({"rows": [SOUND | {"count": 15_000_000}] * 2}, "30000000 trigger ids"),
    ({"first_id": 2**53, "count": 1}, "a row of 1 trigger ids"),
    ({"view": 1}, "a row of view 1 in view 0"),
    ({"view": -1}, "a view of -1"),
    ({"y_deg": 91.0}, "a y_deg of 91"),
    ({"x_to_deg": True}, "no number"),
]


@pytest.mark.parametrize(("changes", "reason"), PLANS, ids=range(len(PLANS)))
def test_a_plan_that_no_rig_could_follow_is_named(path: Path, changes: dict[str, object], reason: str) -> None:
    row = SOUND | {name: value for name, value in changes.items() if name in SOUND}
    view = {"table_deg": 0.0, "quota": 8, "rows": [row]} | {name: value for name, value in changes.items() if name in ("table_deg", "quota", "rows")}
    plan = {"sweep_speed_deg_s": 3.0, "views": [view]} | {name: value for name, value in changes.items() if name in ("sweep_speed_deg_s", "views")}
    _change(path, "UPDATE scan SET plan_json = ?", values=(json.dumps(plan),))
    with pytest.raises(CaseFormatError, match="its list of scans is damaged") as refused, CaseStore.open(path) as store:
        store.scans()
    assert reason in str(refused.value)


def test_the_check_of_known_points_holds_some_views_only(path: Path) -> None:
    plan = {"sweep_speed_deg_s": 3.0, "views": [{"table_deg": 270.0, "quota": 8, "rows": [SOUND | {"view": 3}]}]}
    _change(path, "UPDATE scan SET kind = 'check', plan_json = ?", values=(json.dumps(plan),))
    with CaseStore.open(path) as store:
        assert store.scans()[0].plan == plan


@pytest.mark.parametrize(("statement", "value", "reason"), VALUES, ids=range(len(VALUES)))
def test_a_value_that_cannot_be_right_is_named_and_costs_nothing(path: Path, statement: str, value: object, reason: str) -> None:
    _change(path, statement, values=(value,))
    told: list[str] = []

    tracemalloc.start()
    try:
        with CaseStore.open(path) as store:
            read_everything(store, told=lambda error: told.append(str(error)))
        assert tracemalloc.get_traced_memory()[1] < 40_000_000
    except ImprontaError as error:
        told.append(str(error))
    finally:
        tracemalloc.stop()
    assert any(reason in sentence for sentence in told)
    assert all(sentence.isprintable() and len(sentence) < 1000 for sentence in told)
