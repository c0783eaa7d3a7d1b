"""Rigs and plans from outside: whatever stands in the file ends in a value or in one printable sentence."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from scanner_core.acquisition.plan import read_plan
from scanner_core.devices.rig import dump_rig, load_preset, load_rig, parse_rig
from scanner_core.errors import UsageError
from scanner_core.toml_text import DEEPEST, LONGEST_BYTES, parse_toml

GOOD = dump_rig(load_preset("bench"))

NO_TOML = [
    (b"[" * 50_000, "line 1"),
    (b"a = " + b"[" * 50_000, "nested more than 16 deep"),
    (b"a = " + b"{b=" * 50_000, "nested more than 16 deep"),
    (b"a = " + b"[" * (DEEPEST + 1) + b"]" * (DEEPEST + 1), "nested more than 16 deep"),
    (b"\n" + b"a." * 300_000 + b"a = 1", "line 2 has a key of more than 16 parts"),
    (b"a = 1\n[" + b"'b' . " * 100_000 + b"b]", "line 2 has a key of more than 16 parts"),
    (b"a = " + b"9" * 5000, ""),
    (b"a = 0x" + b"f" * 5000, "more than 64 bits"),
    (b"a = [[1], [99999999999999999999]]", "more than 64 bits"),
    (b"\xff\xfe\x00a", "no UTF-8 text (byte 1)"),
    (b"a = 'b\x00'", ""),
    (b"a = '\x1b[31m'", ""),
    (b"\xef\xbb\xbfa", ""),
    (bytes(range(256)), "no UTF-8 text"),
    (b"#" * (LONGEST_BYTES + 1), "1,000,000 are the limit"),
]


@pytest.mark.parametrize(("content", "reason"), NO_TOML, ids=range(len(NO_TOML)))
def test_what_is_no_toml_costs_one_sentence(tmp_path: Path, content: bytes, reason: str) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(content)
    for read, code in ((load_rig, "E-RIG-01"), (read_plan, "E-PLAN-01")):
        with pytest.raises(UsageError) as caught:
            read(path)
        assert caught.value.code == code
        assert reason in str(caught.value)
        assert str(caught.value).isprintable()
        assert len(str(caught.value)) < 600


def test_a_byte_order_mark_and_dotted_numbers_are_fine() -> None:
    assert parse_toml("a.b.c = 1.5\nd = '1.2.3.4.5.6'\n") == {"a": {"b": {"c": 1.5}}, "d": "1.2.3.4.5.6"}


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes(b"\xef\xbb\xbf" + GOOD.encode())
    assert dump_rig(load_rig(tmp_path / "a.toml")) == GOOD


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_pipes_and_folders_are_no_rigs(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.toml")
    (tmp_path / "folder.toml").mkdir()
    for name in ("pipe", "folder"):  # and nobody waits for a writer
        with pytest.raises(UsageError, match="it is no file"):
            load_rig(tmp_path / f"{name}.toml")
        with pytest.raises(UsageError, match="it is no file"):
            read_plan(tmp_path / f"{name}.toml")


CHANGES = [
    ('name = "bench"', "name = 5", "'name' must be a line"),
    ('name = "bench"', 'name = "a\\u001b[31m"', "'name' must be a line"),
    ("exposure_ms = 12.0", "exposure_ms = inf", "'exposure_ms' must be a number from"),
    ("exposure_ms = 12.0", "exposure_ms = true", "'exposure_ms' must be a number from"),
    ("baud = 115200", "baud = 1e5", "'baud' must be a whole number"),
    ("baud = 115200", "baud = 9223372036854775807", "'baud' must be a whole number"),
    ("baud = 115200", "velocity = 1", "in [controller] the key 'velocity' is unknown, known are"),
    ('port = "virtual://bench"', "port = 3", "'port' must be a line"),
    ('port = "virtual://bench"', 'port = "spy://COM3?file=/tmp/x"', "'port' must be a serial device"),
    ('port = "virtual://bench"', 'port = "alt://COM3?class=Serial"', "'port' must be a serial device"),
    ('table_axis = "Z"', 'table_axis = "Z1 M3"', "'table_axis' must be the letter"),
    ("gain_db = 0.0", "gain_db = nan", "'gain_db' must be a number"),
    ("radius_mm = ", "radius_mm = -inf # ", "'radius_mm' must be a number"),
    ('table_axis = "Z"', 'table_axis = "Q"', "in [controller] 'table_axis' must be the letter of an axis, one of X Y Z"),
    ('driver = "virtual"', 'driver = "opencvv"', "in [camera.left] 'driver' must be one of opencv, basler, replay, virtual, not 'opencvv'"),
    ('driver = "grbl"', 'driver = "gbrl"', "in [controller] 'driver' must be grbl, not 'gbrl'"),
    ('trigger = "free"', 'trigger = "hardwre"', "in [camera.left] 'trigger' must be one of free, software, hardware, not 'hardwre'"),
    ("gain_db = 0.0\n", "", "the key 'gain_db' of [camera.left] is missing"),
    ("[camera.right]", "[camera.rihgt]", "in [camera] the key 'rihgt' is unknown; is 'right' meant"),
    ('port = "virtual://bench"', 'port = ""', "in [controller] 'port' is empty"),
    ("x_deg = ", "table_dge = [-400.0, 400.0]\nx_deg = ", "in [limits] the key 'table_dge' is unknown; is 'table_deg' meant"),
    ("spot_diameter_mm", "spot_diamter_mm", "in [laser] the key 'spot_diamter_mm' is unknown"),
    ('name = "bench"\n', 'name = "bench"\nvitrual = "bench"\n', "the key 'vitrual' is unknown; is 'virtual' meant"),
    ("[volume]", "[[volume]]", "'volume' must be a table"),
    ("[laser]", "[lasers]", "the key 'lasers' is unknown; is 'laser' meant"),
    ("dominance = 4.0", "dominance = nan", "'dominance' must be a number"),
    ("dominance = 4.0", "dominance = 0", "'dominance' of the spot detector is 0"),
    ("dominance = 4.0", "domination = 4.0", "the key 'domination' is unknown; is 'dominance' meant"),
    ("size_px = [604, 294]", "size_px = [1000000000, 1000000000]", "from 1 to 20000 pixels"),
    ("size_px = [604, 294]", "size_px = [604]", "'size_px' must be 2 finite numbers"),
    ("date = ", "date = 5 #", "'date' must be a line"),
]


@pytest.mark.parametrize(("old", "new", "reason"), CHANGES, ids=[new for _, new, _ in CHANGES])
def test_a_value_of_the_wrong_kind_is_named(old: str, new: str, reason: str) -> None:
    assert old in GOOD
    with pytest.raises(UsageError) as caught:
        parse_rig(GOOD.replace(old, new, 1), "a\\b")
    assert caught.value.code == "E-RIG-01"
    assert reason in str(caught.value)
    assert str(caught.value).isprintable()


@pytest.mark.parametrize(
    "said",
    ["views = true", "points = 1e4", "object_radius_mm = nan", "object_height_mm = inf", "smallest_part_mm = -1", '"\\u001b" = 1'],
)
def test_a_plan_with_other_values_is_refused(tmp_path: Path, said: str) -> None:
    (tmp_path / "plan.toml").write_text(said)
    with pytest.raises(UsageError) as caught:
        read_plan(tmp_path / "plan.toml")
    assert str(caught.value).isprintable()


def test_what_a_rig_may_hold_is_written_so_that_it_is_read_again() -> None:
    rig = parse_rig(GOOD.replace('name = "bench"', "name = 'a \\ \"b\" \u00e4'"), "here")
    assert parse_rig(dump_rig(rig), "there").name == rig.name == 'a \\ "b" \u00e4'
