"""``--force`` on a case: what was there survives until the new scan has measured something."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore, Order
from scanner_core.commands import demo
from scanner_core.commands.overwriting import overwriting
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.errors import CaseLockedError, DeviceError, StorageError

OLD = Order("OLD-1", "A")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "cases").mkdir()
    with CaseStore.create(tmp_path / "cases" / "case.impronta") as store:
        store.put_order(OLD)
    return tmp_path / "cases" / "case.impronta"


def order(path: Path) -> Order:
    assert [file.name for file in path.parent.iterdir()] == [path.name]
    with CaseStore.open(path, read_only=True) as store:
        return store.order()


@pytest.mark.parametrize("fails", [None, RuntimeError, KeyboardInterrupt])
@pytest.mark.parametrize("measured", [False, True])
@pytest.mark.parametrize("made", [False, True])
def test_the_old_case_goes_when_the_new_one_holds_something(path: Path, fails: type[BaseException] | None, measured: bool, made: bool) -> None:
    try:
        with overwriting(path, force=True) as begun:
            assert not path.exists()
            if made:
                with CaseStore.create(path) as store:
                    store.put_order(Order("NEW-1"))
                    if measured:
                        begun()
                        begun()
                    if fails is not None:
                        raise fails
            elif fails is not None:
                raise fails
    except (RuntimeError, KeyboardInterrupt):
        assert fails is not None
    assert order(path) == (Order("NEW-1") if made and measured else OLD)


def test_a_log_without_its_case_is_overwritten_too(path: Path) -> None:
    path.rename(path.with_suffix(".impronta-wal"))
    with pytest.raises(StorageError, match="E-DISK-03"):
        CaseStore.create(path)
    with overwriting(path, force=True) as begun, CaseStore.create(path):
        begun()
    assert order(path) == Order()


def test_without_force_or_while_it_is_open_nothing_moves(path: Path) -> None:
    with overwriting(path, force=False), pytest.raises(StorageError, match="E-DISK-03"):
        CaseStore.create(path)
    with CaseStore.open(path) as store, pytest.raises(CaseLockedError, match="E-CASE-02"), overwriting(path, force=True):
        store.audit("never")
    assert order(path) == OLD


def test_a_rig_that_cannot_be_opened_costs_no_case(path: Path, tmp_path: Path) -> None:
    toml = re.sub(r'port = ".*"', 'port = "/dev/nothing"', dump_rig(load_preset("bench")))
    rig = tmp_path / "rig.toml"
    rig.write_text(re.sub(r'witness = ".*"', 'witness = "127.0.0.1:9"', toml), encoding="utf-8")
    assert main(["scan", "--rig", str(rig), "--specimen", "sphere", "--out", str(path), "--force"]) == 1
    assert order(path) == OLD


def test_a_scan_puts_its_case_in_the_place_of_the_old_one(path: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plan = tmp_path / "plan.toml"
    plan.write_text("views = 2\npoints = 200\n", encoding="utf-8")
    arguments = ["scan", "--rig", "bench", "--plan", str(plan), "--specimen", "sphere", "--out", str(path)]
    assert main(arguments) == 1  # without --force
    assert order(path) == OLD
    assert main([*arguments, "--force"]) == 0
    assert order(path) == Order(type="sphere")
    assert "Kept in" in capsys.readouterr().out


def test_a_demo_that_cannot_calibrate_costs_no_case(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> None:
        raise DeviceError("E-CAM-01", camera="left", seconds=1)

    monkeypatch.setattr(demo, "_calibrate", fails)
    assert main(["demo", "--specimen", "sphere", "--out", str(path.parent), "--force"]) == 1
    assert order(path) == OLD
