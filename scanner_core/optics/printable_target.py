"""The calibration board as a page: a vector PDF at true scale, with a ruler that shows whether the printer kept it.

Drawn with matplotlib's PDF backend without pyplot, a figure of exactly the paper's size, every coordinate in millimetres.
The chessboard's black squares and the markers' black cells are filled rectangles; cells that touch are one rectangle, so that no
hairline shows between them.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.errors import UsageError
from scanner_core.optics.board import CharucoTarget

PAPERS_MM = {"a4": (297.0, 210.0), "letter": (279.4, 215.9), "a3": (420.0, 297.0)}
"""Width and height, landscape."""
RULER_MM = 200.0
_EDGE_MM = 5.0
"""Printers leave a border of some millimetres white."""
_RULER_ROOM_MM = 20.0
_MM_PER_INCH = 25.4
_MM_PER_POINT = _MM_PER_INCH / 72


def write_target(path: Path, target: CharucoTarget, paper: str = "a4") -> None:
    """Write the page.

    Raises
    ------
    UsageError
        E-USE-01 for an unknown paper, or one on which the board does not fit.
    """
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.collections import PatchCollection
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

    if paper not in PAPERS_MM:
        raise UsageError("E-USE-01", what=f"There is no paper '{paper}'", do=f"choose one of {', '.join(PAPERS_MM)}")
    (width, height), (board_width, board_height) = PAPERS_MM[paper], target.size_mm
    if board_width > width - 2 * _EDGE_MM or board_height > height - 2 * _EDGE_MM - _RULER_ROOM_MM:
        what = f"The board of {board_width:g} x {board_height:g} mm does not fit on {paper}"
        raise UsageError("E-USE-01", what=what, do="choose a larger paper")
    figure = Figure(figsize=(width / _MM_PER_INCH, height / _MM_PER_INCH))
    FigureCanvasPdf(figure)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_xlim(0, width)
    axes.set_ylim(0, height)
    axes.axis("off")

    left, top = 0.5 * (width - board_width), height - _EDGE_MM - 0.5 * (height - 2 * _EDGE_MM - _RULER_ROOM_MM - board_height)
    cells = [Rectangle((left + x, top - y - h), w, h) for x, y, w, h in black_rectangles_mm(target)]
    axes.add_collection(PatchCollection(cells, facecolor="black", edgecolor="none", linewidth=0))

    start, line = 0.5 * (width - RULER_MM), _EDGE_MM + 13.0
    axes.plot([start, start + RULER_MM], [line, line], color="black", linewidth=0.15 / _MM_PER_POINT, solid_capstyle="butt")
    for tick in range(int(RULER_MM) + 1):
        length = 5.0 if tick % 10 == 0 else 3.5 if tick % 5 == 0 else 2.0
        axes.plot([start + tick] * 2, [line, line - length], color="black", linewidth=0.15 / _MM_PER_POINT, solid_capstyle="butt")
    words = (
        f"ChArUco {target.columns} x {target.rows}, squares of {target.square_mm:g} mm. Print at 100 % (no 'fit to page'); the ruler must measure "
        f"{RULER_MM:g} mm. Glue the page flat to a stiff plate.\n"
        f"With a caliper measure the row of {target.columns} squares, outer edge to outer edge ({board_width:g} mm), and give it as --print-width-mm."
    )
    axes.text(0.5 * width, _EDGE_MM + 3.0, words, ha="center", va="center", fontsize=2.2 / _MM_PER_POINT, family="DejaVu Sans")
    figure.savefig(path, format="pdf", metadata={"Title": "Impronta calibration target", "CreationDate": None})


def black_rectangles_mm(target: CharucoTarget) -> list[tuple[float, float, float, float]]:
    """All that is black: x, y (down) of the upper left corner, width and height, mm, from the chessboard's upper left corner."""
    square, marker = target.square_mm, target.marker_mm
    black = [
        (column * square, row * square, square, square) for row in range(target.rows) for column in range(target.columns) if (row + column) % 2 == 0
    ]
    board = target.board()
    dictionary = board.getDictionary()
    cells = int(dictionary.markerSize) + 2  # with the marker's own black border
    for number, corners in zip(np.ravel(board.getIds()).tolist(), board.getObjPoints(), strict=True):
        left, top = np.reshape(corners, (4, 3)).min(axis=0)[:2].tolist()
        image: NDArray[np.uint8] = np.asarray(cv2.aruco.generateImageMarker(dictionary, number, cells), np.uint8)
        cell = marker / cells
        black += [(left + x * cell, top + y * cell, w * cell, h * cell) for x, y, w, h in _runs(image == 0)]
    return black


def _runs(black: NDArray[np.bool_]) -> list[tuple[int, int, int, int]]:
    """Black cells as few rectangles (column, row, width, height): runs along the rows, joined where they continue downwards."""
    done: list[tuple[int, int, int, int]] = []
    open_runs: dict[tuple[int, int], int] = {}
    for row in range(len(black) + 1):
        padded = np.r_[False, black[row], False] if row < len(black) else np.zeros(black.shape[1] + 2, bool)
        edges = np.flatnonzero(np.diff(padded.astype(np.int8)))
        runs = {(int(a), int(b)) for a, b in edges.reshape(-1, 2)}
        for run in [run for run in open_runs if run not in runs]:
            since = open_runs.pop(run)
            done.append((run[0], since, run[1] - run[0], row - since))
        for run in runs:
            open_runs.setdefault(run, row)
    return done
