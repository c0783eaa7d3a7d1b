"""``impronta scan``: acquire into a new case, go on with an interrupted one, or add another mount of the object to a case."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from scanner_core.acquisition.plan import PlanRequest, read_plan
from scanner_core.acquisition.recording import check_recordable, recorded_plan
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.scan_result import ScanResult
from scanner_core.acquisition.status import FinishReason
from scanner_core.case.mount_registration import RegisteredMounts
from scanner_core.case.recovery import Interruption, describe, interruption
from scanner_core.case.store import CaseStore, Order
from scanner_core.commands.console import Console
from scanner_core.commands.line import line_request, line_warnings, lit_by
from scanner_core.commands.overwriting import check_case_free, overwriting
from scanner_core.commands.register import run_registration
from scanner_core.commands.scanning import (
    age_warnings,
    aimed_elsewhere,
    begins,
    calibrated_rig,
    case_as_found,
    faults,
    finding_warnings,
    is_rendered,
    recording,
    recording_warnings,
    run_scan,
    scan_json,
    scan_summary,
    sized_for,
    specimen_on_table,
)
from scanner_core.errors import AcquisitionError, UsageError
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.host_faults import WorkerFault
from scanner_core.virtual.specimens import Specimen


def run(given: argparse.Namespace, console: Console) -> int:
    if given.resume and (given.plan is not None or given.until_um is not None or given.force):
        raise UsageError(
            "E-USE-01", what="An interrupted scan goes on with its own plan, in its own case", do="leave --plan, --until-um and --force away"
        )
    if given.add_mount and (given.resume or given.force):
        raise UsageError("E-USE-01", what="Another mount is a new scan in a case that is there", do="leave --resume and --force away")
    config, calibration = calibrated_rig(given)
    if (aimed := aimed_elsewhere(given)) is not None:
        console.say(aimed)
    config = lit_by(config, given.line)
    if config.laser.is_line and given.record is not None:
        raise UsageError("E-USE-01", what="A scan by a laser line is not recorded", do="leave --record away")
    known = recorded_plan(config)
    request = known or PlanRequest()
    if given.plan is not None:
        request = read_plan(Path(given.plan))
        if known is not None:  # what a plan leaves open, the recording knows: the specimen's size, and whether views were repeated
            request = replace(
                request,
                object_radius_mm=request.object_radius_mm or known.object_radius_mm,
                object_height_mm=request.object_height_mm or known.object_height_mm,
                retry=known.retry,
            )
    if given.until_um is not None:
        request = replace(request, until_um=given.until_um)
    if known not in (None, request):  # frames of other table angles would pass for those that are asked for
        raise UsageError("E-USE-01", what="The recording was made with another plan", do="leave --plan and --until-um away")
    request = line_request(config, request, None if given.plan is None else request.views)
    specimen = specimen_on_table(given, config) if is_rendered(config) else None
    to_come = faults(given, config)
    if not given.resume:
        _check_steering(request, given, to_come)
    warnings = [*age_warnings(calibration), *line_warnings(config)]
    for warning in warnings:
        console.say(f"Warning: {warning}")
    if given.record is not None:
        check_recordable(Path(given.record).resolve())
    path = Path(given.out).resolve()
    old = given.force and path.exists()
    with case_as_found(path, to_come):
        if not (given.resume or given.add_mount):
            check_case_free(path, given.force)
        with (
            open_rig(config, specimen, given.speed, given.seed, to_come) as rig,
            overwriting(path, given.force) as begun,
            _case(path, given, specimen) as (store, interrupted),
        ):
            if interrupted is not None:
                _check_steering(interrupted.request, given, to_come)
            request = sized_for(request, specimen)
            mount = store.next_mount() if given.add_mount else 0
            if given.add_mount and (rest := describe(store)) is not None:
                warnings.append(f"The scan before this one did not come to its end ({rest.measured} of {rest.wanted} points); it stays as it is.")
                console.say(f"Warning: {warnings[-1]}")
            with recording(given, rig, request) as told:
                result = run_scan(console, rig, request, store, interrupted, begun, mount)
            values = scan_json(result, rig.left.rate_hz, str(path))
            mounts = _registered(console, store, result, given.seed)
            apart = None if mounts is None else mounts.error(store)
    warnings += finding_warnings(result)
    lines = scan_summary(result)
    if mounts is not None:
        values["mounts"] = mounts.as_dict()
        lines += mounts.summary()
    if told is not None:
        values["recording"] = told.as_dict()
        lines.append(told.summary())
        if result.error is None:  # else it is what ended the scan
            warnings += recording_warnings(console, told)
    values["warnings"] = warnings
    kept = f"Nothing was measured; {path} is as it was." if old and not begins(result) else f"Kept in {path}."
    if result.finish_reason is not FinishReason.COMPLETED and begins(result):
        kept += f" Go on with: impronta scan --rig {given.rig} --resume --out {path}" if given.rig is not None and not config.laser.is_line else ""
    elif result.steering is not None and result.steering.remount is not None and given.rig is not None:
        kept += f" Once the object is set down anew: impronta scan --rig {given.rig} --add-mount --out {path}"
    console.result(values, [*lines, kept])
    if result.error is not None:
        console.say(str(result.error))
    if apart is not None:
        console.say(str(apart))
        return 1
    return {FinishReason.COMPLETED: 0, FinishReason.CANCELLED: 130, FinishReason.FAILED: 1}[result.finish_reason]


def _check_steering(request: PlanRequest, given: argparse.Namespace, to_come: Sequence[Fault]) -> None:
    """What does not go together with a scan until an uncertainty, and what does with such a scan only; E-USE-01."""
    if given.record is not None and request.until_um is not None:  # a later version of this program may choose other angles
        raise UsageError("E-USE-01", what="The plan of a scan until an uncertainty is not known beforehand", do="record one without --until-um")
    if request.until_um is None and any(isinstance(fault, WorkerFault) for fault in to_come):
        raise UsageError("E-USE-01", what="This scan has no worker process that could fail", do="let that happen with --until-um")


def _registered(console: Console, store: CaseStore, result: ScanResult, seed: int) -> RegisteredMounts | None:
    """The mounts of the case after a scan that came to its end; None when there is one mount, or the scan is to be resumed first."""
    if result.finish_reason is not FinishReason.COMPLETED or store.next_mount() < 2:
        return None
    return run_registration(console, store, {}, seed=seed)


@contextmanager
def _case(path: Path, given: argparse.Namespace, specimen: Specimen | None) -> Iterator[tuple[CaseStore, Interruption | None]]:
    """The case to scan into, and what is to be resumed of it."""
    if given.resume:
        with CaseStore.open(path) as store:
            interrupted = interruption(store)
            if interrupted is None:
                raise AcquisitionError("E-SCAN-04", path=path)
            yield store, interrupted
        return
    if given.add_mount:
        with CaseStore.open(path) as store:
            yield store, None
        return
    with CaseStore.create(path) as store:
        if specimen is not None:
            store.put_order(Order(type=specimen.name))
        yield store, None
