"""A comparison as JSON, in a case, and the marks that a file makes."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scanner_core.case.store import CaseStore
from scanner_core.comparison.comparison_values import above_null, comparison_values, surface_values
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.inputs import read_surface
from scanner_core.comparison.keeping import keep_comparison, kept_comparisons
from scanner_core.comparison.mask_file import read_mask
from scanner_core.errors import InputFileError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io import write_mesh
from tests.core.case.test_processing import small_case
from tests.core.comparison.compared import area_at, compared, named
from tests.core.comparison.shapes import cut, egg, scaled


def test_the_json_has_what_was_promised_and_no_nan() -> None:
    after = egg(60.2)
    before = replace(named(cut(egg(), 10.0), "a", path="folder/Jane Doe.stl"), doubts=(Doubt("open", "It is open.", serious=False),))
    grave = Doubt("stable-region-small", "The stable region is small.", serious=True)
    comparison = replace(compared(before, named(after, "b"), areas=(area_at(after, (0.0, 0.0, 30.0)),), doubts=(grave,)), null_level_um=280.0)
    values = json.loads(json.dumps(comparison_values(comparison), allow_nan=False))
    assert {"transform_after_to_before", "alignment", "deviation", "hausdorff_um", "areas", "warnings"} <= values.keys()
    assert {"frame", "stable_area_fraction", "rms_um", "uncertainty_um", "scale_ratio"} <= values["alignment"].keys()
    wanted = {"points", "no_counterpart_fraction", "mean_um", "rms_um", "p50_um", "p95_um", "p99_um", "max_um", "detection_level_um"}
    assert wanted <= values["deviation"].keys()
    assert set(values["deviation"]["area_above_mm2"]) == {"100", "250", "500"}
    assert set(values["hausdorff_um"]) == {"after_to_before", "before_to_after"}
    assert {"rank", "centroid_mm", "area_mm2", "mean_um", "p95_um", "max_um", "volume_mm3", "parts", "words"} <= values["areas"][0].keys()
    assert values["transform_after_to_before"] == np.eye(4).tolist()
    assert (values["areas"][0]["above_null"], values["reliable"]) == (True, False)
    assert values["warnings"] == ["The stable region is small.", "a: It is open."]
    assert "Jane" not in json.dumps(values)


def test_no_more_of_the_origin_is_written_than_was_promised() -> None:
    """A code of a few letters is found from its hash by trying: neither is written."""
    surface = named(egg(), "a", path="Jane Doe.stl", patient_code="P-1", order="4711", anything="else")
    assert surface_values(surface)["origin"] == {"order": "4711"}


def test_what_was_not_estimated_is_not_zero() -> None:
    values = json.loads(json.dumps(comparison_values(compared(named(egg(), "a"), named(egg(60.2), "b")))))
    assert (values["alignment"]["frame"], values["alignment"]["uncertainty_um"]) == ("given", None)


@pytest.mark.parametrize(("level_um", "extent_mm2", "above"), [(280.0, 19.0, True), (280.0, 21.0, False), (320.0, 0.0, False), (280.0, None, True)])
def test_an_area_is_weighed_by_height_and_extent_of_the_null_comparison(level_um: float, extent_mm2: float | None, above: bool) -> None:
    after = egg(60.2)
    comparison = compared(named(egg(), "a"), named(after, "b"), areas=(area_at(after, (0.0, 0.0, 30.0)),))
    assert above_null(comparison.areas[0], replace(comparison, null_level_um=level_um, null_area_mm2=extent_mm2)) is above
    assert above_null(comparison.areas[0], comparison) is None


def test_a_case_keeps_a_comparison_until_it_is_undone(tmp_path: Path) -> None:
    path = tmp_path / "a.impronta"
    path.write_bytes(small_case())
    with CaseStore.open(path) as store:
        store.put_mesh(egg(60.2), {})
    comparison = compared(named(egg(), "before.stl"), read_surface(path))
    with CaseStore.open(path) as store:
        assert kept_comparisons(store) == []
        number = keep_comparison(store, comparison)
        (kept,) = kept_comparisons(store)
        assert (kept.id, kept.shown, kept.of_this_mesh) == (number, True, True)
        assert kept.values == json.loads(json.dumps(comparison_values(comparison)))
        assert np.array_equal(kept.signed_um(store), comparison.deviation.signed_um, equal_nan=True)
        assert store.undoable == "Compared with before.stl"
        store.undo()
        assert [one.shown for one in kept_comparisons(store)] == [False]
        store.redo()
        store.put_mesh(egg(59.0), {})
        assert [(one.shown, one.of_this_mesh) for one in kept_comparisons(store)] == [(True, False)]


def test_a_part_cut_out_of_the_later_surface_marks_it(tmp_path: Path) -> None:
    write_mesh(tmp_path / "after.ply", egg())
    after = read_surface(tmp_path / "after.ply")
    part = cut(egg(), 12.0)
    inside = np.isin(after.mesh.vertices[:, 2].round(3), part.vertices[:, 2].round(3)) & (after.mesh.vertices[:, 2] > 12)
    for suffix in (".stl", ".ply", ".3mf"):
        write_mesh(tmp_path / f"part{suffix}", part)
        assert (read_mask(tmp_path / f"part{suffix}", after) == inside).all()
    inches = replace(after, unit="inch")
    (tmp_path / "inch.obj").write_bytes(
        b"".join(b"v %.9g %.9g %.9g\n" % tuple(v) for v in part.vertices / 25.4) + b"".join(b"f %d %d %d\n" % tuple(t + 1) for t in part.triangles)
    )
    assert (read_mask(tmp_path / "inch.obj", inches) == inside).all()
    write_mesh(tmp_path / "elsewhere.stl", scaled(part, 5.0))
    with pytest.raises(InputFileError, match="no vertex of after"):
        read_mask(tmp_path / "elsewhere.stl", after)


def test_numbers_of_points_that_were_renumbered_are_refused(tmp_path: Path) -> None:
    """A loose point first in the file shifts all others by one."""
    mesh = egg()
    with_loose = TriangleMesh(np.concatenate([[[7.0, 7.0, 7.0]], mesh.vertices]), mesh.triangles + 1)
    write_mesh(tmp_path / "after.ply", with_loose)
    (tmp_path / "mask.json").write_text("[1, 2, 3]")
    after = read_surface(tmp_path / "after.ply")
    with pytest.raises(InputFileError, match="joined or left out"):
        read_mask(tmp_path / "mask.json", after)
    write_mesh(tmp_path / "part.stl", cut(mesh, 12.0))
    assert read_mask(tmp_path / "part.stl", after).any()


def test_numbers_of_vertices_mark_it(tmp_path: Path) -> None:
    after, path = named(egg(), "b"), tmp_path / "mask.json"
    path.write_text("[0, 5, 5, 12]")
    assert np.flatnonzero(read_mask(path, after)).tolist() == [0, 5, 12]
    for wrong, reason in (
        ("[", "no JSON"),
        ("{}", "no list"),
        ("[]", "no list"),
        ("[true]", "no list"),
        ("[99999]", "names the vertex 99999"),
        ("[-1]", "vertex -1"),
    ):
        path.write_text(wrong)
        with pytest.raises(InputFileError, match=reason):
            read_mask(path, after)
