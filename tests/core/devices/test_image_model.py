"""What a rig file says of the virtual rig's image model."""

from __future__ import annotations

import pytest

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands.scanning import without_terms
from scanner_core.devices.rig import dump_rig, load_preset, parse_rig
from scanner_core.errors import UsageError


def test_a_rig_file_changes_numbers_and_switches_terms_off() -> None:
    text = dump_rig(load_preset("bench")) + '\n[image_model]\nf_number = 2.8\nwithout = ["speckle"]\n'
    config = parse_rig(text, "here")
    assert parse_rig(dump_rig(config), "there").image_model == config.image_model
    with open_rig(config.without(["ambient_light"])) as rig:
        assert rig.bench is not None
        preset = rig.bench.preset
    assert (preset.f_number, preset.speckle, preset.ambient_dn) == (2.8, 0.0, 0.0)


@pytest.mark.parametrize("said", ["fog = 1.0", "f_number = true", "f_number = -1", "beam_nodes = 3", 'without = "speckle"', 'without = ["fog"]'])
def test_what_makes_no_rig_is_refused(said: str) -> None:
    config = parse_rig(dump_rig(load_preset("bench")) + f"\n[image_model]\n{said}\n", "here")
    with pytest.raises(UsageError, match="image model"):
        open_rig(config)


def test_other_cameras_have_no_calibration_yet() -> None:
    bench = load_preset("bench")
    assert without_terms(bench, ["speckle"]).calibration is bench.calibration
    assert without_terms(bench, ["distortion"]).calibration is None
