"""Bytes in any portions in, whole lines out."""

from __future__ import annotations

LONGEST_LINE = 512
"""GRBL's longest line is a status report of about 120 characters; what runs on longer is noise and is cut."""


class LineBuffer:
    """Collects bytes until a line is complete."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def feed(self, chunk: bytes) -> list[str]:
        """The lines that `chunk` completes, without line ends and without empty lines."""
        self._bytes += chunk
        if b"\n" not in chunk and len(self._bytes) <= LONGEST_LINE:
            return []
        *whole, rest = self._bytes.split(b"\n")
        while len(rest) > LONGEST_LINE:
            whole.append(rest[:LONGEST_LINE])
            rest = rest[LONGEST_LINE:]
        self._bytes = bytearray(rest)
        lines = [line.decode("ascii", errors="replace").strip("\r\x00 \t") for line in whole]
        return [line for line in lines if line]

    @property
    def unfinished(self) -> str:
        """What has come of a line that is not complete."""
        return self._bytes.decode("ascii", errors="replace")

    def clear(self) -> None:
        self._bytes.clear()
