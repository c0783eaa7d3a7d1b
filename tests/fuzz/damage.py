"""Damaged files: good ones of which pieces are cut, changed, repeated or replaced, as a strategy of hypothesis."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import strategies as st

LONGEST_INPUT = 65_536
_FAULT_BYTES = 6


def damaged_files(samples: Sequence[bytes], words: Sequence[bytes]) -> st.SearchStrategy[bytes]:
    """Good files with up to six faults, and now and then noise; at most :data:`LONGEST_INPUT` bytes.

    All choices come from one draw of bytes: a draw for each would cost more than most readers do.
    """
    return st.binary(min_size=2, max_size=2 + 6 * _FAULT_BYTES).map(lambda choices: _damaged(samples, words, choices))


def _damaged(samples: Sequence[bytes], words: Sequence[bytes], choices: bytes) -> bytes:
    if choices[0] >= 250:
        return choices[1:]
    content = samples[choices[0] % len(samples)]
    for begin in range(1, len(choices) - _FAULT_BYTES + 1, _FAULT_BYTES):
        kind, high, low, size, *values = choices[begin : begin + _FAULT_BYTES]
        content = fault(content, kind, (256 * high + low) / 65_536, size, bytes(values), words)
    return content[:LONGEST_INPUT]


def fault(content: bytes, kind: int, place: float, size: int, values: bytes, words: Sequence[bytes]) -> bytes:
    """`content` with one fault at `place` (0 to 1 of its length): a cut, a flip of bits, a word, a gap or a repetition."""
    at = int(place * len(content))
    word = words[size % len(words)]
    match kind % 8:
        case 0:
            return content[:at]
        case 1:
            return content[:at] + word + content[at:]
        case 2:
            return content[:at] + word + content[at + len(word) :]
        case 3:
            return content[:at] + content[at + size :]
        case 4:
            return content[:at] + content[at : at + 1 + size // 4] * (1 + values[0] // 4) + content[at:]
        case 5:
            return content[:at] + content[int(values[0] / 256 * len(content)) :][: 1 + size] + content[at:]
        case 6:
            return content[:at] + values + content[at + len(values) :]
        case _:
            return content[:at] + bytes(a ^ (1 << size % 8) for a in content[at : at + 1]) + content[at + 1 :]
