"""The history of a rig survives crashes and tells a drift from scatter."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.devices.rig import load_preset
from scanner_core.errors import StorageError
from scanner_core.metrology.history import HistoryEntry, append_history, history_path, last_reference_sphere, read_history, rig_sha256

ENTRY = HistoryEntry(
    date="2026-03-01T10:00:00+01:00",
    test="sphere",
    figures={"size": -4.0, "dispersion": 120.0},
    uncertainties={"size": 3.0, "dispersion": 4.0},
    limits={"size": 15.0, "dispersion": 160.0},
    verdict="pass",
    calibration_id="8f12",
    calibration_date="2026-02-01",
    rig_sha256="ab",
    seed=0,
)


def _on(day: int, size: float) -> HistoryEntry:
    return replace(ENTRY, date=f"2026-03-{day:02d}T10:00:00+01:00", figures={"size": size, "dispersion": 120.0})


def test_what_was_appended_comes_back_in_the_order_of_dates(tmp_path: Path) -> None:
    path = tmp_path / "new" / "rig.history.jsonl"
    for day in (3, 1, 2):
        append_history(path, _on(day, float(day)))
    append_history(path, replace(ENTRY, test="static"))
    assert [entry.figures["size"] for entry in read_history(path, "sphere")] == [1, 2, 3]
    assert len(read_history(path)) == 4
    assert read_history(tmp_path / "none.jsonl") == []


def test_a_line_that_a_crash_cut_off_hurts_neither_what_stands_nor_what_follows(tmp_path: Path) -> None:
    path = tmp_path / "rig.history.jsonl"
    append_history(path, _on(1, 1.0))
    whole = path.read_bytes()
    for cut in (1, 20, len(whole) - 2):
        path.write_bytes(whole + whole[:cut])
        append_history(path, _on(2, 2.0))
        assert [entry.figures["size"] for entry in read_history(path)] == [1, 2]


@pytest.mark.parametrize("line", ["[]", "3", '{"date": "x"}', "\xff\xfe", '{"a": 1}'])
def test_strange_lines_are_left_out(tmp_path: Path, line: str) -> None:
    path = tmp_path / "rig.history.jsonl"
    path.write_text(line + "\n", encoding="latin-1")
    append_history(path, ENTRY)
    assert read_history(path) == [ENTRY]


def test_the_trend_tells_a_drift_from_scatter(tmp_path: Path) -> None:
    path = tmp_path / "rig.history.jsonl"
    assert last_reference_sphere(path) is None
    append_history(path, _on(1, -4.0))
    first = last_reference_sphere(path)
    assert first is not None
    assert first.size_change_um is None
    for day, size in ((2, -5.0), (3, -3.0), (4, -2.0)):
        append_history(path, _on(day, size))
    steady = last_reference_sphere(path)
    assert steady is not None
    assert steady.drifted is False
    append_history(path, _on(5, 3.0))
    drifted = last_reference_sphere(path)
    assert drifted is not None
    assert drifted.drifted is True
    assert drifted.size_change_um == pytest.approx(6.5)
    assert drifted.dispersion_um == 120.0


def test_a_sphere_without_its_figures_does_not_count(tmp_path: Path) -> None:
    path = tmp_path / "rig.history.jsonl"
    append_history(path, replace(_on(1, 0.0), figures={}))
    assert last_reference_sphere(path) is None
    append_history(path, _on(2, -4.0))
    append_history(path, replace(_on(3, 0.0), figures={"dispersion": 120.0}))
    found = last_reference_sphere(path)
    assert found is not None
    assert (found.size_um, found.size_change_um) == (-4.0, None)


def test_a_preset_s_history_lies_in_the_user_s_folder_and_a_file_s_beside_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path))
    assert tmp_path in history_path("bench").parents
    assert history_path(str(tmp_path / "mine.toml")) == tmp_path / "mine.history.jsonl"


def test_a_folder_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(StorageError):
        append_history(tmp_path / "file" / "rig.history.jsonl", ENTRY)


def test_the_hash_follows_the_rig() -> None:
    rig = load_preset("bench")
    assert rig_sha256(rig) == rig_sha256(load_preset("bench"))
    assert rig_sha256(rig) != rig_sha256(replace(rig, name="other"))
