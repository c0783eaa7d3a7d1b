"""Reconstructions of several orders: kept early, queued, and not in the way of what is looked at."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.controllers.reconstruction_queue import MOST_WAITING, ReconstructionQueue, WantedSurface, parameters_of
from app.draft import DraftValues
from app.program import Program
from app.views.reconstruct_page import ReconstructPage
from scanner_core.case.store import CaseStore
from scanner_core.geometry.checks import check_mesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.jobs.messages import JobDone, JobEvent, JobProgress
from scanner_core.jobs.worker import JobHandle
from scanner_core.reconstruction.job import ReconstructionRequest
from scanner_core.reconstruction.parameters import ReconstructionParameters
from scanner_core.reconstruction.report import Reconstruction
from tests.gui.waiting import until

SEEN_ALL_ROUND: dict[str, object] = {"processing": {"mounts": [1, 2]}}
"""What the points come from: nothing is filled down to the table."""


def ball(count: int = 6000) -> PointCloud:
    """Points of a ball of 10 mm that stands on the table, 20 um of noise, seed 3."""
    rng = np.random.default_rng(3)
    points = rng.normal(size=(count, 3))
    points *= (10 + 0.02 * rng.normal(size=(count, 1))) / np.sqrt((points**2).sum(axis=1))[:, None]
    return PointCloud(points + np.array([0.0, 0.0, 10.0]))


def order(program: Program, number: str, cloud: PointCloud) -> Path:
    """A new case with points, which is then open."""
    services, made = program.services, []
    services.case.close()
    services.draft.put("order", number)
    services.case.create(made.append)
    until(lambda: made, 20, "the case")
    services.case.take_cloud(cloud, SEEN_ALL_ROUND)
    services.case.opened.emit()
    return made[0].path


@pytest.fixture
def idle(shared_program: Program) -> Iterator[Program]:
    yield shared_program
    job = shared_program.services.reconstruction
    for wanted in job.queue.waiting:
        job.drop(wanted)
    if job.running:
        job.cancel()
    until(lambda: not job.running, 20, "the end")
    shared_program.services.case.close()
    shared_program.window.banner.dismiss()


def page_of(program: Program) -> ReconstructPage:
    page = program.window.pages["reconstruct"]
    assert isinstance(page, ReconstructPage)
    return page


def test_what_is_kept_early_is_closed_and_says_so_in_its_case(idle: Program) -> None:
    job, case = idle.services.reconstruction, idle.services.case
    order(idle, "2026-0201", ball())
    idle.window.start_reconstruction()
    page_of(idle).enough.click()  # in phase one: the first surface that reaches the points is kept
    assert job.ending_early
    assert not page_of(idle).enough.isEnabled()
    until(lambda: case.surface is not None or idle.window.banner.text, 60, "the surface")
    assert idle.window.banner.text == ""
    assert case.surface is not None
    checks = check_mesh(case.surface.mesh)
    assert checks.closed
    assert checks.manifold
    assert checks.outward
    assert len(case.surface.mesh.triangles) < 16_000  # fewer than any that is not stopped
    assert set(case.surface.mesh.vertex_attributes) == {"standard_uncertainty_um", "supported"}
    assert case.provenance["stopped_early"] is True
    assert "Kept early" in page_of(idle).verdict.text()


def test_phase_two_ends_at_once_in_the_worker_for_one_who_is_content(idle: Program) -> None:
    worker = idle.services.reconstruction._ready_worker()
    handles: list[JobHandle] = []
    phases: list[str] = []

    def hear(event: JobEvent) -> None:
        if isinstance(event, JobProgress):
            phases.append(event.progress.phase)
            if event.progress.phase == "refine" and event.progress.preview is not None:
                handles[0].end_early()

    handles.append(worker.submit("reconstruct", ReconstructionRequest(ball(20_000), ReconstructionParameters()), hear))
    until(lambda: handles[0].outcome, 60, "the surface")
    outcome = handles[0].outcome
    assert isinstance(outcome, JobDone)
    assert isinstance(outcome.result, Reconstruction)
    assert outcome.result.report.stopped_early
    checks = check_mesh(outcome.result.mesh)
    assert checks.closed
    assert checks.manifold
    assert phases[-1] == "smooth"


def test_the_next_order_is_looked_at_while_this_one_is_reconstructed(idle: Program) -> None:
    window, job, case = idle.window, idle.services.reconstruction, idle.services.case
    first = order(idle, "2026-0202", ball(20_000))
    window.start_reconstruction()
    until(lambda: job.shown_triangles is not None, 60, "a balloon")
    assert job.mine
    order(idle, "2026-0203", ball())
    window.start_reconstruction()
    assert job.waits
    assert not job.mine
    assert [line.wanted.values.order for line in page_of(idle).waiting.lines] == ["2026-0203"]
    assert window.scene is not None
    assert window.scene.mesh.surface is None  # the balloon is another order's
    window.show_page("home")
    assert "2026-0202" in window.status_line.reconstruction.text()
    assert window.status_line.reconstruction.isVisibleTo(window)
    until(lambda: window.banner.text, 60, "the note")
    assert "2026-0202" in window.banner.text
    assert window.page_id == "home"  # nothing was taken out of the person's hands
    with CaseStore.open(first, read_only=True) as store:
        assert store.mesh_count() == 1
    until(lambda: case.surface is not None, 60, "the surface of the second")
    assert case.report["points"] == 6000
    window.banner.offer.click()
    until(lambda: case.path == first and case.surface is not None, 20, "the first again")
    assert window.banner.text == ""


def test_a_scan_may_begin_while_an_order_is_reconstructed(idle: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[object] = []
    monkeypatch.setattr(idle.services.acquisition, "start", begun.append)
    order(idle, "2026-0204", ball(20_000))
    idle.window.start_reconstruction()
    assert idle.services.reconstruction.running
    idle.window.start_scan()
    assert len(begun) == 1


def test_wishes_are_edits_and_go_back_to_their_defaults_in_one_step(idle: Program) -> None:
    draft, wishes = idle.services.draft, page_of(idle).wishes
    order(idle, "2026-0205", ball())
    wishes.slider.setValue(-1)
    assert draft.values.detail == -1
    draft.edit("smoothing", 5)
    wishes.expert.back.click()
    assert (draft.values.detail, draft.values.smoothing) == (0, 3)
    idle.undo_stack.undo()
    assert (draft.values.detail, draft.values.smoothing) == (-1, 5)
    idle.undo_stack.undo()
    idle.undo_stack.undo()
    assert (draft.values.detail, wishes.slider.value()) == (0, 0)


def wanted(name: str) -> WantedSurface:
    return WantedSurface(Path(name), PointCloud(np.zeros((1, 3))), {}, DraftValues(order=name))


def test_a_queue_is_bounded_and_keeps_a_case_once() -> None:
    queue = ReconstructionQueue()
    for name in "ABCD":
        assert queue.put(wanted(name))
    assert queue.full
    assert len(queue.waiting) == MOST_WAITING
    assert not queue.put(wanted("E"))
    assert queue.put(wanted("B"))  # the newer wish in the place of the older
    queue.hurry(queue.waiting[2])
    queue.hurry(queue.waiting[0])  # it is first already
    queue.drop(queue.waiting[3])
    assert [one.values.order for one in queue.waiting] == ["A", "C", "B"]
    first = queue.take()
    assert first is not None
    assert first.values.order == "A"
    queue.hurry(first)  # it waits no longer
    queue.drop(first)
    assert [one.values.order for one in queue.waiting] == ["C", "B"]


def test_the_form_asks_for_what_the_core_does_by_itself() -> None:
    assert parameters_of(wanted("A")) == ReconstructionParameters(table_mm=0.0)
