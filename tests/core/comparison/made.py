"""A comparison whose truth is known in closed form: a corrugated plate on which two patches were raised and lowered."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scanner_core.comparison.alignment import Alignment, FrameShift
from scanner_core.comparison.area import Area, PartMotion
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.deviation import Deviation, DeviationStatistics
from scanner_core.comparison.doubt import Doubt
from scanner_core.comparison.parameters import ComparisonParameters, Frame
from scanner_core.comparison.surface import ComparedSurface
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.rigid import RigidTransform

Array = NDArray[np.float64]

POSE = RigidTransform.from_vector([0.1, -0.2, 0.3], [4.0, -7.0, 2.0])
"""After to before."""
SERIOUS = Doubt("stable-region-small", "Only 9 % of the common area held still; paint what did not move.", True)
REMARK = Doubt("unit-guessed", "The unit of the after file was taken as mm because of its size.", False)


def plate(columns: int = 31, rows: int = 25) -> TriangleMesh:
    """30 x 24 mm about the origin, (columns x rows) vertices."""
    x, y = (part.ravel() for part in np.meshgrid(np.linspace(-15, 15, columns), np.linspace(-12, 12, rows)))
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + columns + 1])
    upper = np.column_stack([corner, corner + columns + 1, corner + columns])
    return TriangleMesh(np.column_stack([x, y, 0.8 * np.sin(x / 2)]), np.concatenate([lower, upper]).astype(np.int64))


def made(
    *, doubts: tuple[Doubt, ...] = (REMARK,), areas: int = 2, words: str = "patch", name: str = "plate.stl", null_level_um: float | None = 61.0
) -> Comparison:
    """`areas` patches of a plate were raised or lowered by 400 um and more; its left edge has no counterpart, its right edge is no measurement."""
    before = plate()
    count = len(before.vertices)
    x, y = before.vertices[:, 0], before.vertices[:, 1]
    signed = np.zeros(count)
    found = []
    for i in range(areas):
        place = np.array([-9.0 + 6.0 * (i % 4), -6.0 + 4.0 * (i // 4 % 4), 0.0])
        patch = np.flatnonzero(np.hypot(x - place[0], y - place[1]) < 2.1)
        value = (900.0 - 20.0 * i) * (-1) ** i
        signed[patch] = value
        motion = PartMotion(RigidTransform.identity(), place, np.array([0.0, 0.0, value / 1000]), 2.5, np.array([0.0, 0.0, 1.0]), 11.0, 0.12, 20.0)
        up = np.array([0.0, 0.0, 1.0])
        found.append(
            Area(i + 1, patch, place, up, 12.5, value, abs(value), value, 0.0125 * value, 1, f"{words} {i + 1}", motion if i % 2 == 0 else None)
        )
    after_in_before = before.vertices + np.column_stack([np.zeros(count), np.zeros(count), signed / 1000])
    moved = signed != 0
    signed[x < -13.5] = np.nan
    supported = x < 14.5
    after = TriangleMesh(POSE.inverse().apply(after_in_before), before.triangles)
    statistics = DeviationStatistics(700, 0.05, 12.5, 240.0, 20.0, 850.0, 890.0, 900.0, {"100": 25.0, "250": 25.0, "500": 25.0}, 900.0, 901.0)
    level = np.full(count, 90.0)
    deviation = Deviation(signed, -np.nan_to_num(signed), before.vertices.copy(), level, 90.0, statistics)
    shift = FrameShift(Frame.WHOLE, POSE, 120.0, 604.0, np.full(count, 120.0))
    stable = ~moved & supported
    covariance, centre = 1e-6 * np.eye(6), np.zeros(3)
    alignment = Alignment(POSE, Frame.AUTO, "principal axes", stable, 0.9, 41.0, 42.0, 0.4, covariance, centre, 4.2, 1.0002, 0.00015, 0.95, (shift,))
    origin: dict[str, object] = {"path": r"D:\clinic\Jane Doe\plate.stl", "order": "2026-0417", "side": "lower jaw", "type": "dental arch"}
    return Comparison(
        ComparedSurface(
            before, name, "a3" * 32, "mm", "the header says so", np.ones(count, np.bool_), (), {**origin, "date": "2026-03-02T10:14:00+01:00"}
        ),
        ComparedSurface(after, name, "5b" * 32, "mm", "guessed", supported, doubts, {**origin, "date": "2026-11-20T09:02:00+01:00"}),
        ComparisonParameters(),
        alignment,
        deviation,
        tuple(found),
        None,
        null_level_um,
    )
