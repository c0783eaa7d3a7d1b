from __future__ import annotations

import numpy as np
import pytest

from scanner_core.comparison.grow_part import grow_part
from scanner_core.comparison.part_motion import part_motion
from scanner_core.errors import ComparisonError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.core.comparison.aligned import given, plane, surface

SPACING_MM = 0.25


def row(moved: RigidTransform | None, seed: int, noise_mm: float = 0.03, length_mm: float = 0.0) -> TriangleMesh:
    """A plate of 16 mm with an oblong hump 2.5 mm high in its middle, `moved`; the noise is white, or alike as ``exp(-h^2 / l^2)``."""
    rng = np.random.default_rng(seed)
    mesh = plane(16.0, SPACING_MM)
    places = mesh.vertices[:, :2] + rng.uniform(-0.06, 0.06, (len(mesh.vertices), 2))  # no two scans share their triangles
    height = _hump(places, RigidTransform.identity() if moved is None else moved)
    smooth = TriangleMesh(np.column_stack([places, height]), mesh.triangles)
    noise = rng.normal(0, noise_mm, len(height))
    if length_mm:  # a sum of random waves (Shinozuka 1971)
        number = rng.normal(size=(400, 3)) * np.sqrt(2) / length_mm
        noise = noise_mm * np.sqrt(2 / 400) * np.cos(smooth.vertices @ number.T + rng.uniform(0, 2 * np.pi, 400)).sum(axis=1)
    return TriangleMesh(smooth.vertices + smooth.vertex_normals() * noise[:, None], mesh.triangles)


BODIES = (((0.0, 0.0), (2.6, 3.4, 2.5)), ((1.2, 1.6), (1.1, 1.2, 3.4)), ((-1.2, -1.3), (1.2, 1.0, 3.2)))
"""Middles and half axes of three ellipsoids: a crown with two cusps, so that it cannot slip in its own shape."""


def _hump(places: np.ndarray, moved: RigidTransform) -> np.ndarray:
    """Height over places (n, 2) of the moved bodies, by their quadratic forms."""
    height = np.zeros(len(places))
    for middle, axes in BODIES:
        form = moved.rotation @ np.diag(1 / np.square(axes)) @ moved.rotation.T
        centre = moved.apply(np.array([*middle, 0.0]))
        about = places - centre[:2]
        linear = about @ form[:2, 2]
        constant = np.einsum("ni,ij,nj->n", about, form[:2, :2], about) - 1
        root = linear**2 - form[2, 2] * constant
        height = np.where(root > 0, np.maximum(height, (np.sqrt(np.maximum(root, 0)) - linear) / form[2, 2] + centre[2]), height)
    return height


MOTION = RigidTransform.from_vector(np.radians([3.0, -2.0, 4.0]), [0.8, -0.5, 0.3])


def marked(mesh: TriangleMesh) -> np.ndarray:
    """The hump without its foot."""
    part: np.ndarray = mesh.vertices[:, 2] > 0.4
    return part


def test_motion_of_a_marked_part_comes_out() -> None:
    before, after = row(None, 1), row(MOTION, 2)
    motion = part_motion(surface(before), surface(after), given(after, noise_um=40.0), marked(after))
    truth = MOTION.apply(motion.centre) - motion.centre
    assert np.linalg.norm(motion.displacement_mm - truth) < 0.02
    assert (motion.transform @ MOTION.inverse()).angle_deg() < 3 * np.sqrt(3) * motion.angle_uncertainty_deg  # of three axes, at three sigma
    assert motion.angle_uncertainty_deg < 0.5
    assert motion.rms_um < 60
    assert motion.axis @ (np.radians([3.0, -2.0, 4.0]) / np.linalg.norm(np.radians([3.0, -2.0, 4.0]))) > 0.98


def test_what_stands_still_round_a_crown_and_was_marked_along_does_not_hold_it() -> None:
    for wide in (3.6, 4.4):  # the crown is 2.6 x 3.4 mm: a lasso took some of the plate, which does not move
        before, after = row(None, 11), row(MOTION, 12)
        part = np.linalg.norm((after.vertices - MOTION.translation)[:, :2] / [2.6, 3.4], axis=1) < wide / 3.4
        assert 0.1 < (after.vertices[part, 2] < 0.1).mean() < 0.6
        motion = part_motion(surface(before), surface(after), given(after, noise_um=40.0), part)
        truth = MOTION.apply(motion.centre) - motion.centre
        assert np.linalg.norm(motion.displacement_mm - truth) < 0.02
        assert (motion.transform @ MOTION.inverse()).angle_deg() < 3 * np.sqrt(3) * motion.angle_uncertainty_deg


def test_stated_uncertainty_fits_the_true_error() -> None:
    lengths, angles = [], []
    for seed in range(12):
        before, after = row(None, 100 + seed), row(MOTION, 200 + seed)
        motion = part_motion(surface(before), surface(after), given(after, noise_um=40.0), marked(after))
        truth = float(np.linalg.norm(MOTION.apply(motion.centre) - motion.centre))
        lengths.append(1e3 * (np.linalg.norm(motion.displacement_mm) - truth) / motion.displacement_uncertainty_um)
        angles.append((motion.angle_deg - MOTION.angle_deg()) / motion.angle_uncertainty_deg)
    assert 0.5 < np.sqrt(np.mean(np.square(lengths))) < 1.6  # twelve draws of a standard normal: 0.5 to 1.5 in 99 %
    assert 0.5 < np.sqrt(np.mean(np.square(angles))) < 1.6


def test_the_uncertainty_of_the_alignment_is_in_it() -> None:
    before, after = row(None, 1), row(MOTION, 2)
    part = marked(after)
    alone = part_motion(surface(before), surface(after), given(after, noise_um=40.0), part)
    loose = part_motion(surface(before), surface(after), given(after, noise_um=40.0, sd_um=50.0), part)
    assert loose.displacement_uncertainty_um == pytest.approx(np.hypot(alone.displacement_uncertainty_um, 50.0), rel=1e-6)


def test_stated_uncertainty_fits_the_true_error_of_correlated_noise() -> None:
    lengths, angles = [], []
    for seed in range(12):
        before, after = row(None, 300 + seed, length_mm=1.0), row(MOTION, 400 + seed, length_mm=1.0)
        motion = part_motion(surface(before), surface(after), given(after, noise_um=42.0, correlation_mm=1.0), marked(after))
        truth = float(np.linalg.norm(MOTION.apply(motion.centre) - motion.centre))
        lengths.append(1e3 * (np.linalg.norm(motion.displacement_mm) - truth) / motion.displacement_uncertainty_um)
        angles.append((motion.angle_deg - MOTION.angle_deg()) / motion.angle_uncertainty_deg)
    assert 0.5 < np.sqrt(np.mean(np.square(lengths))) < 1.6
    assert 0.5 < np.sqrt(np.mean(np.square(angles))) < 1.6


def test_too_small_a_part_is_refused() -> None:
    after = row(None, 1)
    few = np.zeros(len(after.vertices), bool)
    few[:20] = True
    with pytest.raises(ComparisonError, match="20 measured vertices"):
        part_motion(surface(after), surface(after), given(after), few)


def test_a_click_on_a_hump_marks_this_hump() -> None:
    after = row(MOTION, 3)
    seed = int(np.argmin(np.linalg.norm(after.vertices - [0.8, -0.5, 2.8], axis=1)))
    part = grow_part(after, seed)
    hump = after.vertices[:, 2] > 0.8
    assert part[hump].mean() > 0.9
    assert (part & (after.vertices[:, 2] < 0.1)).sum() < 0.1 * hump.sum()
