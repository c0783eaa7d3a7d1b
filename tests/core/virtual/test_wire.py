"""The way of the controller's answers: in order, at their pace, and what may befall them."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from scanner_core.devices.grbl.line_buffer import LineBuffer
from scanner_core.devices.grbl.lines import Ok, parse_line
from scanner_core.virtual.wire import Wire

BYTE_S = 1e-4


def test_bytes_take_their_time_one_after_the_other() -> None:
    wire = Wire(BYTE_S, 0.0)
    wire.send(1.0, b"ok\r\n")
    wire.send(1.0, b"error:9\r\n")
    assert wire.next_s() == 1.0 + 4 * BYTE_S
    assert wire.receive(1.0 + 3 * BYTE_S) == b""
    assert wire.receive(1.0 + 4 * BYTE_S, 2) == b"ok"
    assert wire.waiting(2.0) == 2 + 9
    assert wire.receive(2.0) == b"\r\nerror:9\r\n"
    assert wire.next_s() == math.inf


@given(st.lists(st.sampled_from([b"ok\r\n", b"<Idle|MPos:0.000,0.000,22.500|FS:0,0>\r\n", b"ALARM:1\r\n"]), max_size=8), st.integers(1, 30))
def test_lines_in_pieces_lose_nothing_and_keep_their_order(chunks: list[bytes], size: int) -> None:
    wire = Wire(BYTE_S, 0.0)
    wire.break_lines(10.0, size, 0.02)
    for chunk in chunks:
        wire.send(1.0, chunk)
    buffer, lines, time_s = LineBuffer(), [], 1.0
    while wire.next_s() < math.inf:
        assert wire.next_s() >= time_s
        time_s = wire.next_s()
        piece = wire.receive(time_s)
        assert 0 < len(piece) <= size
        lines += buffer.feed(piece)
    assert lines == [chunk.decode().strip() for chunk in chunks]


def test_one_ok_is_lost_and_nothing_else() -> None:
    wire = Wire(BYTE_S, 0.0)
    wire.lose_ok()
    for chunk in (b"<Idle>\r\n", b"ok\r\n", b"ok\r\n"):
        wire.send(0.0, chunk)
    assert wire.receive(9.0) == b"<Idle>\r\nok\r\n"


def test_noise_makes_no_ok_and_ends_in_time() -> None:
    wire = Wire(BYTE_S, 0.0)
    wire.be_noisy(5.0, 0.05)
    for _ in range(4000):
        wire.send(1.0, b"<Run|MPos:1.250,0.500,22.500|FS:240,1000>\r\n")
    noisy = wire.receive(math.inf)
    assert 0.02 < 1 - noisy.count(b"<Run|MPos:1.250,0.500,22.500|FS:240,1000>\r\n") / 4000 < 0.95
    assert not any(isinstance(parse_line(line), Ok) for line in LineBuffer().feed(noisy))
    wire.send(6.0, b"ok\r\n")
    assert wire.receive(math.inf) == b"ok\r\n"
