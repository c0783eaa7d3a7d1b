"""What guardian and program say to each other over two pipes.  Standard library only.

A frame is one letter, the length of its content (32 bit, big endian), and the content.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator

BYTES = b"D"
"""Bytes for the port, or from it."""
HEARTBEAT = b"H"
"""The program is there."""
QUIT = b"Q"
"""The program is done: laser off, release the port."""
OPENED = b"O"
"""The port is open."""
REFUSED = b"R"
"""The port did not open; content: kind of fault, newline, details."""
LOST = b"L"
"""The port went away; content: details."""
TRIPPED = b"T"
"""The laser was switched off and the port released; content: why."""

_HEADER = struct.Struct(">cI")
_READ_SIZE = 65536


def write_frame(fd: int, kind: bytes, content: bytes = b"") -> None:
    """Write a whole frame; one writer at a time."""
    frame = memoryview(_HEADER.pack(kind, len(content)) + content)
    while frame:
        frame = frame[os.write(fd, frame) :]


def read_frames(fd: int) -> Iterator[tuple[bytes, bytes]]:
    """Frames as they come, until the other end closes."""
    pending = bytearray()
    while chunk := os.read(fd, _READ_SIZE):
        pending += chunk
        while len(pending) >= _HEADER.size:
            kind, length = _HEADER.unpack_from(pending)
            end = _HEADER.size + length
            if len(pending) < end:
                break
            yield kind, bytes(pending[_HEADER.size : end])
            del pending[:end]
