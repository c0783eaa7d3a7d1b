from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.comparison import frame_words
from scanner_core.comparison.alignment import FrameShift
from scanner_core.comparison.arch_frame import ArchFrame
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.shifted_region import shifted_region
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.core.comparison.made import made

ARCH = ArchFrame(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0]), np.empty((0, 3)))
POINTS = np.column_stack([np.zeros(101), np.linspace(-25.0, 25.0, 101), np.zeros(101)])


def test_what_another_frame_would_do_is_told_by_the_part_it_shifts_most(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frame_words, "arch_frame", lambda mesh, supported: ARCH)
    after = TriangleMesh(POINTS, np.array([[0, 1, 2]]))
    comparison = made(areas=0)
    shifts = tuple(FrameShift(Frame.WHOLE, RigidTransform.identity(), 50.0, 420.0, um) for um in (10.0 * (25.0 - POINTS[:, 1]), np.full(101, 50.0)))
    alignment = replace(comparison.alignment, transform=RigidTransform.identity(), shifts=shifts)
    comparison = replace(comparison, after=replace(comparison.after, mesh=after), alignment=alignment)
    assert frame_words.shift_sentences(comparison) == (
        "Whole best fit would shift the molars by 0.42 mm.",
        "Whole best fit would shift everything by 0.05 mm rms, 0.42 mm at most.",
    )


def _shift(displacement_um: np.ndarray[tuple[int], np.dtype[np.float64]]) -> FrameShift:
    return FrameShift(Frame.WHOLE, RigidTransform.identity(), 0.0, 0.0, displacement_um)


def test_a_tilt_about_the_front_shifts_the_molars() -> None:
    found = shifted_region(_shift(10.0 * (25.0 - POINTS[:, 1])), POINTS, ARCH)
    assert found is not None
    assert found[0] == "molars"
    assert found[1] == pytest.approx(425.0, abs=15.0)  # the mean over the rear 30 % of 50 mm


def test_a_tilt_about_the_molars_shifts_the_front() -> None:
    found = shifted_region(_shift(10.0 * (25.0 + POINTS[:, 1])), POINTS, ARCH)
    assert found is not None
    assert found[0] == "front"


def test_a_shift_of_everything_names_no_part() -> None:
    assert shifted_region(_shift(np.full(101, 300.0)), POINTS, ARCH) is None
    assert shifted_region(_shift(10.0 * (25.0 - POINTS[:, 1])), POINTS, ArchFrame(ARCH.centre, ARCH.up, None, ARCH.ridge)) is None
