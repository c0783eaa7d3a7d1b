"""Scan: numbers, both cameras, what was rejected and why, the plan, and the buttons; the live cloud stands beside it."""

from __future__ import annotations

import time

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QProgressBar, QWidget

from app.faults import finding_words
from app.services import Services
from app.views import format as fmt
from app.views.camera_preview import CameraPreview
from app.views.live_surface_line import live_surface_words
from app.views.page import Page
from app.views.parts import BigNumber, button, label, row, seam
from app.views.reasons import reason_text
from app.views.scan_wish import ScanWish, start_words
from app.views.scan_words import coverage_words, step_words
from app.views.spot_advice import show_look
from scanner_core.acquisition.handover import Preview
from scanner_core.acquisition.status import FinishReason, ScanState, ScanStatus

SHOWN_REASONS = 5
STATUS_PERIOD_S = 0.1
"""Numbers change no more often than this: nobody reads faster."""
PREVIEW_PERIOD_S = 0.1
"""A preview is repainted no more often than this: it is for the eye, the painting is for the points."""


class ScanPage(Page):
    """Stands beside the live cloud."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        box = self.inspector(self.tr("Scan"))
        box.setSpacing(8)  # all of it fits into a window of 800 pixels, with the line of the live surface
        self._points = BigNumber(self.tr("points"))
        self._rate = BigNumber(self.tr("points / s"))
        self._left = BigNumber(self.tr("left"))
        numbers = row(self._points, self._rate, self._left, spacing=6)
        for column, share in enumerate((5, 3, 4)):
            numbers.setStretch(column, share)
        box.addLayout(numbers)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._step = label("", "muted", wrap=True)
        box.addWidget(self._bar)
        box.addWidget(self._step)
        self._surface = label("", "faint", wrap=True)
        self._surface.hide()
        box.addWidget(self._surface)
        self.coverage = label("", wrap=True)
        self.coverage.hide()
        box.addWidget(self.coverage)
        self.health = label("", "bad", wrap=True)
        self.health.hide()
        box.addWidget(self.health)
        self._previews = {"left": CameraPreview(self.tr("Camera left")), "right": CameraPreview(self.tr("Camera right"))}
        self._told_s = 0.0
        self._shown_s = dict.fromkeys(self._previews, 0.0)
        for preview in self._previews.values():
            box.addWidget(preview, 3)
        self._rejected_title = label(self.tr("Rejected"), "section")
        self._rejected_total = label("", "muted")
        box.addLayout(row(self._rejected_title, 1, self._rejected_total))
        self._reasons = [(label("", "muted"), label("", "muted")) for _ in range(SHOWN_REASONS)]
        reasons = QGridLayout()
        reasons.setContentsMargins(0, 0, 0, 0)
        reasons.setVerticalSpacing(3)
        reasons.setColumnStretch(0, 1)
        for line, parts in enumerate(self._reasons):
            reasons.addWidget(parts[0], line, 0)
            reasons.addWidget(parts[1], line, 1, Qt.AlignmentFlag.AlignRight)
        box.addLayout(reasons)
        box.addStretch(1)
        box.addWidget(seam())
        self.wish = ScanWish(services.draft)
        box.addLayout(self.wish)
        self.start = button(self.tr("Start scan"), "primary", lambda: self.intent.emit("start_scan"))
        self._pause = button(self.tr("Pause"), "", lambda: self.intent.emit("pause_scan"))
        self._stop = button(self.tr("Stop · laser off"), "laser", lambda: self.intent.emit("laser_off"))
        self._next = button(self.tr("Reconstruct"), "primary", self._go_on)
        self.missing = button(self.tr("Coverage"), "", lambda: self.intent.emit("coverage"))
        self.missing.setToolTip(self.tr("Places that are not as certain as wanted, why, and what can be done about them (F8)"))
        self.another = button(self.tr("Another mount"), "", lambda: self.intent.emit("another_mount"))
        self.another.setToolTip(self.tr("Set the object down in another way and scan it into the same case (F9)"))
        box.addWidget(self._next)
        box.addLayout(row(self.missing, self.another))
        box.addWidget(self.start)
        box.addLayout(row(self._pause, self._stop))
        services.acquisition.add_preview_sink(self._show_preview)
        services.acquisition.changed.connect(self._tick)
        services.acquisition.ended.connect(self._show_status)
        services.acquisition.began.connect(self._begin)
        services.case.opened.connect(self._show_status)
        services.rig.changed.connect(self._show_buttons_if_seen)
        services.draft.changed.connect(lambda _: self._show_buttons_if_seen())
        services.live_surface.changed.connect(self._show_surface)
        self._show_status()

    def entered(self) -> None:
        self._show_status()

    # -------------------------------------------------------------------------------- showing
    def _show_surface(self) -> None:
        words = live_surface_words(self.services.live_surface)
        self._surface.setText(words)
        self._surface.setVisible(bool(words))

    def _begin(self) -> None:
        for preview in self._previews.values():
            preview.clear()
        self._show_status()

    def _show_preview(self, camera: str, preview: Preview) -> None:
        now = time.monotonic()
        widget = self._previews.get(camera)
        if widget is None or not self.isVisible() or now - self._shown_s[camera] < PREVIEW_PERIOD_S:
            return
        self._shown_s[camera] = now
        show_look(widget, preview, self.services.rig.snapshot.config)

    def _tick(self) -> None:
        now = time.monotonic()
        if self.isVisible() and now - self._told_s >= STATUS_PERIOD_S:
            self._told_s = now
            self._show_status()

    def _show_status(self) -> None:
        status = self.services.acquisition.status
        cloud = self.services.case.cloud
        if status is None:
            self._points.show_number(fmt.count(len(cloud)) if cloud is not None else fmt.NO_VALUE)
            self._rate.show_number(fmt.NO_VALUE)
            self._left.show_number(fmt.NO_VALUE)
            self._bar.setValue(0)
            self._step.setText(self.tr("Starting…") if self.services.acquisition.running else self._readiness())
        else:
            self._points.show_number(fmt.count(status.counts.measured))
            self._rate.show_number(f"{status.rate_hz:.0f}" if status.state is ScanState.SCANNING else fmt.NO_VALUE)
            self._left.show_number(fmt.left_time(status.seconds_left))
            self._bar.setValue(round(1000 * self._fraction(status)))
            self._step.setText(step_words(status))
        self._show_health(status)
        self._show_coverage()
        self._show_rejected(status)
        self._show_buttons()

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

    def _fraction(self, status: ScanStatus) -> float:
        """By points while they are counted against a wish, by trigger ids otherwise."""
        if status.finish_reason is not None:
            return 1.0 if status.finish_reason is FinishReason.COMPLETED else min(1.0, status.counts.measured / self.services.draft.values.points)
        if status.state is ScanState.PREPARING:
            return 0.0
        if status.seconds_left is not None:
            return status.seconds / max(status.seconds + status.seconds_left, 1e-9)
        return 0.0

    def _show_rejected(self, status: ScanStatus | None) -> None:
        rejected = {} if status is None else status.counts.rejected
        total = sum(rejected.values())
        self._rejected_total.setText(fmt.count(total) if total else self.tr("none"))
        ranked = sorted(rejected.items(), key=lambda entry: -entry[1])
        if len(ranked) > SHOWN_REASONS:
            rest = sum(number for _, number in ranked[SHOWN_REASONS - 1 :])
            ranked = [*ranked[: SHOWN_REASONS - 1], ("", rest)]
        for line, parts in enumerate(self._reasons):
            name, number = ranked[line] if line < len(ranked) else ("", 0)
            parts[0].setText(reason_text(name) if name else self.tr("other") if number else "")
            parts[1].setText(fmt.count(number) if number else "")
        self._rejected_title.setToolTip("\n".join(f"{reason_text(name)}: {fmt.count(number)}" for name, number in rejected.items()))

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
        self._next.setVisible(done)
        self.missing.setVisible(done)
        self.another.setVisible(done)
        for made in (self._pause, self._stop):  # the rail has the stop on every page
            made.setVisible(not done)
        self.start.setVisible(not running)
        self.start.setText(start_words(self.services.draft.values, again=done))
        self._set_role(self.start, "" if done else "primary")
        self.start.setEnabled(rig.connected and not rig.busy and rig.calibration is not None)
        if self.services.acquisition.status is None and not running:
            self._step.setText(self._readiness())
        self._pause.setEnabled(running)
        self._pause.setText(self.tr("Resume") if acquisition.paused else self.tr("Pause"))
        self._stop.setEnabled(running or rig.connected)
        self.wish.let_edit(not running)

    def _set_role(self, widget: QWidget, role: str) -> None:
        if widget.property("role") != role:
            widget.setProperty("role", role)
            widget.style().unpolish(widget)
            widget.style().polish(widget)

    def _go_on(self) -> None:
        self.wanted.emit("reconstruct")
