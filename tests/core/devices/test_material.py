from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from scanner_core.devices.aim_settings import AimSettings, aim_path, read_aim, write_aim
from scanner_core.devices.material import keep_material, own_materials, read_material, shipped_materials
from scanner_core.devices.rig import PRESETS, load_preset
from scanner_core.errors import UsageError

BENCH = load_preset("bench")


def test_every_shipped_material_fits_every_preset_and_says_why() -> None:
    materials = shipped_materials()
    assert len(materials) >= 4
    for material in materials:
        assert set(material.reasons) == set(material.numbers)
        for name in PRESETS:
            settings = material.settings(load_preset(name))
            assert settings.material == material.id
            assert settings.applied(load_preset(name)).spot == settings.spot


def test_numbers_are_relative_to_the_rigs_own_file() -> None:
    plaster = next(material for material in shipped_materials() if material.id.endswith("plaster"))
    settings = plaster.settings(BENCH)
    assert settings.exposure_ms[0] == pytest.approx(0.65 * BENCH.left.exposure_ms)
    assert settings.exposure_ms[1] == pytest.approx(0.65 * BENCH.right.exposure_ms)
    assert settings.spot.max_area_px == round(1.3 * BENCH.spot.max_area_px)
    blind = replace(BENCH, left=replace(BENCH.left, exposure_ms=0.0))
    assert plaster.settings(blind).applied(blind).left == blind.left  # a camera that does not tell its exposure is left alone


def test_what_is_set_can_be_kept_as_an_own_material(tmp_path: Path) -> None:
    spot = replace(BENCH.spot, min_area_px=5, max_area_px=77, read_noise_dn=1.4)
    kept = keep_material("Détax  pink\n", AimSettings((3.0, 3.0), (2.0, 2.0), spot), "as set", tmp_path / "materials")
    assert (kept.title, kept.own) == ("Détax pink", True)
    again, faults = own_materials(tmp_path / "materials")
    assert ([material.title for material in again], faults) == (["Détax pink"], [])
    settings = again[0].settings(BENCH)
    assert settings.spot == spot
    assert (settings.exposure_ms, settings.gain_db) == ((3.0, 3.0), (2.0, 2.0))
    with pytest.raises(UsageError, match="name"):
        keep_material("  ", settings, "as set", tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "about = 'x'",
        "title = 'x'\n[dominance]\nvalue = 3",
        "title = 'x'\n[dominance]\nvalue = 3\nreason = ' '",
        "title = 'x'\n[dominance]\nvalue = 0.1\nreason = 'r'",
        "title = 'x'\n[speed]\nvalue = 3\nreason = 'r'",
        "title = 3",
        "[",
    ],
)
def test_a_material_that_cannot_be_used_says_why_and_the_others_stay(text: str, tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text(text, encoding="utf-8")
    (tmp_path / "b.toml").write_text("title = 'good'", encoding="utf-8")
    with pytest.raises(UsageError) as raised:
        read_material(tmp_path / "a.toml")
    assert raised.value.code == "E-AIM-02"
    found, faults = own_materials(tmp_path)
    assert ([material.title for material in found], len(faults)) == (["good"], 1)


def test_what_was_set_while_aiming_is_read_as_it_was_written(tmp_path: Path) -> None:
    path = aim_path(tmp_path / "lab.toml")
    assert path.name == "lab.aim.toml"
    assert read_aim(path) is None
    settings = AimSettings((1.5, 1.6), (0.0, 3.0), replace(BENCH.spot, max_area_px=99), "own-x")
    write_aim(settings, path)
    assert read_aim(path) == settings
    assert AimSettings.of(settings.applied(BENCH), "own-x") == settings
    path.write_text(path.read_text(encoding="utf-8").replace("max_area_px = 99", "max_area_px = -1"), encoding="utf-8")
    with pytest.raises(UsageError) as raised:
        read_aim(path)
    assert raised.value.code == "E-AIM-01"
