"""A case in whatever state it was left, wherever it lies: it works, or one sentence says why not; looking leaves no trace."""

from __future__ import annotations

import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path, PureWindowsPath
from types import SimpleNamespace

import pytest

from scanner_core.case import reading
from scanner_core.case.connection import uri
from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseError, CaseFormatError, CaseLockedError, InputFileError, StorageError
from tests.core.case.lives import CASE, PLAN, live, observations, record, state
from tests.core.case.old_case import write_old_case

posix = pytest.mark.skipif(os.name != "posix", reason="permissions and signals of POSIX")


def left_by_a_kill(path: Path) -> None:
    code = f"""
import os, signal
from pathlib import Path
from scanner_core.case.store import CaseStore
from tests.core.case.lives import PLAN, observations
store = CaseStore.create(Path({str(path)!r}))
store.append(store.begin_scan("scan", "rig", "abc", "calibration", PLAN), observations(0, 9))
os.kill(os.getpid(), signal.SIGKILL)
"""
    killed = subprocess.run([sys.executable, "-c", code], timeout=60, check=False)
    assert killed.returncode == -signal.SIGKILL


def snapshot(folder: Path) -> dict[str, tuple[bytes, int]]:
    return {file.name: (file.read_bytes(), file.stat().st_mtime_ns) for file in folder.iterdir()}


