"""What the guides name exists (codes, commands, options, keys, pages), and their figures are those of the formulas."""

from __future__ import annotations

import argparse
import math
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from scanner_core.__main__ import _parser
from scanner_core.devices.camera_config import CameraConfig, TriggerSource
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.laser_config import LaserConfig
from scanner_core.devices.rig import LimitsConfig, VolumeConfig, load_preset, parse_rig, rig_text
from scanner_core.sentences import SENTENCES

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
TABLES = {
    "camera": set(CameraConfig.__dataclass_fields__) - {"name"},
    "controller": set(ControllerConfig.__dataclass_fields__),
    "limits": set(LimitsConfig.__dataclass_fields__),
    "laser": set(LaserConfig.__dataclass_fields__),
    "volume": set(VolumeConfig.__dataclass_fields__),
}


def _text(page: Path) -> str:
    return page.read_text(encoding="utf-8")


def _subparsers() -> dict[str, argparse.ArgumentParser]:
    action = next(action for action in _parser()._actions if isinstance(action, argparse._SubParsersAction))
    return dict(action.choices)


def _options(parser: argparse.ArgumentParser) -> set[str]:
    found = set(parser._option_string_actions)
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            found |= {option for inner in action.choices.values() for option in _options(inner)}
    return found


def _commands(text: str) -> Iterator[str]:
    yield from re.findall(r"`impronta ([^`]+)`", text)
    yield from re.findall(r"^    impronta (.+)$", text, re.MULTILINE)


def test_the_pages_are_there() -> None:
    assert [page.stem for page in PAGES] == ["build", "cameras", "delivery", "first-scan", "laser-safety", "window", "wiring"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_code_has_its_sentence(page: Path) -> None:
    assert set(re.findall(r"\b[EH]-[A-Z]{2,4}-\d\d\b", _text(page))) <= set(SENTENCES)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_command_has_its_options(page: Path) -> None:
    known = _subparsers()
    commands = list(_commands(_text(page)))
    assert commands
    for command in commands:
        name, *rest = command.split()
        assert name in known, command
        assert set(re.findall(r"(?<!\S)--[\w-]+", " ".join(rest))) <= _options(known[name]), command


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_key_of_a_rig_is_one(page: Path) -> None:
    """In the examples, and everything in code that looks like a key with its value."""
    table = ""
    for line in _text(page).splitlines():
        if found := re.fullmatch(r"    \[(\w+)(?:\.\w+)?\]", line):
            table = found[1]
            assert table in TABLES, line
        elif (found := re.match(r"    (\w+) = ", line)) and table:
            assert found[1] in TABLES[table], line
            tomllib.loads(line.strip())
        elif not line.startswith("    "):
            table = table if not line.strip() else ""
    inline = re.findall(r"`(\w+) = ", _text(page))
    assert set(inline) <= set().union(*TABLES.values())


def test_the_keys_of_a_camera_are_all_explained() -> None:
    text = _text(ROOT / "docs" / "cameras.md")
    explained = set(re.findall(r"`(\w+)`", " ".join(line for line in text.splitlines() if line.startswith("| `"))))
    assert TABLES["camera"] <= explained
    assert set(TriggerSource) <= explained


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_link_leads_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)#]+)(?:#[\w-]+)?\)", _text(page)):
        assert (page.parent / target).exists(), target


def test_the_examples_make_a_rig() -> None:
    """The pieces of the pages, put into a preset's text in their places, are a rig that can be read."""
    blocks = "\n".join(_text(ROOT / "docs" / name) for name in ("first-scan.md", "wiring.md"))
    text = rig_text("bench")
    for table in ("camera.left", "camera.right", "laser", "volume", "controller", "limits"):
        block = re.search(rf"^    \[{re.escape(table)}\]\n((?:    .+\n)+)", blocks, re.MULTILINE)
        assert block is not None, table
        ours = re.sub(r"^    ", "", block[1], flags=re.MULTILINE)
        text = re.sub(rf"(?m)^\[{re.escape(table)}\]\n(?:(?!\[).*\n)*", lambda _, ours=ours, table=table: f"[{table}]\n{ours}\n", text)
    rig = parse_rig(text.replace('virtual = "bench"\n', ""), "guide")
    assert rig.virtual is None
    assert rig.controller.units_per_deg[2] < 0
    assert rig.limits.table_deg is not None


