"""Scan: numbers, the plan, both cameras, what was rejected and why, and the buttons; the live cloud stands beside it.

It shows three faces: before a scan what is asked of it, while it runs how it goes, and afterwards what it gave and what comes next.
"""

from __future__ import annotations

import time

import numpy as np

from app.faults import finding_words
from app.services import Services
from app.views import format as fmt
from app.views.camera_preview import CameraPreview
from app.views.chosen_view import ChosenView
from app.views.live_surface_line import live_surface_words
from app.views.page import Page
from app.views.parts import BigNumber, button, label, make_primary, row, seam
from app.views.plan_bar import PlanBar
from app.views.reject_list import RejectList
from app.views.scan_tray import ScanTray
from app.views.scan_wish import ScanWish, start_words
from app.views.scan_words import coverage_words, places_missing, step_words, summary_lines
from app.views.spot_advice import show_look
from scanner_core.acquisition.handover import Preview
from scanner_core.acquisition.status import FinishReason, ScanState, ScanStatus
from scanner_core.geometry.view_directions import seen_from

STATUS_PERIOD_S = 0.1
"""Numbers change no more often than this: nobody reads faster."""
PREVIEW_PERIOD_S = 0.1
"""A preview is repainted no more often than this: it is for the eye, the painting is for the points."""
_PREVIEW_HEIGHT = 60
"""The least; looking is what the Aim page is for."""


