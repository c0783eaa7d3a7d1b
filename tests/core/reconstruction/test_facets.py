from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.edges import EdgeTable
from scanner_core.reconstruction.facets import centred_facets, facet_sag_mm, local_edges, mean_lifts
from tests.core.reconstruction.shapes import sphere


@pytest.mark.parametrize("levels", [2, 3, 4])
def test_centred_facets_enclose_the_volume_of_the_sphere(levels: int) -> None:
    mesh = sphere(10.0, levels)
    true = 4 / 3 * np.pi * 1000
    before, after = (abs(m.volume() / true - 1) for m in (mesh, centred_facets(mesh)))
    assert after < 0.05 * before


def test_facets_in_a_hollow_are_centred_too() -> None:
    mesh = sphere(10.0, 3)
    assert np.all(mean_lifts(mesh, mesh.vertex_normals()) > 0)
    assert np.all(mean_lifts(mesh, -mesh.vertex_normals()) < 0)


def test_sag_of_a_sphere_is_its_cap_over_a_facet() -> None:
    mesh = sphere(10.0, 4)
    a, b, c = mesh.corners()
    sag = 10 - np.linalg.norm((a + b + c) / 3, axis=1)
    assert facet_sag_mm(mesh) == pytest.approx(float(np.percentile(sag, 95)), rel=0.03)


def test_local_edges_are_those_of_the_triangles_around() -> None:
    mesh = sphere(10.0, 4)
    assert local_edges(mesh).mean() == pytest.approx(float(EdgeTable.of(mesh.triangles).lengths(mesh.vertices).mean()), rel=0.02)
