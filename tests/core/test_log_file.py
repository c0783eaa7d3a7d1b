from __future__ import annotations

import errno
import logging
import multiprocessing
import os
from pathlib import Path

import pytest

from scanner_core import log_file
from scanner_core.errors import CaseLockedError, StorageError
from scanner_core.log_file import FILES, LogFile, keep_out, log_fault, log_files, log_versions, logging_to_file
from scanner_core.support.private_names import file_names, order_names

LOG = logging.getLogger("impronta")


@pytest.fixture(autouse=True)
def no_names(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log_file, "_names", {})


def _text(folder: Path) -> str:
    return "".join(path.read_text(encoding="utf-8") for path in reversed(log_files(folder)))


def test_it_begins_with_the_versions_and_holds_what_was_told(tmp_path: Path) -> None:
    with logging_to_file("impronta scan", folder=tmp_path):
        log_versions()
        LOG.info("rig opened: bench")
        LOG.debug("too much")
    lines = _text(tmp_path).splitlines()
    assert [line.split(" INFO ")[1].split(":")[0] for line in lines] == ["start", "versions", "rig opened", "end"]
    assert "numpy" in lines[1]
    LOG.warning("after the end")
    assert "after the end" not in _text(tmp_path)


def test_a_fault_has_its_code_its_details_and_its_traceback(tmp_path: Path) -> None:
    with logging_to_file("t", folder=tmp_path):
        try:
            raise CaseLockedError("E-CASE-02", path="x", details="locked by 17")
        except CaseLockedError as fault:
            log_fault(fault, "scan")
    text = _text(tmp_path)
    assert all(part in text for part in ("E-CASE-02", "locked by 17", "Traceback", "test_log_file.py"))


def test_names_of_orders_patients_and_files_are_not_in_it(tmp_path: Path) -> None:
    with logging_to_file("t", file_names([tmp_path / "Meyer Anna 1962" / "ear left.stl"]), tmp_path):
        keep_out(order_names("2026-0142", "Quirin Zwack"))
        LOG.warning("order %s of %s", "2026-0142", "QUIRIN ZWACK")
        LOG.warning("cannot read %s", tmp_path / "Meyer Anna 1962" / "ear left.stl")
        try:
            raise OSError(2, "No such file", "/mnt/x/Xaver Yps.stl")
        except OSError as cause:
            try:
                raise StorageError("E-DISK-02", path="/mnt/Ute Ohm/x y.impronta", reason="gone") from cause
            except StorageError as fault:
                log_fault(fault, "scan")
                LOG.error("%s", fault)
    text = _text(tmp_path)
    assert "E-DISK-02" in text
    for name in ("0142", "Quirin", "QUIRIN", "Zwack", "Meyer", "ear left", "Xaver", "Yps", "Ute", "Ohm", "x y"):
        assert name not in text


def test_it_never_grows_beyond_its_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log_file, "MOST_BYTES", 20_000)
    handler = LogFile(tmp_path)
    long = "z y" * 1000
    for number in range(60):
        handler.emit(logging.LogRecord("impronta", logging.INFO, "", 0, f"{number} {long}", (), None))
    files = log_files(tmp_path)
    assert len(files) == FILES
    assert sum(path.stat().st_size for path in tmp_path.iterdir()) <= FILES * 20_000
    assert " 59 z y" in files[0].read_text()
    found = [int(line.split(" INFO ")[1].split()[0]) for line in _text(tmp_path).splitlines()]
    assert found == list(range(found[0], 60))  # the newest are all there, in their order


def _write_many(folder: Path, mark: str, lines: int = 300) -> None:
    handler = LogFile(folder)
    for number in range(lines):
        handler.emit(logging.LogRecord("impronta", logging.INFO, "", 0, f"{mark}{number} {'y' * 3000}", (), None))


def test_what_a_killed_program_left_does_not_stop_the_files_from_moving_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log_file, "MOST_BYTES", 1000)
    mark = tmp_path / "impronta.moving"
    mark.write_text("")
    _write_many(tmp_path, "a", 3)
    assert len(log_files(tmp_path)) == 1  # somebody may be at it
    os.utime(mark, (0, 0))
    _write_many(tmp_path, "b", 3)
    assert len(log_files(tmp_path)) == 4
    assert not mark.exists()


def test_two_programs_write_one_log(tmp_path: Path) -> None:
    other = multiprocessing.get_context("spawn").Process(target=_write_many, args=(tmp_path, "b"))
    other.start()
    _write_many(tmp_path, "a")
    other.join(60)
    assert other.exitcode == 0
    other.close()
    told = [line.split(" INFO ")[1].split()[0] for line in _text(tmp_path).splitlines()]
    assert len(set(told)) == len(told) == 600  # every line whole and once


def test_a_folder_that_cannot_be_written_is_said_once_and_stops_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    ran = False
    with logging_to_file("t", folder=tmp_path / "file" / "log"):
        LOG.warning("one")
        ran = True
    assert ran
    assert capsys.readouterr().err.count("There will be no log") == 1


def test_a_log_that_goes_away_meanwhile_is_said_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "log"
    with logging_to_file("t", folder=folder):
        for path in folder.iterdir():
            path.unlink()
        folder.rmdir()
        LOG.warning("one")
        LOG.warning("two")
    assert capsys.readouterr().err.count("The log could not be written") == 1


def test_a_full_disk_is_told_by_what_was_measured_not_by_the_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    log = LogFile(tmp_path)

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "open", full)
    log.emit(logging.LogRecord("impronta", logging.INFO, __file__, 1, "a line", None, None))
    assert capsys.readouterr().err == ""
