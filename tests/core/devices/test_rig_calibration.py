"""A calibration in a rig file: full digits, old files, and files that were changed by hand."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from scanner_core.devices.rig import PRESETS, dump_rig, load_preset, parse_rig, recalibrated, rig_text
from scanner_core.errors import UsageError
from scanner_core.optics.calibration import VALID_DAYS, ScaleReference
from tests.core.optics.rigs import known_rig

BARE = known_rig()
FULL = replace(
    BARE,
    modes=np.random.default_rng(1).normal(size=(4, 30)) * 1e-3,
    scale=ScaleReference("bar", 150.003, 33.4, 1.00213, (12.5, 8.25)),
    valid_days=14.0,
)


def test_modes_scale_and_validity_survive_to_the_last_digit() -> None:
    config = load_preset("bench").with_calibration(FULL)
    text = dump_rig(config)
    again = parse_rig(text, "test").calibration
    assert again is not None
    assert again.modes is not None
    assert FULL.modes is not None
    np.testing.assert_array_equal(again.modes, FULL.modes)
    assert (again.scale, again.valid_days, again.identity()) == (FULL.scale, 14.0, FULL.identity())
    assert dump_rig(parse_rig(text, "test")) == text


def test_a_file_without_them_loads_as_before() -> None:
    text = dump_rig(load_preset("bench").with_calibration(BARE))
    again = parse_rig(text.replace(f"valid_days = {VALID_DAYS!r}\n", ""), "test").calibration
    assert again is not None
    assert (again.modes, again.scale, again.valid_days) == (None, None, VALID_DAYS)
    assert again.identity() == BARE.identity()


def test_the_id_tells_changed_modes() -> None:
    assert FULL.identity() != BARE.identity()
    text = dump_rig(load_preset("bench").with_calibration(FULL))
    with pytest.raises(UsageError, match="changed by hand"):
        parse_rig(re.sub(r"modes = \[\n  \[[^,]*", "modes = [\n  [0.5", text), "test")


@pytest.mark.parametrize("rows", ["[[1.0, 2.0]]", "[1.0]", "[[nan]]"])
def test_modes_of_another_shape_are_refused(rows: str) -> None:
    text = dump_rig(load_preset("bench").with_calibration(BARE)).replace("views = 20\n", f"views = 20\nmodes = {rows}\n")
    with pytest.raises(UsageError, match="modes"):
        parse_rig(text, "test")


def test_a_new_calibration_leaves_comments_and_all_other_tables_as_they_were() -> None:
    text = "# mine\n" + rig_text("paper-2003").replace("[volume]", "[volume]  # a cylinder")
    text = text.replace("[calibration]\n", "# measured on a Monday\n[calibration]\n# by hand\n")
    text += "\n[image_model]\nwithout = ['speckle']  # later table\n"
    new = recalibrated(text, FULL)
    for kept in ("# mine", "[volume]  # a cylinder", "# measured on a Monday", "# by hand", "# later table", "# the publication does not state it"):
        assert new.count(kept) == 1
    calibration = parse_rig(new, "test").calibration
    assert calibration is not None
    assert calibration.identity() == FULL.identity()
    assert parse_rig(new, "test").spot == load_preset("paper-2003").spot
    assert recalibrated(new, FULL) == new


@pytest.mark.parametrize("name", PRESETS)
def test_the_shipped_rigs_say_how_uncertain_they_are(name: str) -> None:
    calibration = load_preset(name).calibration
    assert calibration is not None
    assert calibration.modes is not None
    assert calibration.scale is not None
    assert calibration.scale.verified
