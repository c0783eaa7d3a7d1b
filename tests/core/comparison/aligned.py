"""Surfaces whose alignment is known, for the tests of what comes after it."""

from __future__ import annotations

import numpy as np

from scanner_core.comparison.alignment import Alignment
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform


def surface(mesh: TriangleMesh, supported: np.ndarray | None = None) -> ComparedSurface:
    marked = np.ones(len(mesh.vertices), bool) if supported is None else supported
    return ComparedSurface(mesh, "test", "0" * 64, "mm", "given", marked)


def given(
    after: TriangleMesh, transform: RigidTransform | None = None, *, noise_um: float = 0.0, correlation_mm: float = 0.0, sd_um: float = 0.0
) -> Alignment:
    """The alignment `transform`, of which each translation is known to `sd_um`."""
    covariance = np.zeros((6, 6))
    covariance[3:, 3:] = np.eye(3) * (sd_um / 1e3) ** 2
    return Alignment(
        transform=RigidTransform.identity() if transform is None else transform,
        frame=Frame.GIVEN,
        method="given",
        stable=np.ones(len(after.vertices), bool),
        stable_area_fraction=1.0,
        rms_um=noise_um,
        noise_um=noise_um,
        correlation_length_mm=correlation_mm,
        covariance=covariance,
        centre=after.vertices.mean(axis=0),
        uncertainty_um=sd_um,
        scale_ratio=1.0,
        scale_ratio_uncertainty=0.0,
        overlap=1.0,
    )


def pose(seed: int) -> RigidTransform:
    rng = np.random.default_rng(seed)
    return RigidTransform.from_vector(rng.normal(size=3), 20 * rng.normal(size=3))


def plane(size_mm: float, spacing_mm: float, height_mm: float = 0.0) -> TriangleMesh:
    """An open square about the origin, facing +z."""
    count = round(size_mm / spacing_mm) + 1
    line = np.linspace(-size_mm / 2, size_mm / 2, count)
    x, y = np.meshgrid(line, line, indexing="ij")
    vertices = np.column_stack([x.ravel(), y.ravel(), np.full(count * count, height_mm)])
    i = np.arange(count * count).reshape(count, count)
    a, b, c, d = i[:-1, :-1].ravel(), i[1:, :-1].ravel(), i[1:, 1:].ravel(), i[:-1, 1:].ravel()
    return TriangleMesh(vertices, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])]))
