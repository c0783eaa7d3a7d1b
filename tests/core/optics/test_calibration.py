from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.geometry.rigid import RigidTransform
from tests.core.optics.rigs import known_rig


def test_table_frame_stands_on_the_axis_and_looks_between_the_cameras() -> None:
    calibration = known_rig()
    to_table = calibration.rig_to_table()
    np.testing.assert_allclose(to_table.apply(calibration.turntable.origin), 0, atol=1e-12)
    np.testing.assert_allclose(to_table.rotate(calibration.turntable.direction), [0, 0, 1], atol=1e-12)
    middle = to_table.apply(0.5 * (calibration.left.centre_mm() + calibration.right.centre_mm()))
    assert middle[0] > 0
    assert middle[1] == pytest.approx(0, abs=1e-9)
    # Who stands behind the cameras and looks along -x has +y on the right.
    assert to_table.apply(calibration.left.centre_mm())[1] < -100
    assert to_table.apply(calibration.right.centre_mm())[1] > 100


def test_object_turns_back_with_the_table() -> None:
    calibration = known_rig()
    in_object = np.array([[10.0, 3.0, 20.0]])
    on_table = RigidTransform.about_z(30.0).apply(in_object)
    in_rig = calibration.rig_to_table().inverse().apply(on_table)
    np.testing.assert_allclose(calibration.rig_to_object(30.0).apply(in_rig), in_object, atol=1e-10)


def test_identity_changes_with_what_changes_a_point_and_with_nothing_else() -> None:
    calibration = known_rig()
    assert replace(calibration, date="later", views=3).identity() == calibration.identity()
    moved = replace(calibration.turntable, origin=calibration.turntable.origin + np.array([0, 0, 1e-9]))
    assert replace(calibration, turntable=moved).identity() != calibration.identity()
