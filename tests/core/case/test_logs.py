"""Logs beside a case that the case did not leave there: SQLite never sees them."""

from __future__ import annotations

import os
import signal
import struct
import subprocess
import sys
from pathlib import Path

import pytest

from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import CaseFormatError, StorageError

MAGIC = bytes.fromhex("d9d505f920a163d7")


def journal_with_super_journal(case: bytes, named: str) -> bytes:
    """A hot journal of one page whose end names a super-journal; SQLite deletes the file of that name after the rollback."""
    page_bytes, nonce = int.from_bytes(case[16:18], "big"), 1
    page = case[:page_bytes]
    header = MAGIC + struct.pack(">5I", 1, nonce, len(case) // page_bytes, 512, page_bytes)
    check = (nonce + sum(page[place] for place in range(page_bytes - 200, 0, -200))) & 0xFFFFFFFF
    record = struct.pack(">I", 1) + page + struct.pack(">I", check)
    name = named.encode()
    end = struct.pack(">I", 0x40000000 // page_bytes + 1) + name + struct.pack(">II", len(name), sum(name)) + MAGIC
    return header.ljust(512, b"\x00") + record + end


WITH_LINKS = pytest.mark.skipif(os.name != "posix", reason="Windows lets administrators alone make symbolic links")


@pytest.mark.parametrize("read_only", [False, True])
@pytest.mark.parametrize("by_link", [False, pytest.param(True, marks=WITH_LINKS)])
def test_a_journal_that_names_another_file_deletes_nothing(tmp_path: Path, read_only: bool, by_link: bool) -> None:
    path, victim, link = tmp_path / "a.impronta", tmp_path / "thesis.txt", tmp_path / "link.impronta"
    CaseStore.create(path).close()
    victim.write_bytes(b"my thesis\x00")
    journal = tmp_path / "a.impronta-journal"
    journal.write_bytes(journal_with_super_journal(path.read_bytes(), str(victim)))
    before = path.read_bytes(), journal.read_bytes()
    if by_link:
        link.symlink_to(path)
    with pytest.raises(CaseFormatError, match="speaks of another file") as refused:
        CaseStore.open(link if by_link else path, read_only=read_only)
    assert str(refused.value).isprintable()
    assert victim.read_bytes() == b"my thesis\x00"
    assert (path.read_bytes(), journal.read_bytes()) == before


@pytest.mark.skipif(os.name != "posix", reason="links and pipes")
@pytest.mark.parametrize("suffix", ["-wal", "-journal"])
@pytest.mark.parametrize("kind", ["link", "endless", "pipe", "folder"])
@pytest.mark.parametrize("read_only", [False, True])
def test_a_log_that_is_no_file_is_refused(tmp_path: Path, suffix: str, kind: str, read_only: bool) -> None:
    path = tmp_path / "a.impronta"
    CaseStore.create(path).close()
    log, secret = Path(f"{path}{suffix}"), tmp_path / "secret"
    secret.write_bytes(b"x" * 5000)
    if kind == "pipe":
        os.mkfifo(log)
    elif kind == "folder":
        log.mkdir()
    else:
        log.symlink_to("/dev/zero" if kind == "endless" else secret)
    with pytest.raises(CaseFormatError, match="is no file"):
        CaseStore.open(path, read_only=read_only)
    assert secret.read_bytes() == b"x" * 5000


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_a_new_case_does_not_bring_a_deleted_one_back(tmp_path: Path) -> None:
    path, log = tmp_path / "a.impronta", tmp_path / "a.impronta-wal"
    code = f"""
import os, signal
from pathlib import Path
from scanner_core.case.store import CaseStore, Order
CaseStore.create(Path({str(path)!r})).put_order(Order("OLD-1", "A"))
os.kill(os.getpid(), signal.SIGKILL)
"""
    assert subprocess.run([sys.executable, "-c", code], timeout=60, check=False).returncode == -signal.SIGKILL
    path.rename(tmp_path / "elsewhere")
    left = log.read_bytes()
    with pytest.raises(StorageError, match="E-DISK-03") as refused:
        CaseStore.create(path)
    assert str(log) in str(refused.value)
    assert (sorted(file.name for file in tmp_path.iterdir()), log.read_bytes()) == (["a.impronta-wal", "elsewhere"], left)
    (tmp_path / "elsewhere").rename(path)  # it comes back, and is whole
    with CaseStore.open(path) as store:
        assert store.order() == Order("OLD-1", "A")


def test_an_empty_log_is_in_nobodys_way(tmp_path: Path) -> None:
    (tmp_path / "a.impronta-wal").touch()
    with CaseStore.create(tmp_path / "a.impronta") as store:
        assert store.order() == Order()
