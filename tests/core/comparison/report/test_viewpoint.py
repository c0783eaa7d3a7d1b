"""Where the report looks from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import ComparisonParameters, Jaw
from scanner_core.comparison.report.viewpoint import viewpoints
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from tests.core.comparison.made import made


def _horseshoe() -> TriangleMesh:
    """A trough of 50 x 45 x 9 mm, open below, its closed end towards +y, its ridge towards +z."""
    along, across = np.meshgrid(np.linspace(0, np.pi, 81), np.linspace(-1, 1, 15))
    radius = 1 + 0.18 * across
    points = np.stack([22 * radius * np.cos(along), 38 * radius * np.sin(along), 9 * (1 - across**4)], axis=-1).reshape(-1, 3)
    corner = (np.arange(14)[:, None] * 81 + np.arange(80)).ravel()
    triangles = np.concatenate([np.column_stack([corner, corner + 82, corner + 1]), np.column_stack([corner, corner + 81, corner + 82])])
    return TriangleMesh(points, triangles.astype(np.int64))


def _of(mesh: TriangleMesh, jaw: Jaw | None) -> Comparison:
    surface = ComparedSurface(mesh, "arch", "00", "mm", "", np.ones(len(mesh.vertices), np.bool_))
    return replace(made(), before=surface, parameters=ComparisonParameters(jaw=jaw))


@pytest.mark.parametrize(("jaw", "above", "right"), [(None, 1, 1), (Jaw.UPPER, 1, -1), (Jaw.LOWER, -1, 1)])
def test_an_arch_is_seen_as_in_a_dental_chart(jaw: Jaw | None, above: int, right: int) -> None:
    points = viewpoints(_of(_horseshoe(), jaw))
    assert [p.name for p in points[:2]] == ["Occlusal", "Frontal"]
    occlusal, frontal, one, other, lingual = (p.axes for p in points)
    assert np.allclose(occlusal[2], [0, 0, 1], atol=0.05)
    assert np.allclose(occlusal[1], [0, above, 0], atol=0.05)  # the front teeth
    assert np.allclose(frontal[2], [0, 1, 0], atol=0.05)
    assert np.allclose(lingual[2], [0, -1, 0], atol=0.05)
    assert np.allclose(one[2], [right, 0, 0], atol=0.05)
    assert np.allclose(other[2], [-right, 0, 0], atol=0.05)
    for axes in (frontal, one, other, lingual):
        assert np.allclose(axes[1], [0, 0, -1 if jaw is Jaw.UPPER else 1], atol=0.05)  # up in the patient
    for axes in (occlusal, frontal):
        if jaw is not None:
            assert np.allclose(axes[0], -one[2], atol=0.05)  # the patient's right is on the left
    assert ("From the right" in [p.name for p in points]) is (jaw is not None)
    for p in points:
        assert np.allclose(p.axes @ p.axes.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(p.axes) == pytest.approx(1)


def test_anything_else_is_seen_along_its_own_axes() -> None:
    points = viewpoints(made())
    assert [p.name for p in points] == ["Seen from +z", "Seen from −y", "Seen from +x", "Seen from −x", "Seen from +y"]
    assert [tuple(p.axes[2]) for p in points] == [(0, 0, 1), (0, -1, 0), (1, 0, 0), (-1, 0, 0), (0, 1, 0)]
    assert tuple(points[0].axes[0]) == (1, 0, 0)
