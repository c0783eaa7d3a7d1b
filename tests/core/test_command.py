"""The command decides between the window and a headless subcommand before anything of Qt is imported."""

from __future__ import annotations

import sys
from types import ModuleType

import pytest

import app.__main__ as command


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, list[str]]]:
    seen: list[tuple[str, list[str]]] = []
    for module, function, name in (("app.main", "run_window", "window"), ("scanner_core.__main__", "main", "headless")):
        stand_in = ModuleType(module)
        setattr(stand_in, function, lambda arguments, name=name: seen.append((name, list(arguments))) or 0)
        monkeypatch.setitem(sys.modules, module, stand_in)
    return seen


@pytest.mark.parametrize(
    ("arguments", "where"),
    [
        ([], "window"),
        (["order 7.impronta"], "window"),
        (["--settings", "mine.json"], "window"),
        (["demo", "--json"], "headless"),
        (["info", "order 7.impronta"], "headless"),
        (["--version"], "headless"),
        (["-h"], "headless"),
        (["nonsense"], "headless"),
    ],
)
def test_where_arguments_lead(calls: list[tuple[str, list[str]]], arguments: list[str], where: str) -> None:
    assert command.main(arguments) == 0
    assert calls == [(where, arguments)]


def test_without_arguments_those_of_the_process_count(calls: list[tuple[str, list[str]]], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["impronta", "doctor"])
    assert command.main() == 0
    assert calls == [("headless", ["doctor"])]
