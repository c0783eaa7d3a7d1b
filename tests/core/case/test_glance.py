"""What a list of orders sees of a case: how far it has come, without a lock and without a trace."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from scanner_core.acquisition.status import FinishReason, ScanCounts
from scanner_core.case import glance_cache
from scanner_core.case.case_glance import CaseGlance, OrderState, Trouble
from scanner_core.case.edits import DISCARDED
from scanner_core.case.glance import DELIVERY, glance, glance_of, look_into, thumbnail
from scanner_core.case.glance_cache import GlanceCache, file_stamp
from scanner_core.case.observation import MEASURED, StereoObservation
from scanner_core.case.removal import put_back, remove_case
from scanner_core.case.schema import VERSION
from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import CaseLockedError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.optics.spot import Spot

ORDER = Order("A-7", "P-7", "left", "ear")
TETRAHEDRON = TriangleMesh(10 * np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
SPOT = Spot(100.0, 50.0, 1.0, 0.8, 201.0, 3000.0, 20, 0.012)
PLAN: dict[str, object] = {"views": [], "sweep_speed_deg_s": 10.0}


def _scan(store: CaseStore, kind: str, points: int, reason: FinishReason | None) -> int:
    number = store.begin_scan(kind, "rig", "c", "calibration", PLAN)
    store.append(number, [StereoObservation(1000 * number + i, 0, MEASURED, 0.0, 0.0, SPOT, SPOT) for i in range(points)])
    if reason is not None:
        store.end_scan(number, reason, ScanCounts.of(points, {MEASURED: points}))
    return number


@pytest.fixture
def store(tmp_path: Path) -> CaseStore:
    made = CaseStore.create(tmp_path / "a.impronta")
    made.put_order(ORDER)
    return made


def _told(store: CaseStore) -> CaseGlance:
    """As the open case tells, and as its file does: the same."""
    told = glance_of(store)
    store.close()
    assert glance(store.path) == told
    return told


def test_a_new_order(store: CaseStore) -> None:
    told = _told(store)
    assert (told.order, told.state, told.points, told.mesh, told.trouble) == (ORDER, OrderState.NEW, 0, None, None)
    assert told.created[:10] == told.changed[:10]


@pytest.mark.parametrize(
    ("kind", "points", "reason", "state"),
    [
        ("locate", 3, FinishReason.COMPLETED, OrderState.INTERRUPTED),  # the scan itself never began
        ("locate", 3, FinishReason.CANCELLED, OrderState.NEW),
        ("scan", 5, None, OrderState.INTERRUPTED),
        ("scan", 5, FinishReason.FAILED, OrderState.INTERRUPTED),
        ("scan", 5, FinishReason.CANCELLED, OrderState.SCANNED),
        ("scan", 0, FinishReason.CANCELLED, OrderState.NEW),
        ("scan", 5, FinishReason.COMPLETED, OrderState.SCANNED),
    ],
)
def test_how_far_a_scan_came(store: CaseStore, kind: str, points: int, reason: FinishReason | None, state: OrderState) -> None:
    _scan(store, kind, points, reason)
    told = _told(store)
    assert told.state is state
    assert told.points == (points if kind == "scan" else 0)


def test_a_discarded_scan_does_not_count(store: CaseStore) -> None:
    number = _scan(store, "scan", 5, None)
    store.edit(DISCARDED, [number], "Discard")
    told = _told(store)
    assert (told.state, told.points) == (OrderState.NEW, 0)


def test_a_surface_and_its_delivery(store: CaseStore) -> None:
    _scan(store, "scan", 5, FinishReason.COMPLETED)
    store.put_mesh(TETRAHEDRON, {})
    assert glance_of(store).state is OrderState.RECONSTRUCTED
    store.edit(DELIVERY, {"files": ["a.stl"], "mesh_id": store.mesh_id()}, "Delivered")
    assert glance_of(store).state is OrderState.DELIVERED
    store.put_mesh(TETRAHEDRON, {})  # another one, which nobody has got yet
    assert _told(store).state is OrderState.RECONSTRUCTED


def test_a_case_that_is_open_here_or_elsewhere(store: CaseStore) -> None:
    assert glance(store.path).trouble is Trouble.OPEN
    store.put_mesh(TETRAHEDRON, {})  # and its lock still holds
    with pytest.raises(CaseLockedError):
        look_into(store.path)
    store.close()
    other = sqlite3.connect(store.path, isolation_level=None)
    other.execute("PRAGMA locking_mode = EXCLUSIVE")
    other.execute("BEGIN EXCLUSIVE")
    assert glance(store.path).trouble is Trouble.OPEN
    other.close()
    assert glance(store.path).trouble is None


def _newer(path: Path) -> None:
    connection = sqlite3.connect(path)
    connection.execute(f"PRAGMA user_version = {VERSION + 1}")
    connection.close()


def _with_a_trigger(path: Path) -> None:
    connection = sqlite3.connect(path)
    connection.execute("CREATE VIEW more AS SELECT 1")
    connection.close()


@pytest.mark.parametrize(
    ("harm", "trouble"),
    [
        (_newer, Trouble.NEWER),
        (_with_a_trigger, Trouble.DAMAGED),
        (lambda path: path.write_bytes(path.read_bytes()[:5000]), Trouble.DAMAGED),
        (lambda path: path.write_bytes(b""), Trouble.DAMAGED),
        (lambda path: path.unlink(), Trouble.UNREADABLE),
    ],
)
def test_a_case_that_cannot_be_read_is_told_with_its_trouble(store: CaseStore, harm: Callable[[Path], object], trouble: Trouble) -> None:
    store.close()
    harm(store.path)
    told = glance(store.path)
    assert (told.trouble, told.state) == (trouble, None)


def test_looking_leaves_no_trace(store: CaseStore) -> None:
    store.close()
    before = (store.path.read_bytes(), file_stamp(store.path), sorted(store.path.parent.iterdir()))
    glance(store.path)
    assert (store.path.read_bytes(), file_stamp(store.path), sorted(store.path.parent.iterdir())) == before


def test_a_thumbnail(store: CaseStore) -> None:
    assert thumbnail(store, 80, 60) is None
    store.put_mesh(TETRAHEDRON, {})
    store.close()
    with look_into(store.path) as looked:
        data = thumbnail(looked, 80, 60)
    assert data is not None
    picture = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)
    assert picture is not None
    assert picture.shape == (60, 80, 4)
    assert 0.1 < (picture[..., 3] > 127).mean() < 0.9


def test_the_cache_forgets_what_has_changed_and_what_was_long_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(glance_cache, "MOST", 3)
    cache = GlanceCache(tmp_path / "cache")
    paths = [tmp_path / f"{i}.impronta" for i in range(5)]
    told = [CaseGlance(path, ORDER, OrderState.SCANNED, "2026-11-27", "2026-11-27T10:00:00+00:00", 7, 2) for path in paths]
    for one in told:
        cache.keep([(one, "s", b"png")])
    assert cache.known(dict.fromkeys(paths, "s")) == dict(zip(paths[2:], told[2:], strict=True))
    assert cache.known(dict.fromkeys(paths, "t")) == {}
    assert cache.thumbnail(paths[4], "s") == b"png"
    assert cache.thumbnail(paths[4], "t") is None
    cache.keep([(CaseGlance(paths[0], Order(), None, "", "", trouble=Trouble.OPEN), "s", None)])
    assert paths[0] not in cache.known(dict.fromkeys(paths, "s"))  # what may be over in a moment is not kept
    (tmp_path / "cache" / glance_cache.NAME).write_bytes(b"no database at all")
    assert cache.known(dict.fromkeys(paths, "s")) == {}
    cache.keep([(told[0], "s", None)])
    assert list(cache.known(dict.fromkeys(paths, "s"))) == paths[:1]


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    cache = GlanceCache(tmp_path / "file")
    cache.keep([])
    assert cache.known({}) == {}


def test_a_removed_case_is_whole_and_comes_back(store: CaseStore) -> None:
    with pytest.raises(CaseLockedError):
        remove_case(store.path)
    store.close()
    before = glance(store.path)
    taken = store.path.with_name("Removed") / store.path.name
    taken.parent.mkdir()
    taken.write_bytes(b"of the same name")
    gone = remove_case(store.path)
    assert gone == taken.with_name("a-2.impronta")
    assert taken.read_bytes() == b"of the same name"
    assert not store.path.exists()
    assert put_back(gone, store.path) == store.path
    assert glance(store.path) == before


def test_a_damaged_case_is_removed_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "b.impronta"
    path.write_bytes(b"nothing")
    assert remove_case(path).read_bytes() == b"nothing"
