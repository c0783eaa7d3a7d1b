"""Checks of the surface itself: closed, 2-manifold, one shell, outward, free of self-intersections, as large as it should be."""

from __future__ import annotations

import numpy as np

from scanner_core.delivery.check import Check, CheckVerdict
from scanner_core.delivery.limits import SIZES, UNIT_FACTOR
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.mesh import TriangleMesh

PASS, WARN, FAIL, OPEN = CheckVerdict.PASS, CheckVerdict.WARN, CheckVerdict.FAIL, CheckVerdict.OPEN


def shape_checks(mesh: TriangleMesh) -> list[Check]:
    """Whether it can be milled or printed, whatever its size."""
    found = check_mesh(mesh)
    pieces = found.components
    return [
        _counted("closed", found.boundary_edges, found.closed),
        _counted("manifold", found.nonmanifold_edges + found.nonmanifold_vertices, found.manifold),
        Check("shells", PASS if pieces == 1 else FAIL, "shells.pass" if pieces == 1 else "shells.fail", {"count": pieces}, float(pieces), "", 1.0),
        Check("outward", PASS if found.outward else FAIL, "outward.pass" if found.outward else "outward.fail"),
        _counted("intersections", found.self_intersections, found.self_intersections == 0),
    ]


def _counted(name: str, count: int, good: bool) -> Check:
    return Check(name, PASS if good else FAIL, f"{name}.pass" if good else f"{name}.fail", {"count": count}, float(count), "", 0.0)


def check_size(mesh: TriangleMesh, kind: str) -> Check:
    """Lengths along the principal axes against what objects of a type measure.

    Parameters
    ----------
    kind : type of the order: ear, arch, arch-before, other, ...
    """
    longest, middle, shortest = principal_lengths_mm(mesh)
    fields: dict[str, object] = {"longest_mm": f"{longest:.1f}", "middle_mm": f"{middle:.1f}", "shortest_mm": f"{shortest:.1f}"}
    expected = SIZES.get(kind.partition("-")[0])
    if expected is None:
        return Check("size", OPEN, "size.open", fields, longest, "mm")
    fields |= {"kind": expected.words, "least_mm": f"{expected.least_mm:.0f}", "most_mm": f"{expected.most_mm:.0f}"}
    low, high = expected.least_mm, expected.most_mm
    verdict = PASS if low <= longest <= high else WARN if low / UNIT_FACTOR < longest < high * UNIT_FACTOR else FAIL
    too_small = longest < low
    return Check("size", verdict, f"size.{verdict.value}", fields, longest, "mm", low if too_small else high, at_least=too_small)


def principal_lengths_mm(mesh: TriangleMesh) -> tuple[float, float, float]:
    """Extents along the principal axes of the surface, falling; they do not depend on how the object lies."""
    areas = mesh.areas()
    centres = np.mean(mesh.corners(), axis=0)
    middle = areas @ centres / max(float(areas.sum()), 1e-30)
    about = centres - middle
    axes = np.linalg.eigh((about * areas[:, None]).T @ about)[1]
    extents = sorted(np.ptp(mesh.vertices @ axes, axis=0).tolist(), reverse=True)
    return extents[0], extents[1], extents[2]
