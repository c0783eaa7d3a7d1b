"""A person who is asked for the artefacts of ``verify``."""

from __future__ import annotations

import io
import sys

import numpy as np
import pytest

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands.artefacts_by_hand import PersonArtefacts, operator_at_terminal
from scanner_core.commands.console import Console
from scanner_core.devices.rig import load_preset


def test_each_artefact_is_asked_for_with_its_place_and_awaited(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("\n\n\n\n"))
    person = PersonArtefacts(Console(as_json=False))
    person.put_plate(np.array([0.0, -1.6, 25.0]), np.array([1.0, 0.0, 0.0]))
    person.put_sphere(0)
    person.put_sphere(1)
    person.put_bar(np.array([[-40.0, 0.0, 20.0], [40.0, 0.0, 20.0]]), 11.0)
    told = capsys.readouterr().err.splitlines()
    assert "plate" in told[0]
    assert "x 0, y -2 mm from the table's middle, 25 mm above it" in told[0]
    assert "anew" in told[2]
    assert "x -40, y 0" in told[3]
    with pytest.raises(KeyboardInterrupt):
        person.put_sphere(2)  # the terminal is gone


def test_nobody_is_asked_where_nothing_stands_on_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.stdin, "isatty", lambda: True, raising=False)
    console = Console(as_json=False)
    with open_rig(load_preset("bench")) as rig:
        assert operator_at_terminal(rig, console) is None
        rig.bench = None
        assert isinstance(operator_at_terminal(rig, console), PersonArtefacts)
        monkeypatch.setattr(sys.stdin, "isatty", lambda: False, raising=False)
        assert operator_at_terminal(rig, console) is None
