"""The printed page, read back from the PDF's own drawing instructions."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import matplotlib
import numpy as np
import pytest

from scanner_core.errors import UsageError
from scanner_core.optics.board import CharucoTarget
from scanner_core.optics.board_detection import BoardView, detect_board
from scanner_core.optics.printable_target import PAPERS_MM, write_target

TARGET = CharucoTarget()
_MM = 25.4 / 72
_NUMBER = rb"(-?[\d.]+)"


def page(path: Path, paper: str) -> bytes:
    with matplotlib.rc_context({"pdf.compression": 0}):
        write_target(path, TARGET, paper)
    return path.read_bytes()


def quads_mm(pdf: bytes) -> np.ndarray:
    """Filled rectangles as left, bottom, right, top in mm, without the page's own background."""
    corner = _NUMBER + b" " + _NUMBER
    found = re.findall(corner + rb" m\n" + (corner + rb" l\n") * 3 + rb"h\n\s*f", pdf)
    points = np.array([[float(value) for value in quad] for quad in found]).reshape(-1, 4, 2) * _MM
    return np.c_[points.min(axis=1), points.max(axis=1)][1:]


@pytest.mark.parametrize("paper", PAPERS_MM)
def test_paper_and_board_have_their_true_size(tmp_path: Path, paper: str) -> None:
    pdf = page(tmp_path / "board.pdf", paper)
    box = re.search(rb"/MediaBox \[ 0 0 " + _NUMBER + b" " + _NUMBER, pdf)
    assert box is not None
    np.testing.assert_allclose([float(v) * _MM for v in box.groups()], PAPERS_MM[paper], atol=1e-3)
    quads = quads_mm(pdf)
    size = quads[:, 2:] - quads[:, :2]
    squares = quads[(np.abs(size - 25.0) < 1e-3).all(axis=1)]
    assert len(squares) == 32
    np.testing.assert_allclose(squares[:, 2:].max(axis=0) - squares[:, :2].min(axis=0), TARGET.size_mm, atol=1e-3)
    assert (quads[:, :2] > 4).all()
    assert (quads[:, 2:] < np.array(PAPERS_MM[paper]) - 4).all()


def test_the_program_reads_the_page_at_true_scale(tmp_path: Path) -> None:
    """All black rectangles drawn at 8 pixels a millimetre: every corner is found where it belongs."""
    quads, per_mm = quads_mm(page(tmp_path / "board.pdf", "a4")), 8
    width, height = (round(side * per_mm) for side in PAPERS_MM["a4"])
    image = np.full((height, width), 230, np.uint8)
    for left, bottom, right, top in quads:
        image[round(height - top * per_mm) : round(height - bottom * per_mm), round(left * per_mm) : round(right * per_mm)] = 20
    view = detect_board(np.asarray(cv2.GaussianBlur(image, (0, 0), 1.2), np.uint8), TARGET)
    assert isinstance(view, BoardView)
    assert len(view.ids) == 48
    drawn = TARGET.object_points[view.ids][:, :2]
    found = view.corners_px / per_mm
    np.testing.assert_allclose(found - found.mean(axis=0), drawn - drawn.mean(axis=0), atol=0.08)


def test_the_ruler_is_two_hundred_millimetres_long(tmp_path: Path) -> None:
    lines = re.findall(_NUMBER + b" " + _NUMBER + rb" m\n" + _NUMBER + b" " + _NUMBER + rb" l\s+S", page(tmp_path / "board.pdf", "a4"))
    lengths = [abs(float(line[2]) - float(line[0])) * _MM for line in lines]
    assert max(lengths) == pytest.approx(200.0, abs=1e-3)


def test_the_same_page_every_time(tmp_path: Path) -> None:
    write_target(tmp_path / "a.pdf", TARGET)
    write_target(tmp_path / "b.pdf", TARGET)
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()


def test_a_board_that_does_not_fit_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="does not fit on a4"):
        write_target(tmp_path / "large.pdf", CharucoTarget(square_mm=40.0, marker_mm=29.0), "a4")
    with pytest.raises(UsageError, match="no paper 'a5'"):
        write_target(tmp_path / "small.pdf", TARGET, "a5")
