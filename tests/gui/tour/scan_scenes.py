"""Aim, scan, what is missing, and the object in another mount."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from unittest import mock

from app.controllers.aim_snapshot import AimJob
from app.views.aim_page import AimPage
from app.views.coverage_page import CoveragePage
from app.views.mounts_page import MountsPage
from app.views.pick_page import PickPage
from app.views.scan_page import ScanPage
from scanner_core.virtual import presets
from tests.gui.tour.prepared import PAIR
from tests.gui.tour.registry import scenes
from tests.gui.tour.tour import Tour
from tests.gui.waiting import until, wait_ms

_POINTS = 8000


@scenes("aim", "aim-learning", "aim-rejected")
def aim(tour: Tour) -> Iterator[str]:
    """On an object that shines like varnish."""
    rig, aiming, page = tour.services.rig, tour.services.aiming, tour.page("aim", AimPage)
    tour.rig_ready()
    before = rig.snapshot.specimen, rig.snapshot.speed
    with mock.patch.dict(presets.PRESETS, bench=replace(presets.PRESETS["bench"], specular=0.35)):
        rig.choose(specimen="heart", speed="1")
        tour.rig_ready()
        tour.window.show_page("aim")

        def idle() -> bool:
            return aiming.snapshot.live and aiming.snapshot.job is AimJob.NONE

        page.live.click()
        until(idle, 60, "the spot")
        until(lambda: page.pictures["left"].spot is not None, 30, "the spot in the picture")
        yield "aim"
        page.learn.click()
        until(lambda: (aiming.snapshot.fraction or 0.0) > 0.2, 60, "half of the learning")
        yield "aim-learning"
        until(idle, 60, "the end of the learning")
        if _beam_to_reasons(tour, page, idle):
            yield "aim-rejected"
        aiming.end()
    rig.choose(specimen=before[0], speed=before[1])
    tour.rig_ready()


def _beam_to_reasons(tour: Tour, page: AimPage, idle: object) -> bool:
    """The beam wanders over the shining object until there is something to tell."""
    assert callable(idle)
    aiming = tour.services.aiming
    for y_deg in (1.0, 2.0, 3.0, 4.0, 5.0):
        for x_deg in (-2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5):
            rig = tour.services.rig._devices.rig
            at = None if rig is None else rig.motion.newest
            assert at is not None
            aiming.touch()  # somebody is at it: the spot stays lit
            aiming.jog(x_deg=x_deg - at.x_deg, y_deg=y_deg - at.y_deg)
            wait_ms(50)
            until(idle, 30, "the move")
            wait_ms(400)
            reasons = [reason for picture in page.pictures.values() for _, _, reason in picture.reasons if reason]
            if len(reasons) >= 2:
                return True
    return False


@scenes("scan-before", "pair-tray")
def before_a_scan(tour: Tour) -> Iterator[str]:
    page = tour.page("scan", ScanPage)
    cases = Path(tour.services.settings.case_folder)
    tour.rig_ready()
    tour.services.worklist.look()
    until(lambda: len(tour.services.worklist.orders) >= 9, 90, "the orders")
    tour.services.case.open(cases / PAIR[0])
    until(lambda: tour.services.case.store is not None, 30, "the case")
    tour.window.show_page("scan")
    yield "scan-before"
    page.tray.click()
    tour.rig_ready()
    until(lambda: tour.services.pair_tray.wanted, 10, "the tray is wanted")
    yield "pair-tray"
    page.tray.click()
    tour.rig_ready()


@scenes("scan", "scan-paused", "scan-finished")
def scan(tour: Tour) -> Iterator[str]:
    services, window = tour.services, tour.window
    acquisition = services.acquisition
    tour.rig_ready()
    services.draft.edit("points", _POINTS)
    window.start_scan()
    until(lambda: acquisition.status is not None and acquisition.status.counts.measured > 0.5 * _POINTS, 400, "points")
    yield "scan"
    if acquisition.running:
        window.pause_scan()
        until(lambda: acquisition.paused or not acquisition.running, 60, "the pause")
        yield "scan-paused"
        if acquisition.paused:
            window.pause_scan()
    until(lambda: not acquisition.running, 400, "the end of the scan")
    wait_ms(1500)
    yield "scan-finished"


@scenes("complete", "another-mount")
def complete(tour: Tour) -> Iterator[str]:
    page = tour.page("coverage", CoveragePage)
    tour.open(tour.ear)
    tour.window.show_coverage()
    until(lambda: tour.services.coverage.found is not None, 400, "the coverage")
    found = tour.services.coverage.found
    assert found is not None
    until(lambda: len(tour.services.coverage.pictures.pictures) >= min(3, len(found.report.places)), 60, "the thumbnails")
    page.places.setCurrentRow(0)
    wait_ms(1500)
    yield "complete"
    tour.window.show_mounts()
    wait_ms(500)
    yield "another-mount"


@scenes("mounts")
def mounts(tour: Tour) -> Iterator[str]:
    tour.open(tour.copied(tour.prepared.mounts, "2026-0137_left_ear.impronta"))
    tour.window.show_mounts()
    until(lambda: tour.services.mounts.found is not None, 400, "how the mounts lie")
    wait_ms(1500)
    yield "mounts"


@scenes("mount-refused", "pick")
def refused_mount(tour: Tour) -> Iterator[str]:
    """A ball looks the same from everywhere: the pose is refused, and points may be picked."""
    services, window, rig = tour.services, tour.window, tour.services.rig
    before = rig.snapshot.specimen
    rig.choose(specimen="sphere")
    tour.rig_ready()
    services.draft.edit("points", 1500)
    services.draft.edit("views", 8)
    window.start_scan()
    until(lambda: services.acquisition.running, 20, "the scan of the ball")
    until(lambda: not services.acquisition.running, 400, "its end")
    window.show_mounts()
    page = tour.page("mounts", MountsPage)
    page.tip.click()
    until(lambda: not services.mounts.tipping and page.scan.isEnabled(), 120, "the object in another mount")
    page.scan.click()
    until(lambda: services.acquisition.running, 20, "the scan of the mount")
    until(lambda: not services.acquisition.running, 600, "its end")
    until(lambda: services.mounts.found is not None, 400, "how the mounts lie")
    wait_ms(1500)
    yield "mount-refused"
    window.show_page("pick")
    picking = tour.page("pick", PickPage)
    until(lambda: picking.views, 60, "the two clouds")
    wait_ms(1000)
    for side, view in picking.views.items():
        for right in (0.45, 0.55):
            if (point := view.point_at(right * view.width(), 0.5 * view.height())) is not None:
                services.mount_picks.pick(side, point)
    yield "pick"
    services.draft.edit("views", 16)
    rig.choose(specimen=before)
    tour.rig_ready()
