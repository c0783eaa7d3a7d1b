"""Scanning where the error is against the uniform plan, on the virtual rig with rendered frames, in one run.

    python -m tests.bench.adaptive --specimen ear --points 12000 --seed 1 [--until-um 5] [--share 0.6] [--out DIR]

Both scans see the same specimen with the same rig, calibration and seed, and both clouds are reconstructed with the same
settings.  The error is the distance of places of the true surface from the mesh, over all of it that beam and cameras can
reach at some table angle (ray casting against the truth): a place that a scan has left out counts in full.  Beside it stands
the error over the surface that the scan itself calls supported, as ``impronta scan`` tells it.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from dataclasses import replace
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.case.store import CaseStore
from scanner_core.commands.scanning import sized_for
from scanner_core.devices.rig import load_preset
from scanner_core.metrology.truth_error import truth_error
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.pipeline import reconstruct
from scanner_core.virtual.specimens import Specimen, load_specimen
from tests.bench.adaptive.truth import SeeableTruth

_UNIFORM_VIEWS = 16


def main() -> None:
    given = _arguments()
    config = load_preset(given.preset)
    specimen = load_specimen(given.specimen)
    assert config.calibration is not None
    truth = SeeableTruth(specimen.mesh, config, config.calibration)
    print(f"{specimen.name}: {100 * truth.share:.1f} % of its surface can be seen; seed {given.seed}", flush=True)
    uniform = sized_for(PlanRequest(views=_UNIFORM_VIEWS, points=given.points), specimen)
    plans = {"uniform": uniform}
    for share in given.share:
        plans[f"driven {share:g}"] = replace(uniform, points=round(share * given.points), until_um=given.until_um)
    if given.only is not None:
        plans = {name: plan for name, plan in plans.items() if name.startswith(given.only)}
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(given.out or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for name, request in plans.items():
            begin_s = time.monotonic()
            path = folder / f"{specimen.name}-{given.seed}-{name.replace(' ', '-')}.impronta"
            path.unlink(missing_ok=True)
            with open_rig(config, specimen, "max", given.seed) as rig, CaseStore.create(path) as store:
                runner = ScanRunner(rig, request, store)
                runner.start()
                runner.join()
            result = runner.result
            assert result is not None
            if result.error is not None:
                raise result.error
            rows.append({"specimen": specimen.name, "seed": given.seed, "plan": name} | _judged(result, truth, specimen, given))
            rows[-1]["wall_s"] = round(time.monotonic() - begin_s)
            print(json.dumps(rows[-1]), flush=True)
    first = rows[0]
    for row in rows[1:]:
        ratio, share = float(str(row["seen_rms_um"])) / float(str(first["seen_rms_um"])), int(str(row["points"])) / int(str(first["points"]))
        print(f"{specimen.name} {row['plan']}: {share:.2f} of the points, {ratio:.2f} of the error, {row['rig_s']} s instead of {first['rig_s']} s")


def _judged(result: ScanResult, truth: SeeableTruth, specimen: Specimen, given: argparse.Namespace) -> dict[str, object]:
    assert result.views is not None
    cloud = result.views.cloud
    surface = reconstruct(cloud, ReconstructionParameters(seed=given.seed, table_mm=0.0), progress=lambda _: None, cancelled=lambda: False)
    seen = truth.judge(surface.mesh, cloud, given.within_um)
    contract = truth_error(specimen, cloud, surface.mesh, given.seed)
    return {
        "points": len(cloud),
        "exposures": result.exposures,
        "rig_s": round(result.rig_s),
        "views": len({int(view) for view in cloud.views}) if cloud.views is not None else 0,
        "seen_rms_um": round(seen.rms_um, 2),
        "seen_p50_um": round(seen.p50_um, 2),
        "seen_p95_um": round(seen.p95_um, 2),
        "seen_max_um": round(seen.max_um),
        "seen_within": round(seen.within, 4),
        "supported_rms_um": round(contract.mesh_rms, 2),
        "supported_p95_um": round(contract.mesh_p95, 2),
        "supported_share": surface.report.as_dict()["supported_area_fraction"],
        "expected_um": surface.report.as_dict()["expected_error_rms_um"],
    }


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.bench.adaptive", description=__doc__)
    parser.add_argument("--specimen", default="ear", help="ear, arch, heart, sphere or a mesh file")
    parser.add_argument("--preset", default="bench")
    parser.add_argument("--points", type=int, default=12_000, help="of the uniform plan")
    parser.add_argument("--share", type=float, action="append", help="of these points for the error-driven scan; may be given several times")
    parser.add_argument("--until-um", type=float, default=5.0, help="uncertainty that is asked for; a low one spends all points")
    parser.add_argument("--within-um", type=float, default=20.0, help="count the seeable surface that claims at most this uncertainty")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one of the plans: uniform, driven")
    parser.add_argument("--out", help="keep the cases here")
    given = parser.parse_args()
    given.share = given.share or [0.6]
    return given


if __name__ == "__main__":
    main()
