"""Specimens and a rig on a script, shared by the tests of the virtual rig's optics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.virtual.motion_state import MotionInstant
from scanner_core.virtual.specimens import Specimen, load_specimen


@dataclass
class ScriptedMotion:
    """A timeline that a test sets by hand; `x_speed_deg_s` moves the beam from `x_deg` at time 0."""

    x_deg: float = 0.0
    y_deg: float = 0.0
    table_deg: float = 0.0
    laser_power: float = 1.0
    x_speed_deg_s: float = 0.0

    def instant(self, time_s: float) -> MotionInstant:
        return MotionInstant(self.x_deg + self.x_speed_deg_s * time_s, self.y_deg, self.table_deg, self.laser_power)


@pytest.fixture
def motion() -> ScriptedMotion:
    return ScriptedMotion()


@pytest.fixture(scope="session")
def ball() -> Specimen:
    return load_specimen("sphere")


@pytest.fixture(scope="session")
def ear_impression() -> Specimen:
    return load_specimen("ear")


@pytest.fixture(scope="session")
def slab() -> Specimen:
    """A thin plate of 60 x 60 mm that stands upright in the plane x = 0 and faces the cameras: one flat wall, few facets."""
    return Specimen("slab", box((-1.0, -30.0, 0.0), (0.0, 30.0, 60.0)))


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> TriangleMesh:
    """A closed axis-parallel box."""
    corners = np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], np.int64)
    return TriangleMesh(corners, triangles)
