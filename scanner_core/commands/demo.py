"""``impronta demo``: the whole job on the virtual rig, from two cameras' frames to an STL."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from scanner_core import wall_clock
from scanner_core.acquisition.calibrating import calibrate_rig
from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.store import CaseStore, Order
from scanner_core.commands.calibration_report import calibration_json, calibration_summary
from scanner_core.commands.console import Console
from scanner_core.commands.demo_report import write_demo_report
from scanner_core.commands.line import line_request, line_warnings, lit_by
from scanner_core.commands.overwriting import check_case_free, overwriting
from scanner_core.commands.reconstructing import reconstruction_summary, run_reconstruction
from scanner_core.commands.scanning import begins, faults, run_scan, scan_json, scan_summary, sized_for, specimen_on_table, without_terms
from scanner_core.devices.marks_config import shipped_marks
from scanner_core.devices.rig import load_preset
from scanner_core.errors import StorageError, UsageError
from scanner_core.files import replaced_when_whole
from scanner_core.mesh_io import write_mesh
from scanner_core.metrology.truth_error import truth_error
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.reconstruction.parameters import ReconstructionParameters

CASE, MESHES, REPORT = "case.impronta", ("mesh.stl", "mesh.ply"), "report.pdf"


def run(given: argparse.Namespace, console: Console) -> int:
    config = lit_by(without_terms(load_preset(given.preset), given.without), given.line)
    if given.marks:
        config = replace(config, marks=shipped_marks(given.preset))
    if given.treated and given.specimen != "arch":
        raise UsageError("E-USE-01", what="Only the arch can be scanned after treatment", do="use --specimen arch --treated")
    if given.specimen == "ear-pair":
        do = "scan it with 'impronta scan --specimen ear-pair --out CASE', and make two cases of it with 'impronta split CASE'"
        raise UsageError("E-USE-01", what="A pair of ears is two objects, and this makes one surface", do=do)
    specimen = specimen_on_table(given, config)
    asked = {name: getattr(given, name) for name in ("views", "points", "until_um") if getattr(given, name) is not None}
    request = sized_for(line_request(config, PlanRequest(**asked), given.views), specimen)
    for warning in line_warnings(config):
        console.say(f"Warning: {warning}")
    to_come = faults(given, config)
    folder = _folder(given.out, specimen.name, given.force)
    old = (folder / CASE).exists()
    with open_rig(config, specimen, given.speed, given.seed) as rig:
        rig.calibration = _calibrate(rig, console)
        for fault in to_come:
            rig.inject(fault)
        with overwriting(folder / CASE, given.force) as begun, CaseStore.create(folder / CASE) as store:
            store.put_order(Order(number="demo", type=specimen.name))
            scan = run_scan(console, rig, request, store, begun=begun)
            values = scan_json(scan, rig.left.rate_hz, str(folder / CASE))
            values = {"specimen": specimen.name, "preset": given.preset, "seed": given.seed, "out": str(folder)} | values
            values["calibration"] = calibration_json(rig.calibration)
            lines = [calibration_summary(rig.calibration), *scan_summary(scan)]
            if scan.finish_reason is not FinishReason.COMPLETED or scan.views is None:
                kept = f"Nothing was measured; {folder / CASE} is as it was." if old and not begins(scan) else f"Kept in {folder / CASE}."
                console.result(values, [*lines, kept])
                if scan.error is not None:
                    console.say(str(scan.error))
                return 130 if scan.finish_reason is FinishReason.CANCELLED else 1
            parameters = ReconstructionParameters(triangles=given.triangles, seed=given.seed, table_mm=0.0)
            surface = run_reconstruction(console, scan.views.cloud, parameters)
            report = surface.report.as_dict()
            store.put_mesh(surface.mesh, {"parameters": parameters.as_dict(), "report": report, "seed": given.seed})
            for name in MESHES:
                write_mesh(folder / name, surface.mesh, force=given.force, remark="" if scan.marks is None else scan.marks.brief())
            error = truth_error(specimen, scan.views.cloud, surface.mesh, given.seed).as_dict()
            values |= {"reconstruct": report, "error_vs_truth_um": error}
            with replaced_when_whole(folder / REPORT, given.force) as partial:
                write_demo_report(partial, values, scan.views.cloud, surface.mesh)
            lines += reconstruction_summary(report)
            lines.append(
                f"Against the truth: points {error['points_rms']:.1f} um rms, surface {error['mesh_rms']:.1f} um rms, "
                f"95 % below {error['mesh_p95']:.1f} um, worst {error['mesh_max']:.1f} um."
            )
            console.result(values, [*lines, f"Written to {folder}: {CASE}, {', '.join(MESHES)}, {REPORT}."])
    return 0


def _calibrate(rig: OpenRig, console: Console) -> StereoCalibration:
    """A fresh calibration from rendered boards: nothing is measured with the renderer's own numbers."""
    result = calibrate_rig(rig, progress=lambda p: console.progress("calibrate", p.fraction, p.seconds_left))
    console.clear()
    return result.calibration


def _folder(out: str | None, specimen: str, force: bool) -> Path:
    if out is None:
        stamp = wall_clock.now().strftime("%Y%m%d-%H%M%S")
        folder = Path(f"impronta-{specimen}-{stamp}").resolve()
    else:
        folder = Path(out).resolve()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise StorageError("E-DISK-02", path=folder, reason=fault.strerror or fault) from fault
    for name in (CASE, *MESHES, REPORT):
        if (folder / name).exists():
            if not force:
                raise StorageError("E-DISK-03", path=folder / name)
            if name == CASE:
                check_case_free(folder / name, force)
    return folder
