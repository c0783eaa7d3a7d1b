from __future__ import annotations

import json
from pathlib import Path

from app.settings import Settings, load_settings, save_settings


def test_settings_come_back_as_they_were_kept(tmp_path: Path) -> None:
    path = tmp_path / "deep" / "settings.json"
    kept = Settings(specimen="heart", recent_cases=["a.impronta"], window=[1000, 700])
    save_settings(kept, path)
    assert load_settings(path) == kept


def test_a_damaged_file_is_set_aside_and_the_program_starts(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    path.write_text('{"speed": "5", ')
    assert load_settings(path) == Settings()
    assert (tmp_path / "settings.json.damaged").exists()
    assert not path.exists()


def test_unknown_keys_wrong_types_and_a_newer_version_are_tolerated(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    path.write_text(json.dumps({"version": 99, "later": 1, "speed": 5, "specimen": "arch", "recent_cases": [1, 2], "window": ["a", "b"]}))
    settings = load_settings(path)
    assert settings == Settings(specimen="arch")


def test_a_folder_that_cannot_be_written_stops_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    save_settings(Settings(), tmp_path / "file" / "settings.json")
