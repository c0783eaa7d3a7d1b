"""The level of detection of a rig and a material: measured, stored with the rig, and shown beside every change."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.null_comparison import carried_levels, largest_area_mm2, null_level_of, with_null_level
from scanner_core.devices.null_level import NullLevel, with_null_levels
from scanner_core.devices.rig import dump_rig, load_preset, load_rig, parse_rig, recalibrated, rig_text
from scanner_core.errors import ComparisonError, UsageError
from tests.core.comparison.aligned import plane
from tests.core.comparison.compared import compared, named
from tests.core.optics.rigs import known_rig

LEVEL = NullLevel("white plaster", "2026-05-01T10:00:00+02:00", ("abc",), 1000, 40.0, 20.0, -1.0, 60.0, 90.0, 1.5, 0.0, "0" * 64, "1" * 64)


def test_the_level_is_what_seems_to_have_changed() -> None:
    """A plane whose copy bulges by 0.15 mm over a known square; + outward."""
    before, after = plane(20.0, 0.5), plane(20.0, 0.5)
    x, y, z = after.vertices.T
    inside = (np.abs(x) < 2.2) & (np.abs(y) < 2.2)
    z[inside] += 0.15
    z[~inside] += 0.01 * np.sin(x[~inside])
    comparison = compared(
        named(before, "a", date="2026-05-01T10:00:00+02:00", calibration_id="c1"),
        named(after, "b", date="2026-05-01T09:00:00+01:00", calibration_id="c2"),
    )
    level = null_level_of(comparison, "plaster", "bench")
    assert (level.material, level.date, level.calibrations) == ("plaster", "2026-05-01T10:00:00+02:00", ("c1", "c2"))
    assert level.level_um == comparison.deviation.statistics.p95_um
    assert level.false_area_100_mm2 == pytest.approx(4.5**2, rel=0.03)  # nine vertices each way, half a millimetre each
    assert level.false_area_200_mm2 == 0.0
    assert {level.before_sha256, level.after_sha256} == {comparison.before.sha256, comparison.after.sha256}


def test_what_is_not_reliable_says_nothing_of_the_rig() -> None:
    doubt = Doubt("stable-region-small", "The stable region is small.", serious=True)
    with pytest.raises(ComparisonError, match="The stable region is small"):
        null_level_of(compared(named(plane(20, 1), "a"), named(plane(20, 1), "b"), doubts=(doubt,)), "plaster", "bench")


def test_surfaces_of_another_rig_say_nothing_of_this_one() -> None:
    comparison = compared(named(plane(20, 1), "a", rig="bench"), named(plane(20, 1), "b"))
    with pytest.raises(ComparisonError, match="measured with 'bench', not with 'workshop'"):
        null_level_of(comparison, "plaster", "workshop")
    assert null_level_of(comparison, "plaster", "bench").material == "plaster"


def test_separate_areas_are_not_added_up() -> None:
    mesh = plane(20.0, 1.0)
    marked = np.abs(mesh.vertices[:, 0]) > 8.5
    assert largest_area_mm2(mesh, marked) == pytest.approx(30.0)  # of two strips of 1.5 mm and 20 mm
    assert largest_area_mm2(mesh, np.zeros(len(marked), bool)) == 0.0


def test_a_rig_file_keeps_its_levels_and_its_comments(tmp_path: Path) -> None:
    path = tmp_path / "rig.toml"
    text = "# the bench by the window\n" + rig_text("bench")
    second = replace(LEVEL, material="wax", level_um=55.25)
    path.write_text(with_null_levels(with_null_levels(text, (LEVEL,)), (LEVEL, second)), encoding="utf-8")
    rig = load_rig(path)
    assert rig.null_levels == (LEVEL, second)
    assert path.read_text(encoding="utf-8").startswith("# the bench by the window\n")
    assert parse_rig(dump_rig(rig), "again").null_levels == rig.null_levels
    again = parse_rig(recalibrated(path.read_text(encoding="utf-8"), known_rig()), "calibrated")
    assert (again.null_levels, again.calibration is not None) == (rig.null_levels, True)
    assert with_null_levels(path.read_text(encoding="utf-8"), ()).strip() == text.strip()


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("level_um = 40.0", "level_um = 4.0", "do not match its id"),
        ("points = 1000", "points = 0", "'points' must be a whole number"),
        ("rms_um = 20.0", "rms_um = nan", "'rms_um' must be a number"),
        ('calibrations = ["abc"]', 'calibrations = "abc"', "one or two identities"),
        ('date = "2026-05-01T10:00:00+02:00"', 'date = "may"', "rig file"),
        ("[[null_comparison]]", "[null_comparison]", "at most 100 tables"),
    ],
)
def test_levels_that_were_changed_by_hand_are_refused(old: str, new: str, reason: str) -> None:
    text = with_null_levels(rig_text("bench"), (LEVEL,))
    assert old in text
    with pytest.raises(UsageError, match=reason):
        parse_rig(text.replace(old, new), "rig.toml")


def test_the_level_stands_beside_every_change() -> None:
    comparison = compared(named(plane(20, 1), "a", rig="bench"), named(plane(20, 1), "b", rig="bench"))
    levels = (LEVEL, replace(LEVEL, material="wax", level_um=55.0))

    def shown(**options: str) -> tuple[float | None, list[str]]:
        found = with_null_level(comparison, levels, **options)
        assert found.reliable
        return found.null_level_um, [doubt.code for doubt in found.doubts]

    assert shown(material="White Plaster", rig="bench", calibration_date="2026-04-30T10:00:00+02:00") == (40.0, [])
    assert shown(material="stone") == (55.0, ["null-other-material"])
    assert shown() == (55.0, ["null-material-unknown"])
    assert shown(material="wax", calibration_date="2026-05-02T10:00:00+02:00") == (55.0, ["null-older-than-calibration"])
    assert shown(material="wax", rig="workshop") == (55.0, ["null-other-rig"])
    assert with_null_level(comparison, ()).null_level_um is None
    assert with_null_level(comparison, levels, material="wax").null_area_mm2 == LEVEL.false_area_200_mm2


def test_a_case_carries_the_levels_of_its_rig() -> None:
    surface = named(plane(20, 1), "a", null_levels=[LEVEL.as_dict()])
    assert carried_levels(named(plane(20, 1), "b"), surface) == (LEVEL,)
    assert carried_levels(named(plane(20, 1), "b")) == ()
    assert load_preset("bench").null_levels == ()
