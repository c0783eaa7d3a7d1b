"""What a rig file says of the virtual rig's image model."""

from __future__ import annotations

import pytest

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands.scanning import without_terms
from scanner_core.devices.rig import dump_rig, load_preset, parse_rig
from scanner_core.errors import UsageError
from scanner_core.virtual.presets import PRESETS


def test_a_rig_file_changes_numbers_and_switches_terms_off() -> None:
    text = dump_rig(load_preset("bench")) + '\n[image_model]\nf_number = 2.8\nwithout = ["speckle"]\n'
    config = parse_rig(text, "here")
    assert parse_rig(dump_rig(config), "there").image_model == config.image_model
    with open_rig(config.without(["ambient_light"])) as rig:
        assert rig.bench is not None
        preset = rig.bench.preset
    assert (preset.f_number, preset.speckle, preset.ambient_dn) == (2.8, 0.0, 0.0)


@pytest.mark.parametrize(
    "said",
    [
        *("fog = 1.0", "f_number = true", "f_number = -1", "beam_nodes = 3", "beam_sigma_mm = 0.2", 'without = "speckle"', 'without = ["fog"]'),
        *("f_number = 0", "electrons_per_dn = 0.0", "beam_diameter_mm = 0", "f_number = 0.001", "focus_mm = 435"),
        *("distance_mm = 500.0", "rate_hz = 30.0", "speckle = nan"),
    ],
)
def test_what_makes_no_rig_is_refused(said: str) -> None:
    config = parse_rig(dump_rig(load_preset("bench")) + f"\n[image_model]\n{said}\n", "here")
    with pytest.raises(UsageError, match="image model"):
        open_rig(config)


def test_zero_switches_off_what_may_be_off() -> None:
    off = {name: 0 for name in ("speckle", "surface_um", "specular", "ambient_dn", "backlash_deg", "read_noise_dn")}
    preset = PRESETS["bench"].changed(off)
    assert [getattr(preset, name) for name in off] == [0.0] * len(off)


def test_other_cameras_have_no_calibration_yet() -> None:
    bench = load_preset("bench")
    assert without_terms(bench, ["speckle"]).calibration is bench.calibration
    assert without_terms(bench, ["distortion"]).calibration is None