class ScanPage(Page):
    """Stands beside the live cloud."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        box = self.inspector(self.tr("Scan"))
        box.setSpacing(8)
        self._points = BigNumber(self.tr("points"))
        self._rate = BigNumber(self.tr("points / s"))
        self._time = BigNumber(self.tr("min:s left"))
        self._closure = BigNumber(self.tr("µm closure"))
        self._closure.setToolTip(self.tr("By how much the first view lay beside itself when it was measured again at the end of the turn"))
        numbers = row(self._points, self._rate, self._closure, self._time, spacing=6)
        for column, share in enumerate((5, 3, 4, 4)):
            numbers.setStretch(column, share)
        box.addLayout(numbers)
        self.plan = PlanBar()
        box.addWidget(self.plan)
        self._step = label("", wrap=True)
        box.addWidget(self._step)
        self.chosen = ChosenView()
        box.addWidget(self.chosen)
        self.summary = label("", "muted", wrap=True)
        self._surface = label("", "faint", wrap=True)
        self.coverage = label("", wrap=True)
        self.health = label("", "bad", wrap=True)
        for part in (self.summary, self._surface, self.coverage, self.health):
            part.hide()
            box.addWidget(part)
        self._previews = {"left": CameraPreview(self.tr("Camera left")), "right": CameraPreview(self.tr("Camera right"))}
        self._told_s = 0.0
        self._shown_s = dict.fromkeys(self._previews, 0.0)
        for preview in self._previews.values():
            preview.setMinimumHeight(_PREVIEW_HEIGHT)
            box.addWidget(preview, 3)
        self.rejects = RejectList()
        box.addWidget(self.rejects)
        box.addStretch(1)
        box.addWidget(seam())
        self.wish = ScanWish(services.draft)
        box.addLayout(self.wish)
        self.tray = ScanTray(services.pair_tray)
        box.addWidget(self.tray)
        self._wishing = False
        self.start = button(self.tr("Start scan"), "primary", self._start)
        self._pause = button(self.tr("Pause"), "", lambda: self.intent.emit("pause_scan"))
        self._stop = button(self.tr("Stop"), "laser", lambda: self.intent.emit("laser_off"))
        self._stop.setToolTip(self.tr("Laser off at once, and the end of the scan; what was measured is kept (Esc)"))
        self.next = button(self.tr("Reconstruct"), "primary", lambda: self.wanted.emit("reconstruct"))
        self.missing = button(self.tr("Complete"), "", lambda: self.intent.emit("coverage"))
        self.missing.setToolTip(self.tr("Places that are not as certain as wanted, why, and what can be done about them (F8)"))
        self.another = button(self.tr("Another mount"), "", lambda: self.intent.emit("another_mount"))
        self.another.setToolTip(self.tr("Set the object down in another way and scan it into the same case (F9)"))
        box.addLayout(row(self.missing, self.another))
        box.addWidget(self.next)
        box.addWidget(self.start)
        box.addLayout(row(self._pause, self._stop))
        self.plan.chosen.connect(self._look_at)
        self.chosen.again.connect(self._measure_again)
        services.acquisition.add_preview_sink(self._show_preview)
        services.acquisition.changed.connect(self._tick)
        services.acquisition.ended.connect(self._show_status)
        services.acquisition.began.connect(self._begin)
        services.case.opened.connect(self._forget)
        services.rig.changed.connect(self._show_buttons_if_seen)
        services.draft.changed.connect(lambda _: self._show_buttons_if_seen())
        services.live_surface.changed.connect(self._show_surface)
        self._show_status()

    def entered(self) -> None:
        self._show_status()

    # -------------------------------------------------------------------------------- showing
    def _show_surface(self) -> None:
        words = "" if self.services.acquisition.status is None else live_surface_words(self.services.live_surface)
        self._surface.setText(words)
        self._surface.setVisible(bool(words))

    def _begin(self) -> None:
        for preview in self._previews.values():
            preview.clear()
        self._forget()

    def _forget(self) -> None:
        """What was chosen belongs to the scan before."""
        self._wishing = False
        self.plan.choose(-1)
        self._show_status()

    def _show_preview(self, camera: str, preview: Preview) -> None:
        now = time.monotonic()
        widget = self._previews.get(camera)
        if widget is None or not self.isVisible() or now - self._shown_s[camera] < PREVIEW_PERIOD_S:
            return
        self._shown_s[camera] = now
        show_look(widget, preview, self.services.rig.snapshot.config)
        if self.services.acquisition.paused:
            widget.hush()

    def _tick(self) -> None:
        now = time.monotonic()
        if self.isVisible() and now - self._told_s >= STATUS_PERIOD_S:
            self._told_s = now
            self._show_status()

    def _show_status(self) -> None:
        acquisition, cloud = self.services.acquisition, self.services.case.cloud
        status, result = acquisition.status, acquisition.result
        ended = status is not None and status.finish_reason is not None
        if status is None:
            self._points.show_number(fmt.count(len(cloud)) if cloud is not None else fmt.NO_VALUE)
            self._rate.show_number(fmt.NO_VALUE)
            self._time.show_number(fmt.NO_VALUE)
            self._step.setText(self.tr("Starting…") if acquisition.running else self._readiness())
        else:
            self._points.show_number(fmt.count(status.counts.measured))
            self._rate.show_number(f"{status.rate_hz:.0f}" if status.state is ScanState.SCANNING else fmt.NO_VALUE)
            if status.state is not ScanState.PAUSED:  # what is left stays what it was
                self._time.show_number(fmt.left_time(status.seconds if ended else status.seconds_left))
            self._step.setText(step_words(status))
        if acquisition.paused:
            for preview in self._previews.values():
                preview.hush()  # the laser is dark: that there is no spot is as it should be
        self._time.show_unit(self.tr("min:s") if ended else self.tr("min:s left"))
        self._rate.setVisible(not ended)
        self._closure.setVisible(ended)
        self._closure.show_number(fmt.micrometres(None if result is None else result.closure_um))
        self._show_plan(status)
        lines = [] if result is None or acquisition.running else summary_lines(result)
        self.summary.setText("\n".join(lines))
        self.summary.setVisible(bool(lines))
        self._show_surface()
        self._show_health(status)
        self._show_coverage()
        self.rejects.setVisible(status is not None and status.state is not ScanState.PREPARING)  # most beams miss what is still being found
        if status is not None:
            self.rejects.show_counts(status.counts.measured, status.counts.rejected)
        self._show_buttons()

    def _show_plan(self, status: ScanStatus | None) -> None:
        acquisition = self.services.acquisition
        planned = 0 if status is None else status.views
        now = -1 if status is None or status.finish_reason is FinishReason.CANCELLED else status.view
        if status is not None and status.finish_reason is FinishReason.COMPLETED:
            now = planned
        self.plan.show_plan(acquisition.views, planned, now)
        self.plan.setVisible(bool(self.plan.views))
        self._show_chosen()

    def _show_chosen(self) -> None:
        status, rig = self.services.acquisition.status, self.services.rig.snapshot
        able = bool(self.services.acquisition.views)
        if self.services.acquisition.running:
            able &= status is not None and status.state in (ScanState.SCANNING, ScanState.PAUSED) and not status.closing
        else:
            able &= rig.connected and not rig.busy and self.services.case.store is not None
        self.chosen.show_view(self.plan.choice, able=able)

    def _show_health(self, status: ScanStatus | None) -> None:
        """The newest warning, and how many more there are; all of them on the pointer."""
        warnings = [finding for finding in (() if status is None else status.findings) if finding.severity == "warning"]
        told = [finding_words(finding) for finding in warnings]
        more = self.tr("  (and {count} more)").format(count=len(told) - 1) if len(told) > 1 else ""
        self.health.setText(told[-1] + more if told else "")
        self.health.setToolTip("\n\n".join(told))
        self.health.setVisible(bool(told))

    def _show_coverage(self) -> None:
        """At the end of an error-driven scan: what it has come to."""
        result = self.services.acquisition.result
        steering = None if result is None else result.steering
        words = "" if steering is None else coverage_words(steering)
        self.coverage.setText(words)
        self.coverage.setVisible(bool(words))

    def _readiness(self) -> str:
        rig = self.services.rig.snapshot
        if not rig.connected:
            return self.tr("The rig is not ready; the Rig page says why.") if rig.failure is not None else self.tr("Opening the rig…")
        return self.tr("Ready to scan") if rig.calibration is not None else self.tr("The rig has to be calibrated first.")

    def _show_buttons_if_seen(self) -> None:
        if self.isVisible():
            self._show_buttons()

    def _show_buttons(self) -> None:
        acquisition, rig = self.services.acquisition, self.services.rig.snapshot
        running = acquisition.running
        done = not running and self.services.case.cloud is not None
        for made in (self.next, self.missing, self.another):
            made.setVisible(done)
        lacking = done and acquisition.result is not None and places_missing(acquisition.result)
        make_primary(self.missing, lacking)
        make_primary(self.next, not lacking)
        for preview in self._previews.values():
            preview.setVisible(running)
        for made in (self._pause, self._stop):  # the rail has the stop on every page
            made.setVisible(running)
        asking = not running and (self._wishing or not done)
        self.wish.show_fields(asking)
        self.tray.show_field(asking)
        self.start.setVisible(not running)
        self.start.setText(start_words(self.services.draft.values, again=done) if asking else self.tr("Scan again…"))
        make_primary(self.start, not done)
        self.start.setEnabled(not asking or (rig.connected and not rig.busy and rig.calibration is not None))
        if acquisition.status is None and not running:
            self._step.setText(self._readiness())
        resting = acquisition.paused or (acquisition.status is not None and acquisition.status.pausing)
        self._pause.setText(self.tr("Resume") if resting else self.tr("Pause"))
        make_primary(self._pause, acquisition.paused)
        self._show_chosen()

    def _start(self) -> None:
        """After a scan, first let see what is asked of another one."""
        if self.services.case.cloud is not None and not self._wishing:
            self._wishing = True
            self._show_buttons()
        else:
            self.intent.emit("start_scan")

    # -------------------------------------------------------------------------------- one view
    def _look_at(self, number: int) -> None:
        """Tell of it; when nothing is measured, have the 3D view show its points from where the cameras saw them."""
        self._show_chosen()
        cloud, view = self.services.case.cloud, self.plan.choice
        if view is None or cloud is None or cloud.views is None or self.services.acquisition.running:
            return
        points = cloud.points[cloud.views == number]
        if len(points):
            self.flight.emit(points, seen_from(np.array([view.table_deg]))[0])

    def _measure_again(self, number: int) -> None:
        self.services.acquisition.measure_again(number)
        self._show_status()
