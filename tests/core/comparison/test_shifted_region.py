from __future__ import annotations

import numpy as np
import pytest

from scanner_core.comparison.alignment import FrameShift
from scanner_core.comparison.arch_frame import ArchFrame
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.shifted_region import shifted_region
from scanner_core.geometry.rigid import RigidTransform

ARCH = ArchFrame(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0]), np.empty((0, 3)))
POINTS = np.column_stack([np.zeros(101), np.linspace(-25.0, 25.0, 101), np.zeros(101)])


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
