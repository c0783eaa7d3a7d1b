"""A program that tells what it was promised: ``python -m tests.long.acknowledging MODE CASE [SERIAL WITNESS]``.

It prints ``ready`` when the work begins and ``ack N`` after every call of the case store that has returned, N being all
observations (mode ``scan`` and ``pause``) or all meshes and edits (mode ``reconstruct`` and ``save``) acknowledged so far.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from scanner_core.acquisition.plan import PlanRequest
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.acquisition.runner import ScanRunner
from scanner_core.case.observation import StereoObservation
from scanner_core.case.processing import case_cloud
from scanner_core.case.store import CaseStore, Order
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.rig import load_preset
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.reconstruction.job import ReconstructionRequest
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.report import Reconstruction
from scanner_core.virtual.specimens import load_specimen


def tell(words: str) -> None:
    """At once and whole, whatever becomes of this process."""
    os.write(1, f"{words}\n".encode())


class AcknowledgingStore(CaseStore):
    """Says so when an append has returned."""

    appended = 0

    def append(self, scan_id: int, observations: Sequence[StereoObservation]) -> None:
        super().append(scan_id, observations)
        self.appended += len(observations)
        tell(f"ack {self.appended}")


def scan(case: Path, controller: ControllerConfig, *, pausing: bool) -> None:
    """At speed 1; with `pausing` it rests every other half second."""
    config = replace(load_preset("bench"), controller=controller)
    specimen = load_specimen("sphere")
    with AcknowledgingStore.create(case) as store, open_rig(config, specimen, seed=1) as rig:
        runner = ScanRunner(rig, PlanRequest(2, 200, specimen.radius_mm, specimen.height_mm), store)
        tell("ready")
        runner.start()
        while not runner.join(0.5):
            if pausing:
                runner.pause()
                time.sleep(0.5)
                runner.resume()


def reconstruct(case: Path) -> None:
    """Again and again, the mesh into the case each time."""
    with CaseStore.open(case) as store:
        cloud = case_cloud(store)
        done = 0
        tell("ready")
        while True:
            request = ReconstructionRequest(cloud, ReconstructionParameters(table_mm=0.0, seed=done))
            result = run_in_worker("reconstruct", request, progress=lambda _: None, cancelled=lambda: False)
            assert isinstance(result, Reconstruction)
            store.put_mesh(result.mesh, {"seed": done})
            done += 1
            tell(f"ack {done}")


def save(case: Path) -> None:
    """Meshes and orders in turn, without a rest."""
    with CaseStore.open(case) as store:
        mesh = load_specimen("sphere").mesh
        done = 0
        tell("ready")
        while True:
            if done % 2:
                store.put_order(Order(number=str(done + 1)))
            else:
                store.put_mesh(replace(mesh, vertices=mesh.vertices + np.float64(done)), {"seed": done})
            done += 1
            tell(f"ack {done}")


def main(mode: str, case: Path, serial: str = "", witness: str = "") -> None:
    if mode in ("scan", "pause"):
        scan(case, ControllerConfig("grbl", serial, witness=witness), pausing=mode == "pause")
    else:
        {"reconstruct": reconstruct, "save": save}[mode](case)
    tell("done")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), *sys.argv[3:])
