"""Is the predicted uncertainty of single points that of their errors?  Terms of the image model are changed behind the program's back.

::

    python -m tests.bench.optics.point_uncertainty --seed 1 [--presets bench workshop] [--points 3500]

A z-score is the distance of a point to the true surface over its predicted standard deviation along the normal; where
the object stands is fitted first.  The standard deviation of the z-scores should be 1.
"""

from __future__ import annotations

import argparse
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.points import triangulate_observations
from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_preset
from scanner_core.geometry.closest_point import ClosestPoint
from scanner_core.geometry.registration import fit_rigid_to_surface
from scanner_core.optics.noise_model import NoiseModel
from scanner_core.virtual import presets
from scanner_core.virtual.specimens import load_specimen

CHANGES: dict[str, dict[str, Any]] = {
    "as shipped": {},
    "no speckle": {"speckle": 0.0},
    "half the speckle": {"speckle": 0.5},
    "surface 50 um": {"surface_um": 50.0},
    "noisy sensor": {"electrons_per_dn": 10.0, "read_noise_dn": 4.0, "speckle": 0.3},
    "f/5.6": {"f_number": 5.6},
}


def z_scores(preset: str, changes: dict[str, Any], specimen: str, points: int, views: int, seed: int) -> tuple[np.ndarray, np.ndarray, NoiseModel]:
    """z (n,), signed errors (n,) um and the noise that the scan found; the shipped calibration is used.

    A changed `exposure_ms` is also the cameras', so that a spot stays as bright.
    """
    config, body = load_preset(preset), load_specimen(specimen)
    exposure_ms = changes.get("exposure_ms", config.left.exposure_ms)
    config = replace(config, left=replace(config.left, exposure_ms=exposure_ms), right=replace(config.right, exposure_ms=exposure_ms))
    shipped = presets.PRESETS[preset]
    presets.PRESETS[preset] = replace(shipped, **changes)
    try:
        with open_rig(config, body, "max", seed) as rig, tempfile.TemporaryDirectory() as folder:
            assert rig.calibration is not None
            with CaseStore.create(Path(folder) / "case.impronta") as store:
                size = {"object_radius_mm": body.radius_mm, "object_height_mm": body.height_mm}
                runner = ScanRunner(rig, PlanRequest(views=views, points=points, **size), store)
                runner.start()
                runner.join()
                assert runner.result is not None
                if runner.result.error is not None:
                    raise runner.result.error
                assert runner.result.scan_id is not None
                measured = triangulate_observations(store.observations(runner.result.scan_id), rig.config, rig.calibration)
    finally:
        presets.PRESETS[preset] = shipped
    surface = ClosestPoint(body.mesh)

    def closest(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        foot, _, triangle = surface.query(places)
        return foot, surface.normals(triangle)

    cloud = measured.cloud
    assert cloud.covariances is not None
    motion = fit_rigid_to_surface(cloud.points, closest)
    placed = motion.apply(cloud.points)
    foot, normals = closest(placed)
    error = ((placed - foot) * normals).sum(axis=1)
    along = normals @ motion.rotation
    predicted = np.sqrt(np.einsum("ni,nij,nj->n", along, cloud.covariances, along))
    return error / predicted, 1e3 * error, measured.noise


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--points", type=int, default=3500)
    parser.add_argument("--views", type=int, default=8)
    parser.add_argument("--presets", nargs="+", default=["bench", "workshop"])
    parser.add_argument("--specimens", nargs="+", default=["sphere"])
    given = parser.parse_args()
    print("preset     specimen  change             error rms   z sd   z mean  |z|>4   found: pixel factor, angle, surface")
    for preset in given.presets:
        for specimen in given.specimens:
            for name, changes in CHANGES.items():
                z, error, noise = z_scores(preset, changes, specimen, given.points, given.views, given.seed)
                found = f"{noise.pixel_factor:.2f}, {1e6 * noise.angle_rad:.0f} urad, {noise.surface_um:.1f} um"
                far = np.mean(np.abs(z) > 4)
                print(f"{preset:<10} {specimen:<9} {name:<18} {error.std():6.1f} um {z.std():6.3f} {z.mean():8.2f} {far:7.4f}   {found}", flush=True)


if __name__ == "__main__":
    main()