@pytest.fixture
def own_temporary_folder(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tests that run beside these look into cases, too."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path_factory.mktemp("temporary")))


def looks() -> int:
    return len(list(Path(tempfile.gettempdir()).glob("impronta-look-*")))


@contextmanager
def somebody() -> Iterator[None]:
    """The tests may run as root, who may do anything: be somebody else for a moment."""
    root = os.geteuid() == 0
    if root:
        os.seteuid(65534)
    try:
        yield
    finally:
        if root:
            os.seteuid(0)


@pytest.fixture
def public() -> Iterator[Path]:
    """A folder that anybody may read and write."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o777)
        yield Path(folder)


@posix
@pytest.mark.parametrize("name", ["a#b?c%20d&mode=memory.impronta", "Ümlaut 漢字 'quoted\".impronta", ":memory:.impronta", "file:x.impronta"])
def test_any_name(tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with CaseStore.create(Path(name)) as store:
        store.begin_scan("scan", "rig", "abc", "calibration", PLAN)
    assert [file.name for file in tmp_path.iterdir()] == [name]
    for read_only in (False, True):
        with CaseStore.open(Path(name), read_only=read_only) as store:
            assert len(store.scans()) == 1


def test_a_share_of_a_network_is_a_place_too() -> None:
    assert uri(PureWindowsPath("//server/share/a b.impronta")) == "file:////server/share/a%20b.impronta"
    assert uri(PureWindowsPath("C:/cases/a.impronta")) == "file:///C:/cases/a.impronta"


@posix
@pytest.mark.usefixtures("own_temporary_folder")
def test_looking_at_what_a_kill_left_leaves_no_trace(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    left_by_a_kill(path)
    before = snapshot(tmp_path)
    assert set(before) == {"a.impronta", "a.impronta-wal"}
    with CaseStore.open(path, read_only=True) as store:
        assert store.exposed_ids(1).tolist() == list(range(9))
        with pytest.raises(StorageError, match="E-DISK-02"):
            store.audit("looked")
    assert snapshot(tmp_path) == before
    assert looks() == 0
    with CaseStore.open(path) as store:
        assert store.exposed_ids(1).tolist() == list(range(9))
    assert set(snapshot(tmp_path)) == {"a.impronta"}


@posix
@pytest.mark.usefixtures("own_temporary_folder")
def test_a_log_is_not_copied_without_bound(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.impronta"
    left_by_a_kill(path)
    before = snapshot(tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(reading, "LARGEST_LOG", 1000)
        with pytest.raises(CaseFormatError, match="the log beside it has"):
            CaseStore.open(path, read_only=True)
    with monkeypatch.context() as patch:
        patch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=1000))
        with pytest.raises(StorageError, match="E-DISK-01"):
            CaseStore.open(path, read_only=True)
    assert (snapshot(tmp_path), looks()) == (before, 0)


@posix
def test_looking_at_every_state_that_a_crash_leaves_changes_nothing(tmp_path: Path) -> None:
    for name in ("recorded", "found"):
        (tmp_path / name).mkdir()
    life = record(tmp_path / "recorded", live)
    for count, disk in life.disks():
        if count % 7 == 0 and CASE in disk.after_kill():
            for name, content in disk.after_kill().items():
                (tmp_path / "found" / name).write_bytes(content)
            before = snapshot(tmp_path / "found")
            with CaseStore.open(tmp_path / "found" / CASE, read_only=True) as store:
                assert state(store) in life.allowed(count)
            assert snapshot(tmp_path / "found") == before
            for file in (tmp_path / "found").iterdir():
                file.unlink()


@pytest.mark.usefixtures("own_temporary_folder")
def test_looking_at_a_case_at_rest_leaves_no_trace(tmp_path: Path) -> None:
    write_old_case(tmp_path / "old.impronta")
    CaseStore.create(tmp_path / "new.impronta").close()
    before = snapshot(tmp_path)
    with CaseStore.open(tmp_path / "old.impronta", read_only=True) as old, CaseStore.open(tmp_path / "new.impronta", read_only=True) as new:
        assert old.undoable is None
        assert new.scans() == []
        with CaseStore.open(tmp_path / "new.impronta", read_only=True) as again:
            assert again.scans() == []
        for store in (old, new):
            with pytest.raises(StorageError, match="E-DISK-02"):
                store.edit("processing", {}, "never")
    assert snapshot(tmp_path) == before
    assert looks() == 0


@posix
def test_looking_at_what_is_being_written_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    look = f"from pathlib import Path; from scanner_core.case.store import CaseStore; CaseStore.open(Path({str(path)!r}), read_only=True)"
    with CaseStore.create(path) as store:
        with pytest.raises(CaseLockedError, match="E-CASE-02"):
            CaseStore.open(path, read_only=True)
        link = tmp_path / "link.impronta"
        link.symlink_to(path)
        for read_only in (False, True):
            with pytest.raises(CaseLockedError, match="E-CASE-02"):
                CaseStore.open(link, read_only=read_only)
        # ... and the attempts have not broken the lock.
        other = subprocess.run([sys.executable, "-c", look], capture_output=True, text=True, timeout=60, check=False)
        assert "E-CASE-02" in other.stderr
        store.audit("still mine")
    with CaseStore.open(path, read_only=True) as store:
        assert [line.event for line in store.audit_trail()] == ["created", "still mine"]


def test_a_look_does_not_keep_a_scan_from_beginning(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    CaseStore.create(path).close()
    with CaseStore.open(path, read_only=True) as look:
        assert look.scans() == []
        with CaseStore.open(path) as store:
            store.begin_scan("scan", "rig", "abc", "calibration", PLAN)
            with pytest.raises(CaseLockedError, match="E-CASE-02"):
                look.scans()
        assert len(look.scans()) == 1


@posix
def test_a_case_that_may_not_be_written(public: Path) -> None:
    path = public / "a.impronta"
    CaseStore.create(path).close()
    path.chmod(0o444)
    before = snapshot(public)
    with somebody():
        with pytest.raises(StorageError, match="E-DISK-02"):
            CaseStore.open(path)
        with CaseStore.open(path, read_only=True) as store:
            assert store.scans() == []
    assert snapshot(public) == before


@posix
@pytest.mark.parametrize("killed", [False, True])
def test_a_folder_that_may_not_be_written(public: Path, killed: bool) -> None:
    path = public / "a.impronta"
    if killed:
        left_by_a_kill(path)
    else:
        CaseStore.create(path).close()
    before = snapshot(public)
    for file in public.iterdir():
        file.chmod(0o644)
    public.chmod(0o555)
    with somebody():
        with pytest.raises(StorageError, match="E-DISK-02"):
            CaseStore.open(path)
        with pytest.raises(StorageError, match="E-DISK-02"):
            CaseStore.create(public / "b.impronta")
        with CaseStore.open(path, read_only=True) as store:
            assert len(store.scans()) == killed
    assert snapshot(public) == before


@pytest.mark.parametrize("read_only", [False, True])
def test_a_case_that_vanishes_while_it_is_opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, read_only: bool) -> None:
    path = tmp_path / "a.impronta"
    CaseStore.create(path).close()

    def and_then_it_goes(place: Path) -> bool:
        path.unlink()
        return True

    monkeypatch.setattr(os.path, "isfile", and_then_it_goes)
    with pytest.raises(CaseError, match="E-CASE-04"):
        CaseStore.open(path, read_only=read_only)
    assert list(tmp_path.iterdir()) == []


@posix
def test_a_case_that_may_not_be_read(public: Path) -> None:
    path = public / "a.impronta"
    CaseStore.create(path).close()
    path.chmod(0)
    with somebody():
        for read_only in (False, True):
            with pytest.raises(InputFileError, match="E-FILE-05"):
                CaseStore.open(path, read_only=read_only)


@posix
def test_no_file_of_its_own(tmp_path: Path) -> None:
    with pytest.raises(CaseError, match="E-CASE-04"):
        CaseStore.open(tmp_path / "none.impronta", read_only=True)
    os.mkfifo(tmp_path / "pipe.impronta")
    for path in (tmp_path, tmp_path / "pipe.impronta"):
        with pytest.raises(CaseError, match="E-CASE-01"):
            CaseStore.open(path, read_only=True)
    (tmp_path / "file").touch()
    for path in (tmp_path / "no folder" / "a.impronta", tmp_path / "file" / "a.impronta"):
        with pytest.raises(StorageError, match="E-DISK-02"):
            CaseStore.create(path)


def test_what_a_killed_creation_left_goes_with_the_next(tmp_path: Path) -> None:
    old, young = tmp_path / ".a.0123abcd.part.impronta", tmp_path / ".b.0123abcd.part.impronta"
    others = [tmp_path / name for name in (".a.0123abcd.part.stl", "a.0123abcd.part.impronta", ".a.part.impronta")]
    for path in (old, young, *others):
        path.write_bytes(b"half a case")
    for path in (old, *others):
        os.utime(path, (time.time() - 3700,) * 2)
    CaseStore.create(tmp_path / "c.impronta").close()
    assert not old.exists()
    assert young.exists()
    assert all(path.exists() for path in others)


def test_a_quota_is_a_full_disk(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    with CaseStore.create(path) as store:
        scan = store.begin_scan("scan", "rig", "abc", "calibration", PLAN)
        store.append(scan, observations(0, 20))
        store.limit_growth(2)
        with pytest.raises(StorageError, match="E-DISK-01"):
            store.append(scan, observations(20, 500))
        assert len(store.exposed_ids(scan)) == 20
        store.limit_growth(None)
        store.append(scan, observations(20, 500))
    with CaseStore.open(path) as store:
        assert len(store.exposed_ids(scan)) == 520
    with closing(sqlite3.connect(path)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
