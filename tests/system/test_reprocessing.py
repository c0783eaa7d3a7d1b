"""``impronta reconstruct CASE`` computes the points anew, says so, and gives the same bytes for the same question."""

from __future__ import annotations

import argparse
import json
import sqlite3
import subprocess
from contextlib import closing
from pathlib import Path

import pytest

from scanner_core.__main__ import main
from scanner_core.case.edits import PROCESSING
from scanner_core.case.processing import Gates, Processing, chosen_processing
from scanner_core.case.store import CaseStore
from scanner_core.commands.processing import asked_processing
from scanner_core.devices.rig import load_preset
from tests.core.case.test_processing import small_case
from tests.system.impronta import balanced, command, environment


@pytest.fixture
def case(tmp_path: Path) -> Path:
    (tmp_path / "a.impronta").write_bytes(small_case())
    return tmp_path / "a.impronta"


def test_the_same_choice_gives_the_same_bytes(tmp_path: Path, case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Said on the command line or held by the case, and whatever the order of sets and the number of threads."""
    other = tmp_path / "b.impronta"
    other.write_bytes(small_case())
    choice = Processing(gates=Gates(volume_radius_mm=38.0, least_peak_dn=60.0), without_views=(1,))
    with CaseStore.open(other) as store:
        store.edit(PROCESSING, choice.as_dict(), "by the window")
    words = ("--gate", "volume_radius_mm=38", "--gate", "least_peak_dn=60", "--without-view", 1)
    runs = ((case, words, "1", "1"), (other, (), "4711", "2"))
    told = []
    for path, said, seed, threads in runs:
        line = command("reconstruct", path, "--out", path.with_suffix(".ply"), "--seed", 3, "--triangles", 3000, "--json", *said)
        more = {"PYTHONHASHSEED": seed, "OMP_NUM_THREADS": threads, "OPENBLAS_NUM_THREADS": threads}
        done = subprocess.run(line, env=environment() | more, check=False, timeout=300, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        told.append(json.loads(done.stdout)["processing"])
        assert main(["export", str(path), "--out", str(path.with_suffix(".stl"))]) == 0
    for suffix in (".ply", ".stl"):
        assert case.with_suffix(suffix).read_bytes() == other.with_suffix(suffix).read_bytes()
    assert told[0] == told[1]
    balanced(told[0])
    assert told[0]["registered_anew"] is True
    capsys.readouterr()
    assert main(["info", str(case), "--json"]) == 0
    info = json.loads(capsys.readouterr().out)
    assert info["mesh"]["provenance"]["processing"] == told[0]
    assert info["processing"] == {"calibration": None, "gates": {"least_peak_dn": 60.0, "volume_radius_mm": 38.0}, "without_views": [1], "scans": []}


def test_options_replace_what_the_case_holds(case: Path) -> None:
    nothing = argparse.Namespace(calibration=None, gate=[], without_view=[], scan=[], as_scanned=False)
    with CaseStore.open(case) as store:
        store.edit(PROCESSING, Processing(without_views=(1,)).as_dict(), "by the window")
        assert asked_processing(store, nothing).processing == Processing(without_views=(1,))
        gates = argparse.Namespace(**{**vars(nothing), "gate": ["table_mm=-1"]})
        assert asked_processing(store, gates).processing == Processing(gates=Gates(table_mm=-1.0))
        dropped = asked_processing(store, argparse.Namespace(**{**vars(nothing), "as_scanned": True}))
        assert dropped.processing == Processing()
        dropped.keep(store)
        assert chosen_processing(store) == Processing()
        other = asked_processing(store, argparse.Namespace(**{**vars(nothing), "calibration": "bench"}))
        other.keep(store)
        bench = load_preset("bench").calibration
        assert bench is not None
        assert chosen_processing(store).calibration == bench.identity()
        assert bench.identity() in store.calibration_ids()
        assert asked_processing(store, argparse.Namespace(**{**vars(nothing), "calibration": bench.identity()})).rig is None


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--gate", "fog=1"), "There is no gate 'fog'"),
        (("--gate", "table_mm"), "which is no number"),
        (("--gate", "table_mm=nan"), "The gate 'table_mm' is nan"),
        (("--without-view", "9"), "has no view 9"),
        (("--scan", "9"), "no scan 9"),
        (("--as-scanned", "--scan", "1"), "together with a change"),
    ],
)
def test_wrong_use_is_one_sentence_and_changes_nothing(
    tmp_path: Path, case: Path, words: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    before = _content(case)
    assert main(["reconstruct", str(case), "--out", str(tmp_path / "a.ply"), *words]) == 2
    told = capsys.readouterr()
    assert said in told.err
    assert (told.out, len(told.err.strip().splitlines())) == ("", 1)
    assert _content(case) == before


def test_only_a_case_can_be_processed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.xyz").write_text("0 0 0\n")
    assert main(["reconstruct", str(tmp_path / "a.xyz"), "--out", str(tmp_path / "a.ply"), "--gate", "table_mm=1"]) == 2
    assert "Only the points of a case" in capsys.readouterr().err


def _content(case: Path) -> list[str]:
    with closing(sqlite3.connect(case)) as connection:
        return list(connection.iterdump())
