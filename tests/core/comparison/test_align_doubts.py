"""What speaks against an alignment is said: another size, hardly any overlap, nothing that kept its place, a region that is one lump."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.comparison.aligning import align
from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.errors import ComparisonError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.core.comparison.aligned import surface
from tests.core.comparison.shapes import scaled
from tests.core.comparison.small_arch import noisy, small_arch

Mask = np.ndarray[tuple[int], np.dtype[np.bool_]]


def aligned(before: TriangleMesh, after: TriangleMesh, frame: Frame = Frame.GIVEN, mask: Mask | None = None) -> Alignment:
    start = RigidTransform.identity()
    parameters = ComparisonParameters(frame=frame)
    return align(surface(before), surface(after), parameters, mask=mask, start=start, progress=lambda _: None, cancelled=lambda: False)


def codes(found: Alignment) -> set[str]:
    assert found.reliable == (not any(doubt.serious for doubt in found.doubts))
    return {doubt.code for doubt in found.doubts}


def part(mesh: TriangleMesh, keep: Mask) -> TriangleMesh:
    return TriangleMesh(mesh.vertices, mesh.triangles[keep[mesh.triangles].all(axis=1)])


def test_a_repeated_scan_raises_no_doubt() -> None:
    assert codes(aligned(noisy(small_arch(), 30.0, 1), noisy(small_arch(), 30.0, 2))) == set()


def test_another_size_is_named_with_its_sign() -> None:
    before, after = noisy(small_arch(), 10.0, 1), noisy(scaled(small_arch(), 1.01), 10.0, 2)
    found = aligned(before, after, Frame.WHOLE)
    doubt = next(doubt for doubt in found.doubts if doubt.code == "scale-differs")
    assert "larger" in doubt.words
    assert found.scale_ratio == pytest.approx(1.01, abs=0.002)
    assert "scale-differs" in codes(aligned(before, noisy(scaled(small_arch(), 1.0045), 10.0, 2)))  # 0.17 mm at the rim
    assert not found.reliable
    assert "scale-differs" not in codes(aligned(before, noisy(scaled(small_arch(), 1.0005), 10.0, 2), Frame.WHOLE))


def test_little_overlap_is_named() -> None:
    whole = noisy(small_arch(), 30.0, 1)
    x = whole.vertices[:, 0]
    fifth, half = np.asarray(x > np.quantile(x, 0.8)), np.asarray(x > np.quantile(x, 0.5))
    after = noisy(small_arch(), 30.0, 2)
    assert "overlap-low" in codes(aligned(part(whole, fifth), after))
    assert "overlap-low" not in codes(aligned(part(whole, half), after))


def test_where_everything_moved_nothing_is_taken_for_stable() -> None:
    before = noisy(small_arch(), 20.0, 1)
    moved = RigidTransform.from_vector([0.02, 0.03, 0.01], [0.6, 0.5, 0.8]).apply(small_arch().vertices)
    after = noisy(TriangleMesh(moved, small_arch().triangles), 20.0, 2)
    assert "everything-moved" in codes(aligned(before, after))


@pytest.mark.parametrize(("half_wave_mm", "code"), [(2.0, "stable-region-loud"), (8.0, "everything-moved")])
def test_where_everything_changed_one_way_or_the_other_it_is_not_reliable(half_wave_mm: float, code: str) -> None:
    before, mesh = noisy(small_arch(), 20.0, 1), noisy(small_arch(), 20.0, 2)
    checks = np.sign(np.prod(np.sin(mesh.vertices[:, :2] * np.pi / half_wave_mm), axis=1))
    after = TriangleMesh(mesh.vertices + 0.3 * checks[:, None] * mesh.vertex_normals(), mesh.triangles)
    found = align(surface(before), surface(after), ComparisonParameters(), progress=lambda _: None, cancelled=lambda: False)
    assert code in codes(found)


def test_sizes_that_have_nothing_in_common_are_refused_in_a_sentence() -> None:
    for factor in (0.01, 100.0):
        with pytest.raises(ComparisonError, match="E-CMP-01"):
            align(
                surface(small_arch()),
                surface(scaled(small_arch(), factor)),
                ComparisonParameters(),
                progress=lambda _: None,
                cancelled=lambda: False,
            )


def test_one_lump_does_not_hold_the_far_end() -> None:
    before, after = noisy(small_arch(), 50.0, 1), noisy(small_arch(), 50.0, 2)
    place = before.vertices[np.argmin(before.vertices[:, 0])]
    lump = np.asarray(np.linalg.norm(after.vertices - place, axis=1) < 3.0)
    ends = np.asarray(np.abs(after.vertices[:, 0]) > 0.8 * np.abs(after.vertices[:, 0]).max())
    assert "stable-region-one-lump" in codes(aligned(before, after, Frame.MASK, lump))
    assert "stable-region-one-lump" not in codes(aligned(before, after, Frame.MASK, ends))
