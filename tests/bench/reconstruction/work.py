"""One mesh in a fresh process: ``python -m tests.bench.reconstruction.work JOB.json``.

The job names the points, who is to work (ours or a peer), and where mesh and outcome go.  Imports are not counted.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from scanner_core.geometry.mesh import TriangleMesh
from tests.bench.reconstruction.implicit import Array
from tests.bench.reconstruction.peers import Peer

LIMIT_S = 900.0


@dataclass(frozen=True, slots=True, eq=False)
class Made:
    """What a process made of points: a mesh, or `failure`, a sentence.

    Attributes
    ----------
    seconds : of the work, without imports and files
    process_seconds : of the whole process
    peak_memory_mb : of the whole process
    report : of ours
    """

    mesh: TriangleMesh | None = None
    failure: str = ""
    seconds: float = float("nan")
    process_seconds: float = float("nan")
    peak_memory_mb: float = float("nan")
    report: dict[str, Any] = field(default_factory=dict)


def ours(points: Array, triangles: int | None = None, *, criterion: str | None = None, table_mm: float | None = None) -> Made:
    """Reconstruct in a fresh process with one thread; a `criterion` by its value."""
    job = {"who": "ours", "triangles": triangles, "criterion": criterion, "table_mm": table_mm}
    return _made(points, job, {"OMP_NUM_THREADS": "1"})


def theirs(peer: Peer, points: Array) -> Made:
    """A peer in a fresh process with the threads that it takes by default."""
    return _made(points, {"who": peer.kind, "settings": dict(peer.settings)}, {})


def _made(points: Array, job: dict[str, Any], environment: dict[str, str]) -> Made:
    with tempfile.TemporaryDirectory(prefix="impronta-bench-") as folder:
        job |= {"points": f"{folder}/points.npy", "mesh": f"{folder}/mesh.npz", "outcome": f"{folder}/outcome.json"}
        np.save(job["points"], points)
        file = Path(folder) / "job.json"
        file.write_text(json.dumps(job))
        command = [sys.executable, "-m", "tests.bench.reconstruction.work", str(file)]
        begin_s = time.perf_counter()
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S, env=os.environ | environment, check=False)
        except subprocess.TimeoutExpired:
            return Made(failure=f"no mesh after {LIMIT_S:.0f} s")
        process_seconds = time.perf_counter() - begin_s
        outcome_file = Path(job["outcome"])
        if not outcome_file.exists():
            said = [line for line in done.stderr.splitlines() if line.strip()]
            return Made(failure=f"ended with {done.returncode}: {said[-1] if said else 'nothing said'}", process_seconds=process_seconds)
        outcome = json.loads(outcome_file.read_text())
        mesh = None
        if not outcome["failure"]:
            with np.load(job["mesh"]) as stored:
                attributes = {name: stored[name] for name in stored.files if name not in ("vertices", "triangles")}
                mesh = TriangleMesh(stored["vertices"], stored["triangles"], attributes)
        return Made(mesh, process_seconds=process_seconds, **outcome)


def _reconstruct(job: dict[str, Any], points: Array) -> tuple[TriangleMesh, float, dict[str, Any]]:
    from scanner_core.geometry.point_cloud import PointCloud
    from scanner_core.reconstruction.error_function import Criterion
    from scanner_core.reconstruction.parameters import ReconstructionParameters
    from scanner_core.reconstruction.pipeline import reconstruct

    wanted = {} if job["criterion"] is None else {"criterion": Criterion(job["criterion"])}
    parameters = ReconstructionParameters(triangles=job["triangles"], table_mm=job["table_mm"], **wanted)
    begin_s = time.perf_counter()
    result = reconstruct(PointCloud(points), parameters, progress=lambda _: None, cancelled=lambda: False)
    return result.mesh, time.perf_counter() - begin_s, result.report.as_dict()


def _peer(job: dict[str, Any], points: Array) -> tuple[TriangleMesh, float, dict[str, Any]]:
    peer = Peer(job["who"], tuple(job["settings"].items()), "")
    peer.warm_up()
    begin_s = time.perf_counter()
    vertices, triangles = peer.run(points)
    return TriangleMesh(vertices, triangles), time.perf_counter() - begin_s, {}


def _peak_memory_mb() -> float:
    """Most that this process has held; on Linux ``ru_maxrss`` would count what the parent held when it started this one."""
    status = Path("/proc/self/status")
    if status.exists():
        peak = next((line for line in status.read_text().splitlines() if line.startswith("VmHWM:")), None)
        if peak is not None:
            return int(peak.split()[1]) / 2**10
    if sys.platform == "win32":
        return float("nan")
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (2**20 if sys.platform == "darwin" else 2**10)


def main() -> int:
    job = json.loads(Path(sys.argv[1]).read_text())
    points = np.load(job["points"])
    outcome: dict[str, Any] = {"failure": ""}
    try:
        mesh, seconds, report = (_reconstruct if job["who"] == "ours" else _peer)(job, points)
        outcome |= {"seconds": seconds, "report": report}
        if len(mesh.triangles) == 0:
            outcome["failure"] = "the mesh has no triangles"
        np.savez(job["mesh"], vertices=mesh.vertices, triangles=mesh.triangles, **mesh.vertex_attributes)
    except Exception as error:  # whatever it is becomes a row of the table
        outcome["failure"] = f"{type(error).__name__}: {error}"
    outcome["peak_memory_mb"] = _peak_memory_mb()
    Path(job["outcome"]).write_text(json.dumps(outcome))
    return 0


if __name__ == "__main__":
    sys.exit(main())
