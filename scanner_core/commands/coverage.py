"""``impronta coverage``: which places of a case's surface are not as certain as wanted, and why."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.points import case_rig
from scanner_core.case.processing import chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.commands.console import Console
from scanner_core.coverage.covering import cover
from scanner_core.coverage.exposures import exposures_of
from scanner_core.coverage.report import CoverageReport
from scanner_core.errors import CaseError
from scanner_core.geometry.mesh import TriangleMesh

_TOLD = 12
"""Places that are told to a person; JSON has all."""


def run(given: argparse.Namespace, console: Console) -> int:
    path = Path(given.case)
    with CaseStore.open(path, read_only=True) as store:
        mesh, _ = store.mesh()
        if not {"standard_uncertainty_um", "supported"} <= mesh.vertex_attributes.keys():
            raise CaseError("E-COV-01", path=path)
        processed = process_case(store, chosen_processing(store))
        scan = next(scan for scan in store.scans() if scan.id == processed.processing.scans[-1])
        rig, calibration = case_rig(store, scan)
        cloud = processed.cloud
        if len(processed.mounts) > 1:  # of interest is how the object stands now: in the newest mount, in whose frame it was seen
            vertices = processed.mounts[scan.mount].inverse().apply(mesh.vertices)
            mesh = TriangleMesh(vertices, mesh.triangles, mesh.vertex_attributes)
            cloud = process_case(store, replace(processed.processing, scans=(scan.id,))).cloud
        observed = exposures_of(store.exposures(scan.id), ScanPlan.from_dict(scan.plan), cloud, rig)
    report = cover(mesh, rig, calibration, given.until_um, observed)
    console.result({"case": str(path)} | report.as_dict(), coverage_summary(report))
    return 0


def coverage_summary(report: CoverageReport) -> list[str]:
    """The report in lines that a person reads."""
    head = f"{100 * report.within_fraction:.1f} % of the surface is within {report.wanted_um:g} um; "
    lines = [head + f"of what can be reached as the object stands, {100 * report.reachable_within_fraction:.1f} %."]
    lines += [f"  {place.words}" for place in report.places[:_TOLD]]
    if len(report.places) > _TOLD:
        area = sum(place.area_mm2 for place in report.places[_TOLD:])
        lines.append(f"  and {len(report.places) - _TOLD} smaller places of together {area:.1f} mm2.")
    return lines
