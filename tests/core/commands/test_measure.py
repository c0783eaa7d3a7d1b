"""``impronta measure`` on a body whose sizes are known."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from scanner_core.__main__ import main
from scanner_core.mesh_io import write_mesh
from tests.core.geometry.solids import sphere


def test_a_ball_is_measured_and_so_is_a_section(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_mesh(tmp_path / "ball.stl", sphere(10.0, 80, 40))
    assert main(["measure", str(tmp_path / "ball.stl"), "--height", "6", "--json"]) == 0
    values = json.loads(capsys.readouterr().out)
    assert values["volume_mm3"] == pytest.approx(4000 / 3 * np.pi, rel=0.01)
    assert values["section_mm2"] == pytest.approx(64 * np.pi, rel=0.01)
    assert values["section_perimeter_mm"] == pytest.approx(16 * np.pi, rel=0.01)
    assert main(["measure", str(tmp_path / "ball.stl"), "--height", "60"]) == 0
    assert "does not meet" in capsys.readouterr().out
