"""Small cases that could be delivered, without a scan."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from scanner_core.case.records import Order
from scanner_core.case.store import CaseStore
from scanner_core.delivery.check import Check, CheckVerdict
from scanner_core.delivery.examining import Examination
from scanner_core.delivery.facts import CalibrationFacts, CaseFacts
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.optics.calibration_age import AgeState, CalibrationAge
from tests.core.geometry.solids import sphere

ORDER = Order("2026-0142", "SECRET-77", "left", "ear")
VALID = CalibrationFacts("58d27bc56bc17de9", "2026-11-20T08:00:00+00:00", CalibrationAge(3.0, 27.0, AgeState.VALID), 14.0, True)


def drop(radius_mm: float = 8.0) -> TriangleMesh:
    """A ball that was drawn out to a tip along +x and stands on a flat base without support at its lower end; 8 mm to its side."""
    ball = sphere(radius_mm, 40, 24)
    vertices = ball.vertices.copy()
    vertices[:, 0] += np.where(vertices[:, 0] > 0, 0.12 * vertices[:, 0] ** 2 * (vertices[:, 0] / radius_mm) ** 4, 0.0)
    floor = -0.75 * radius_mm
    below = vertices[:, 2] <= floor
    vertices[below, 2] = floor
    return TriangleMesh(vertices, ball.triangles, {"supported": (~below).astype(np.uint8)})


def facts(mesh: TriangleMesh | None = None, **others: object) -> CaseFacts:
    """Of a good scan; what is different is said."""
    good = CaseFacts(
        order=ORDER,
        mesh=drop() if mesh is None else mesh,
        mesh_id=1,
        report={"points": 9900, "expected_error_rms_um": 12.0, "residual_rms_um": 27.0},
        scans=(),
        rig="bench",
        virtual=True,
        calibration=VALID,
        mounts=(),
        mount_count=1,
        closure_um=8.0,
        views_um=20.0,
        marks=None,
        points=9900,
        removed=0,
        current=True,
        accepted=0,
        delivered={},
    )
    return replace(good, **others)


def examination(verdict: CheckVerdict = CheckVerdict.PASS, **others: object) -> Examination:
    """With one check of that verdict."""
    return Examination(facts(**others), (Check("current", verdict, "current.warn"),))


def write_case(path: Path, mesh: TriangleMesh, order: Order = ORDER) -> Path:
    """A case with a surface and nothing else."""
    with CaseStore.create(path) as store:
        store.put_order(order)
        store.put_mesh(mesh, {"report": {"points": 9900, "expected_error_rms_um": 12.0, "residual_rms_um": 27.0}})
    return path
