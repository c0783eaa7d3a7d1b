"""What the window keeps beside a rig file is not used by commands, and they say so."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path

from scanner_core.commands.scanning import aimed_elsewhere


def test_settings_of_the_window_beside_a_rig_file_are_told(tmp_path: Path) -> None:
    rig = tmp_path / "lab.toml"
    assert aimed_elsewhere(Namespace(rig=str(rig), replay=None)) is None
    (tmp_path / "lab.aim.toml").touch()
    assert "lab.aim.toml) is not used by commands" in (aimed_elsewhere(Namespace(rig=str(rig), replay=None)) or "")
    assert aimed_elsewhere(Namespace(rig="bench", replay=None)) is None
    assert aimed_elsewhere(Namespace(rig=None, replay="recording")) is None
