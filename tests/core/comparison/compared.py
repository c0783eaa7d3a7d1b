"""Comparisons of surfaces that lie in one frame, without the search for an alignment."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scanner_core.comparison.area import Area
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.measuring import measure_deviation
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform
from tests.core.comparison.aligned import given, surface


def named(mesh: TriangleMesh, name: str, **origin: object) -> ComparedSurface:
    return replace(surface(mesh), name=name, sha256=name.encode().hex().ljust(64, "0"), origin=origin)


def compared(
    before: ComparedSurface,
    after: ComparedSurface,
    transform: RigidTransform | None = None,
    areas: tuple[Area, ...] = (),
    doubts: tuple[Doubt, ...] = (),
) -> Comparison:
    """Of surfaces whose alignment (after to before) is given."""
    alignment = replace(given(after.mesh, transform, noise_um=5.0), doubts=doubts)
    parameters = ComparisonParameters(Frame.GIVEN)
    deviation = measure_deviation(before, after, alignment, parameters, progress=lambda _: None, cancelled=lambda: False)
    return Comparison(before, after, parameters, alignment, deviation, areas)


def area_at(after: TriangleMesh, middle: tuple[float, float, float], rank: int = 1, p95_um: float = 300.0) -> Area:
    vertices = np.flatnonzero(np.linalg.norm(after.vertices - middle, axis=1) < 6.0)
    up = np.array([0.0, 0.0, 1.0])
    return Area(rank, vertices, np.array(middle), up, 20.0, -0.8 * p95_um, p95_um, -1.2 * p95_um, -4.0, 1, f"place {rank}")
