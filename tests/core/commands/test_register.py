"""``impronta register`` and ``impronta scan --add-mount``: what they say, and with which exit code."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from scanner_core.__main__ import main
from scanner_core.case.store import CaseStore
from scanner_core.commands.register import read_picks
from scanner_core.errors import InputFileError
from tests.core.case.test_mounts import TRUE, _scan


@pytest.fixture
def case(tmp_path: Path) -> Path:
    with CaseStore.create(tmp_path / "a.impronta") as store:
        _scan(store, 0, 1)
        return store.path


def test_one_mount_alone_is_nothing_to_register(case: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["register", str(case)]) == 2
    assert "holds no second mount" in capsys.readouterr().err


def test_picked_points_join_a_mount_and_the_case_tells_it(case: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with CaseStore.open(case) as store:
        _scan(store, 1, 2)
    own = np.array([[10.0, 0, 20], [0, 11, 25], [-9, 2, 14], [2, -10, 28]])
    lines = [f"1, {', '.join(f'{v:.2f}' for v in (*here, *there))}" for here, there in zip(own, TRUE.apply(own), strict=True)]
    pairs = tmp_path / "pairs.csv"
    pairs.write_text("# mount, x, y, z, x, y, z\n" + "\n".join(lines) + "\n", encoding="utf-8")
    code = main(["register", str(case), "--pairs", str(pairs), "--json"])
    told = json.loads(capsys.readouterr().out)["mounts"]
    assert code == 0
    assert told["joined"] == [0, 1]
    assert told["mounts"][1]["start"] == "picked"
    found = np.array(told["mounts"][1]["transform"])
    assert np.abs(found - TRUE.matrix()).max() < 0.06
    assert main(["info", str(case)]) == 0
    assert "Mount 1: joined" in capsys.readouterr().out
    points = tmp_path / "points.xyz"
    assert main(["export", str(case), "--out", str(points)]) == 0
    assert len(np.loadtxt(points)) > 2000


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "no point"),
        ("1 2 3", "3 numbers instead of 7"),
        ("1,2,3,4,5,6,x", "no number"),
        ("1.5 2 3 4 5 6 7", "no number"),
        ("1 2 3 4 5 6 nan", "not finite"),
    ],
)
def test_a_malformed_file_of_picks_is_said_with_its_line(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "pairs.txt"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputFileError, match=reason):
        read_picks(path)


def test_picks_may_be_separated_as_tables_are(tmp_path: Path) -> None:
    path = tmp_path / "pairs.txt"
    path.write_text("1;1;2;3;4;5;6\n2 1 2 3 4 5 6  # the tip\n1,7,8,9,1,2,3\n", encoding="utf-8")
    picks = read_picks(path)
    assert sorted(picks) == [1, 2]
    assert picks[1][0].tolist() == [[1, 2, 3], [7, 8, 9]]
    assert picks[1][1].tolist() == [[4, 5, 6], [1, 2, 3]]


@pytest.mark.parametrize("option", ["--resume", "--force"])
def test_another_mount_is_a_new_scan_in_a_case_that_is_there(case: Path, option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scan", "--rig", "bench", "--add-mount", option, "--out", str(case)]) == 2
    assert "Another mount is a new scan" in capsys.readouterr().err


def test_a_mount_of_no_case_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scan", "--rig", "bench", "--add-mount", "--out", str(tmp_path / "none.impronta")]) == 1
    assert "E-CASE-04" in capsys.readouterr().err
