"""The strip over Home when a scan did not come to its end: what there is of it, and what may be done with it."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QVBoxLayout

from app.services import Services
from app.theme import Sign
from app.views import format as fmt
from app.views.parts import button, label, row


class InterruptedStrip(QFrame):
    """Hidden while there is nothing to offer."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        recovery = services.recovery
        self.setProperty("role", "banner")
        mark = Sign(22, "warning", "warning")
        self._what = label("", wrap=True)
        self._what.setStyleSheet("font-weight: 600;")
        self._how = label("", "muted", wrap=True)
        words = QVBoxLayout()
        words.setSpacing(2)
        words.addWidget(self._what)
        words.addWidget(self._how)
        self.resume = button(self.tr("Resume"), "primary", recovery.resume)
        self.keep = button(self.tr("Keep what is there"), "", recovery.keep)
        self.discard = button(self.tr("Discard"), "", recovery.discard)
        self.undo = button(self.tr("Undo"), "", recovery.undo_discard)
        line = row(mark, words, self.resume, self.keep, self.discard, self.undo, spacing=10)
        line.setStretch(1, 1)
        line.setAlignment(mark, Qt.AlignmentFlag.AlignTop)
        line.setContentsMargins(24, 12, 24, 12)
        self.setLayout(line)
        recovery.changed.connect(self.show_scan)
        services.rig.changed.connect(self._show_buttons)
        self.show_scan()

    @property
    def text(self) -> str:
        """All that it says, or an empty text."""
        return "" if self.isHidden() else f"{self._what.text()} {self._how.text()}".strip()

    def show_scan(self) -> None:
        """The newest interrupted scan, or the one that was just discarded."""
        recovery = self._services.recovery
        scan, gone = recovery.scan, recovery.discarded
        self.setVisible(scan is not None or gone is not None)
        for part, shown in ((self.resume, scan), (self.keep, scan), (self.discard, scan), (self.undo, gone)):
            part.setVisible(shown is not None if part is not self.undo else scan is None and gone is not None)
        if scan is not None:
            order = scan.order.number or scan.path.stem
            self._what.setText(self.tr("The scan of {order} did not come to its end.").format(order=order))
            how = self.tr("{measured} of {wanted} points, {done} of {views} views complete; begun {when}.").format(
                measured=fmt.count(scan.measured),
                wanted=fmt.count(scan.wanted),
                done=scan.views_done,
                views=scan.views,
                when=_when(scan.started),
            )
            why = self.tr("The program ended in the middle of it.") if scan.reason is None else self.tr("A fault ended it.")
            more = self.tr("There are {n} more.").format(n=recovery.more) if recovery.more else ""
            self._how.setText(" ".join(part for part in (how, why, more) if part))
            self.resume.setToolTip(self.tr("Put the same object back: known points are measured again, and only what is missing is scanned."))
            self.keep.setToolTip(self.tr("Take what was measured for the whole, and open the case."))
            self.discard.setToolTip(self.tr("Leave it out of the case; nothing is deleted."))
        elif gone is not None:
            self._what.setText(self.tr("The scan of {order} was discarded.").format(order=gone.order.number or gone.path.stem))
            self._how.setText(self.tr("Nothing was deleted."))
        self._show_buttons()

    def _show_buttons(self) -> None:
        rig, recovery = self._services.rig.snapshot, self._services.recovery
        free = not recovery.busy and not self._services.acquisition.running
        self.resume.setEnabled(free and rig.connected and not rig.busy and rig.calibrating is None and rig.calibration is not None)
        for part in (self.keep, self.discard, self.undo):
            part.setEnabled(free)


def _when(moment: str) -> str:
    """Day and time of the person's own clock."""
    try:
        here = datetime.fromisoformat(moment).astimezone()
    except ValueError:
        return moment
    return f"{fmt.day(here.isoformat())}, {here:%H:%M}"
