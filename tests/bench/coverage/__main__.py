"""Reasons of reconstructed surfaces against the truth.

::

    python -m tests.bench.coverage --specimens ear arch heart sphere FILE --seeds 1 2 3 [--points 20000] [--views 16]
    python -m tests.bench.coverage --specimens ear --case CASE.impronta

The scan is simulated by rays (see `simulated_scan`), or taken from a case that was rendered and reconstructed.  The truth of a
vertex is that of its counterpart on the true surface: the nearest along its normal; its reason is by the same definition, from
rays against the true surface.  Agreement is by area: of reachable or not over the whole surface, and of the reason over the whole, over
what the truth calls unreachable, and over what the program calls so; and of places, as a person reads them: connected parts with one
reason from 1 mm2, right where the other surface has the same reason over most of it.  Where a true surface is open, what closes it
takes no part.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from scanner_core.acquisition.plan import ScanPlan
from scanner_core.case.points import case_rig
from scanner_core.case.processing import chosen_processing, process_case
from scanner_core.case.store import CaseStore
from scanner_core.coverage.covering import cover, hindrances
from scanner_core.coverage.exposures import Exposures, exposures_of
from scanner_core.coverage.guess import counterparts
from scanner_core.coverage.placing import LEAST_MM2, vertex_areas
from scanner_core.coverage.reason import REASONS, Reason
from scanner_core.coverage.sightlines import Sightlines
from scanner_core.devices.rig import RigConfig, load_preset
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.edges import EdgeTable
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens import load_specimen
from tests.bench.coverage.simulated_scan import simulated_scan

OPEN_MM = 2.0
"""Farther from an open true surface the reconstruction closes it."""
FEW = REASONS.index(Reason.FEW_POINTS)


def simulated(truth: TriangleMesh, rig: RigConfig, points: int, views: int, seed: int) -> tuple[TriangleMesh, Exposures]:
    assert rig.calibration is not None
    scan = simulated_scan(truth, rig, rig.calibration, points, views, seed)
    parameters = ReconstructionParameters(seed=seed, table_mm=0.0)
    surface = reconstruct(scan.cloud, parameters, progress=lambda told: None, cancelled=lambda: False)
    return surface.mesh, exposures_of(scan.seen, scan.plan, scan.cloud, rig)


def of_case(path: Path) -> tuple[TriangleMesh, Exposures]:
    with CaseStore.open(path, read_only=True) as store:
        mesh, _ = store.mesh()
        processed = process_case(store, chosen_processing(store))
        scan = next(scan for scan in store.scans() if scan.id == processed.processing.scans[-1])
        rig, _ = case_rig(store, scan)
        return mesh, exposures_of(store.exposures(scan.id), ScanPlan.from_dict(scan.plan), processed.cloud, rig)


def judge(name: str, truth: TriangleMesh, surface: TriangleMesh, observed: Exposures | None, rig: RigConfig, confusion: bool) -> list[float]:
    """Prints one row, and returns the agreements."""
    assert rig.calibration is not None
    told = cover(surface, rig, rig.calibration, 0.0, observed).reasons
    normals = surface.vertex_normals()
    places, true_normals = counterparts(surface.vertices, normals, truth)
    true = hindrances(Sightlines(observed.rig if observed else rig, rig.calibration, truth, places, true_normals))
    area = vertex_areas(surface)
    if not check_mesh(truth).closed:  # it has nothing where the reconstruction closes it
        away_mm = np.linalg.norm(places - surface.vertices, axis=1)
        area = area * ((np.einsum("ij,ij->i", normals, true_normals) > 0.5) & (away_mm < OPEN_MM))

    def agreement(same: NDArray[np.bool_], over: NDArray[np.bool_]) -> float:
        return float(area[same & over].sum() / max(area[over].sum(), 1e-12))

    everywhere = np.ones_like(true, np.bool_)
    shares = [
        agreement((told == FEW) == (true == FEW), everywhere),
        agreement(told == true, everywhere),
        agreement(told == true, true != FEW),
        agreement(told == true, told != FEW),
        _places_right(surface, area, true, told),
        _places_right(surface, area, told, true),
    ]
    unseen = area[true != FEW].sum()
    print(f"{name:<28} {area.sum():8.0f} {unseen:8.1f}   " + " ".join(f"{100 * share:8.2f}" for share in shares), flush=True)
    if confusion:
        kinds = sorted({*told.tolist(), *true.tolist()})
        print(" " * 18 + " ".join(f"{REASONS[k].value:>14}" for k in kinds) + "   (mm2; rows truth, columns told)")
        for k in kinds:
            print(f"{REASONS[k].value:>18}" + " ".join(f"{area[(true == k) & (told == j)].sum():14.1f}" for j in kinds))
    return shares


def _places_right(surface: TriangleMesh, area: NDArray[np.float64], these: NDArray[np.uint8], others: NDArray[np.uint8]) -> float:
    """Share of the area of the unreachable places of `these` over most of which `others` has the same reason."""
    edges = EdgeTable.of(surface.triangles).edges
    same = edges[these[edges[:, 0]] == these[edges[:, 1]]]
    count = len(these)
    part = connected_components(sparse.coo_array((np.ones(len(same)), (same[:, 0], same[:, 1])), shape=(count, count)), directed=False)[1]
    votes = np.zeros((part.max() + 1, len(REASONS)))
    np.add.at(votes, (part, others), area)
    sizes, reason = votes.sum(axis=1), np.zeros(len(votes), np.uint8)
    reason[part] = these
    listed = (reason != FEW) & (sizes >= LEAST_MM2)
    return float(sizes[listed & (votes.argmax(axis=1) == reason)].sum() / max(sizes[listed].sum(), 1e-12))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--specimens", nargs="+", default=["ear", "arch", "heart", "sphere"])
    parser.add_argument("--seeds", nargs="+", type=int, default=[1])
    parser.add_argument("--points", type=int, default=20_000)
    parser.add_argument("--views", type=int, default=16)
    parser.add_argument("--case", type=Path)
    parser.add_argument("--mesh-alone", action="store_true", help="without what the exposures tell")
    parser.add_argument("--confusion", action="store_true")
    given = parser.parse_args()
    rig = load_preset("bench")
    print(" " * 46 + "agreement, %: reachable  reason everywhere, where unseen, told unseen  places true, told")
    for specimen in given.specimens:
        truth = load_specimen(specimen).mesh
        for seed in given.seeds:
            if given.case is not None:
                surface, observed = of_case(given.case)
            else:
                surface, observed = simulated(truth, rig, given.points, given.views, seed)
            judge(f"{Path(specimen).stem}, seed {seed}", truth, surface, None if given.mesh_alone else observed, rig, given.confusion)


if __name__ == "__main__":
    main()
