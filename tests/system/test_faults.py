"""A full disk and a killed worker: one sentence, nothing lost."""

from __future__ import annotations

import json
import shlex
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import psutil
import pytest

from scanner_core.case.store import CaseStore
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.mesh_io import write_points
from scanner_core.virtual.specimens import load_specimen
from tests.system.impronta import Outcome, balanced, command, environment, one_sentence


@pytest.mark.skipif(sys.platform == "win32", reason="ulimit is the shell's")
def test_a_disk_that_fills_up_ends_the_scan_in_one_sentence(tmp_path: Path) -> None:
    case = tmp_path / "a.impronta"
    words = shlex.join(command("scan", "--rig", "bench", "--specimen", "sphere", "--out", case, "--json"))
    # No file may grow over 400 kB: the same error comes back from the system as on a full disk.
    done = subprocess.run(["bash", "-c", f"ulimit -f 400; exec {words}"], capture_output=True, text=True, timeout=200, check=False, env=environment())
    assert done.returncode == 1, done
    values = json.loads(done.stdout)
    balanced(values)
    assert values["finish_reason"] == "failed"
    assert values["error"]["code"] == "E-DISK-01"
    assert len(done.stderr.strip().splitlines()) == 1, done.stderr
    with CaseStore.open(case) as store:
        kept = sum(sum(store.verdict_counts(scan.id).values()) for scan in store.scans())
    assert kept > 500


def test_a_killed_worker_is_reported_and_nothing_is_written(tmp_path: Path) -> None:
    vertices = load_specimen("ear").mesh.vertices
    points = vertices[np.random.default_rng(5).choice(len(vertices), 20_000, replace=False)]
    write_points(tmp_path / "ear.ply", PointCloud(points))
    words = command("reconstruct", tmp_path / "ear.ply", "--out", tmp_path / "ear.stl")
    program = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment())
    end_s = time.monotonic() + 60
    workers: list[psutil.Process] = []
    while not workers and time.monotonic() < end_s:
        workers = [child for child in psutil.Process(program.pid).children() if "spawn_main" in " ".join(child.cmdline())]
        time.sleep(0.02)
    while workers[0].cpu_times().user < 3.0 and time.monotonic() < end_s:  # past its imports, in the middle of the job
        time.sleep(0.02)
    workers[0].kill()
    out, err = program.communicate(timeout=60)
    one_sentence(Outcome(program.returncode, out, err), "E-JOB-01")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["ear.ply"]
