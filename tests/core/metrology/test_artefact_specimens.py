"""The virtual artefacts stand where they are put and are as large as they say."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.geometry.fitting import fit_sphere
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.virtual.specimens import load_specimen
from scanner_core.virtual.specimens.artefacts import PLATE_MM, ball_bar, plate, put_down_anew


def test_the_plate_faces_where_it_is_told_to() -> None:
    normal = np.array([0.8, 0.0, 0.6])
    mesh = plate((1, 2, 30), normal).mesh
    np.testing.assert_allclose(mesh.vertices.mean(axis=0), (1, 2, 30), atol=1e-9)
    np.testing.assert_allclose(mesh.area_vectors().sum(axis=0), PLATE_MM**2 * normal, rtol=1e-9)


def test_the_bar_s_spheres_have_their_radius_and_distance() -> None:
    centres = np.array([[-30.0, 5, 20], [30, -5, 60]])
    bar = ball_bar(centres, 11.133).mesh
    rng = np.random.default_rng(1)
    corners = bar.vertices[bar.triangles]
    weights = rng.dirichlet((1, 1, 1), len(corners))
    points = np.einsum("tij,ti->tj", corners, weights)  # one anywhere on every facet, as the beam meets it
    fits = [fit_sphere(points[:81920]), fit_sphere(points[81920:163840])]
    for fit, centre in zip(fits, centres, strict=True):
        assert fit.radius_mm == pytest.approx(11.133, abs=1e-4)
        np.testing.assert_allclose(fit.centre, centre, atol=1e-4)


def test_a_sphere_put_down_anew_keeps_its_truth() -> None:
    sphere = load_specimen("sphere")
    placement = RigidTransform.from_vector([0, 0, 0.5], [1.0, -2.0, 0.0])
    moved = put_down_anew(sphere, placement)
    points = np.array([[0.0, 0, 30], [15, 0, 13]])
    np.testing.assert_allclose(moved.distance_mm(placement.apply(points)), sphere.distance_mm(points), atol=1e-9)
    assert moved.true_radius_mm == sphere.true_radius_mm
