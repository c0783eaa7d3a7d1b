"""What the parsers of this folder say of a file's bytes, and the checks that they share.

A parser takes bytes and returns arrays.  Nothing in a file is believed: every count is compared with the bytes that
are there before anything of that size is made.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.one_line import one_line

FARTHEST_MM = 1e9
"""Coordinates beyond this are damage, not places; within it, volumes stay finite."""


class MalformedError(ValueError):
    """What is wrong in a file, and where: half a sentence that fits behind 'no mesh that can be read:'."""

    def __init__(self, reason: str) -> None:
        super().__init__(one_line(reason))


def line_of(text: bytes, position: int) -> int:
    """The line, from 1, of a position in a text."""
    return text.count(b"\n", 0, position) + 1


def shown(text: bytes, most: int = 24) -> str:
    """A piece of a hostile file, fit to be printed."""
    piece = text[:most].decode("ascii", "replace").replace("\ufffd", "?")
    return "'" + "".join(c if c.isprintable() else "?" for c in piece) + ("..." if len(text) > most else "") + "'"


def checked_vertices(points: NDArray[np.floating]) -> NDArray[np.float64]:
    """Coordinates as float64, (n, 3); MalformedError for one that is not finite or absurdly far away."""
    with np.errstate(invalid="ignore", over="ignore"):
        vertices = np.array(points, np.float64).reshape(-1, 3)
        wrong = ~(np.abs(vertices) <= FARTHEST_MM).all(axis=1)
    if wrong.any():
        row = int(np.argmax(wrong))
        place = ", ".join(f"{value:g}" for value in vertices[row])
        raise MalformedError(f"{int(wrong.sum())} points are not finite or impossibly far away, first point {row + 1} of {len(vertices)} ({place})")
    return vertices


def checked_triangles(triangles: NDArray[np.integer], vertex_count: int) -> NDArray[np.int64]:
    """Triangles as int64, (t, 3), without those that name a vertex twice; MalformedError for one that names a vertex
    that is not there."""
    wide = np.asarray(triangles).reshape(-1, 3)
    wrong = ((wide < 0) | (wide >= vertex_count)).any(axis=1)
    if wrong.any():
        row = int(np.argmax(wrong))
        named = wide[row][(wide[row] < 0) | (wide[row] >= vertex_count)][0]
        raise MalformedError(f"triangle {row + 1} of {len(wide)} names the vertex {named}, but there are {vertex_count} vertices (counted from 0)")
    good = wide.astype(np.int64)
    a, b, c = good.T
    return np.asarray(good[(a != b) & (b != c) & (c != a)], np.int64)
