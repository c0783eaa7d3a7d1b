"""The Reconstruct page on a cloud of its own: progress, cancel, and a worker that dies."""

from __future__ import annotations

import os
import signal

import numpy as np
import pytest

from app.program import Program
from scanner_core.geometry.point_cloud import PointCloud
from tests.gui.waiting import until, wait_ms


@pytest.fixture
def ready(program: Program) -> Program:
    """A window with the points of a ball of 10 mm, seed 3, and a worker that is there."""
    rng = np.random.default_rng(3)
    points = rng.normal(size=(6000, 3))
    points *= 10 / np.sqrt((points**2).sum(axis=1))[:, None]
    until(lambda: program.services.reconstruction.worker_pid is not None, 60, "the worker")
    program.services.case.take_cloud(PointCloud(points + np.array([0.0, 0.0, 10.0])), {})
    return program


def test_a_cancelled_reconstruction_ends_within_a_second_and_without_a_sentence(ready: Program) -> None:
    job = ready.services.reconstruction
    ready.window.start_reconstruction()
    until(lambda: job.progress is not None, 60, "progress")
    assert ready.window.page_id == "reconstruct"
    job.cancel()
    assert job.cancelling
    until(lambda: not job.running, 10, "the end")
    assert ready.services.case.surface is None
    wait_ms(200)
    assert ready.window.banner.text == ""


def test_a_killed_worker_is_told_and_the_next_run_succeeds(ready: Program) -> None:
    job, case = ready.services.reconstruction, ready.services.case
    ready.window.start_reconstruction()
    until(lambda: job.progress is not None, 60, "progress")
    assert job.worker_pid is not None
    os.kill(job.worker_pid, signal.SIGKILL)
    until(lambda: ready.window.banner.text, 20, "the sentence")
    assert "worker process ended unexpectedly" in ready.window.banner.text
    assert "E-JOB-01" in ready.window.banner.details
    assert not job.running
    assert case.cloud is not None
    ready.window.start_reconstruction()
    assert ready.window.banner.text == ""
    until(lambda: case.surface is not None or ready.window.banner.text, 120, "the surface")
    assert ready.window.banner.text == ""
    assert case.report["closed"] is True