def test_the_table_of_geometry_follows_its_formulas() -> None:
    rows = 0
    focal = (0.0, 0.0)
    for line in _text(ROOT / "docs" / "build.md").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) != 7 or not cells[1].isdigit():
            continue
        if cells[0]:
            width, height = map(int, re.findall(r"\d+", cells[0])[:2])
            named = re.search(r"fx = fy = (\d+)", cells[0]) or re.search(r"fx = (\d+)", cells[0])
            both = re.search(r"fx (\d+), fy (\d+)", cells[0])
            focal = (float(both[1]), float(both[2])) if both else (float(named[1]),) * 2 if named else focal
        fx, fy = focal
        r_mm, a = float(cells[1]), math.radians(float(cells[2]))
        assert [int(n) for n in re.findall(r"\d+", cells[3])] == [round(width * r_mm / fx), round(height * r_mm / fy)]
        assert [int(n) for n in re.findall(r"\d+", cells[4])] == [round(1000 * r_mm / fx), round(1000 * r_mm / fy)]
        for cell, s in ((cells[5], 1 / 45), (cells[6], 0.01)):
            parts = (fx * math.cos(a), fy, fx * math.sin(a))
            wanted = [1000 * r_mm * s / (part * math.sqrt(2)) for part in parts]
            assert [float(n) for n in cell.split("/")] == pytest.approx(wanted, abs=0.051)
        rows += 1
    assert rows == 7


def test_the_table_of_movers_follows_its_formula() -> None:
    rows = re.findall(r"^\| ((?:mirror|pan and tilt|geared).+?) \| ([\d.]+) \| ([\d.]+) \|$", _text(ROOT / "docs" / "build.md"), re.MULTILINE)
    assert len(rows) == 6
    for build, steps, shown_mm in rows:
        turn, microsteps = (float(re.search(rf"(\d+) {word}", build)[1]) for word in ("steps", "microsteps"))
        belt, gear = re.search(r"(\d+):(\d+)", build), re.search(r"([\d.]+):1", build)
        ratio = float(gear[1]) if gear and "geared" in build else float(belt[2]) / float(belt[1]) if belt else 1.0
        per_deg = turn * microsteps * ratio / 360 / (2 if "mirror" in build else 1)
        assert float(steps) == pytest.approx(per_deg, rel=0.006)
        assert float(shown_mm) == pytest.approx(450 * math.tan(math.radians(1 / per_deg)), abs=0.006)


def test_the_bounds_of_the_laser_are_those_of_the_state_machine() -> None:
    from scanner_core.devices import laser_safety

    guide, told = _text(ROOT / "docs" / "laser-safety.md"), laser_safety.__doc__ or ""
    for event, here in (
        ("stop, Esc, cancel", "stop button, Esc, cancel"),
        ("owner's thread hung", "the scan's own thread hangs"),
        ("lid opened",) * 2,
    ):
        bound = re.search(rf"^{event} +([\d.]+) s", told, re.MULTILINE)
        shown = re.search(rf"^\| {here} \| ([\d.]+) s", guide, re.MULTILINE)
        assert bound is not None
        assert shown is not None
        assert bound[1] == shown[1]
    assert f"{laser_safety.STANDING_LASER_S:.0f} s at most" in guide


def test_the_presets_limits_are_the_settings_that_are_advised() -> None:
    limits, wiring = load_preset("bench").limits, _text(ROOT / "docs" / "wiring.md")
    assert f"{60 * limits.travel_speed_deg_s:.0f}, {60 * limits.travel_speed_deg_s:.0f}, {60 * limits.table_speed_deg_s:.0f}" in wiring
