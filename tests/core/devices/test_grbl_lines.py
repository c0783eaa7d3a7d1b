"""The line parser and the byte buffer: typed values from good lines, no exception from any."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.devices.grbl.line_buffer import LONGEST_LINE, LineBuffer
from scanner_core.devices.grbl.lines import Alarm, Banner, Feedback, Ok, Other, Refusal, Report, Setting, parse_line
from scanner_core.devices.motion import MotionState


def test_grbl_status_report() -> None:
    line = parse_line("<Run|MPos:1.000,-2.500,90.000|FS:600,1000|WCO:0.000,0.000,1.000|Ov:100,100,100>")
    assert line == Report(MotionState.MOVING, 0, (1.0, -2.5, 90.0), (0.0, 0.0, 1.0), False, 600.0, 1000.0)


@pytest.mark.parametrize(
    ("text", "state", "substate"),
    [
        ("<Idle|MPos:0,0,0>", MotionState.IDLE, 0),
        ("<Hold:1|FS:0,0>", MotionState.HOLD, 1),
        ("<Door:3>", MotionState.DOOR, 3),
        ("<Jog|F:20>", MotionState.MOVING, 0),
        ("<Home|WPos:1,2,3,4>", MotionState.HOMING, 0),
        ("<Alarm|Pn:XYZ|MPos:nan,0,0>", MotionState.ALARM, 0),
        ("<Tool>", MotionState.UNKNOWN, 0),
    ],
)
def test_states_with_any_fields_in_any_order(text: str, state: MotionState, substate: int) -> None:
    line = parse_line(text)
    assert isinstance(line, Report)
    assert (line.state, line.substate) == (state, substate)


def test_fields_that_are_missing_or_broken_are_none() -> None:
    line = parse_line("<Idle|MPos:1.0,oops,2|FS:>")
    assert line == Report(MotionState.IDLE, 0, None, None, False, None, None)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("ok", Ok()),
        ("error:9", Refusal(9)),
        ("ALARM:3", Alarm(3)),
        ("Grbl 1.1h ['$' for help]", Banner("Grbl 1.1h ['$' for help]")),
        ("GrblHAL 1.1f ['$' or '$HELP' for help]", Banner("GrblHAL 1.1f ['$' or '$HELP' for help]")),
        ("$32=1", Setting(32, 1.0)),
        ("$110=12000.000 (x max rate)", Setting(110, 12000.0)),
        ("[MSG:Caution: Unlocked]", Feedback("MSG:Caution: Unlocked")),
        ("Marlin 2.0", Other("Marlin 2.0")),
        ("error:", Other("error:")),
        ("$32=1-1", Other("$32=1-1")),
        ("<>", Other("<>")),
    ],
)
def test_lines(text: str, line: object) -> None:
    assert parse_line(text) == line


@given(st.text(max_size=200))
def test_no_line_raises(text: str) -> None:
    parse_line(text)


@given(st.text(alphabet="<>|:,.-0123456789MPosWCFSIdleRunAlarm[]$=ok error\r", max_size=80))
def test_nothing_that_looks_like_grbl_gives_numbers_that_are_none(text: str) -> None:
    line = parse_line(text)
    if isinstance(line, Report):
        for values in (line.position or (), line.work_offset or (), (line.feed_deg_min or 0.0, line.laser_power or 0.0)):
            assert all(math.isfinite(value) for value in values)


@given(st.lists(st.text(alphabet="abc<>|:0123 ", max_size=30)), st.data())
def test_lines_survive_any_cutting(lines: list[str], data: st.DataObject) -> None:
    sent = "".join(f"{line}\r\n" for line in lines).encode("ascii")
    cuts = sorted(data.draw(st.lists(st.integers(0, len(sent)), max_size=8)))
    buffer, got = LineBuffer(), []
    for start, end in zip([0, *cuts], [*cuts, len(sent)], strict=True):
        got += buffer.feed(sent[start:end])
    assert got == [line.strip() for line in lines if line.strip()]


@given(st.lists(st.binary(max_size=2000), max_size=5))
def test_the_buffer_stays_bounded(chunks: list[bytes]) -> None:
    buffer = LineBuffer()
    for chunk in chunks:
        for line in buffer.feed(chunk):
            parse_line(line)
    assert len(buffer.unfinished) <= LONGEST_LINE
