"""Another mount: what to do with the object, its scan, and how the mounts lie on each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFrame, QLabel, QProgressBar, QVBoxLayout, QWidget

from app.services import Services
from app.theme import Sign
from app.views.aside import Aside
from app.views.coverage_words import remount_words
from app.views.mount_words import mount_colour, mount_line, mount_title, refusal
from app.views.page import Page
from app.views.parts import button, label, make_primary, row, scrolled, seam

if TYPE_CHECKING:
    from scanner_core.acquisition.remount import RemountAdvice
    from scanner_core.case.mount_job import FoundMounts


class MountsPage(Page):
    """Stands beside the clouds of all mounts."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._mounts = services.mounts
        self._shown: FoundMounts | None = None
        self._aside: Aside | None = None
        self._advice: RemountAdvice | None = None
        box = self.inspector(self.tr("Another mount"))
        box.addWidget(label(self.tr("1  Set the object down anew"), "section", wrap=True))
        self.how = label("", wrap=True)
        box.addWidget(self.how)
        about = self.tr("Leave about half of what was scanned in sight, near the middle of the table, and see that nothing wobbles.")
        box.addWidget(label(about, "muted", wrap=True))
        self.tip = button(self.tr("Tip the virtual object"), "", lambda: self._mounts.tip(self._advice))
        box.addWidget(self.tip)
        box.addWidget(label(self.tr("2  Scan it into the same case"), "section", wrap=True))
        self.scan = button(self.tr("Scan this mount"), "primary", lambda: self.intent.emit("scan_mount"))
        self.scan.setToolTip(self.tr("The points of the earlier mounts stay (Shift+F9)"))
        box.addWidget(self.scan)
        box.addWidget(seam())
        self._heading = label(self.tr("How the mounts lie"), "section")
        box.addWidget(self._heading)
        self._lines = QWidget()
        self._list = QVBoxLayout(self._lines)
        self._list.setContentsMargins(0, 0, 0, 0)
        self._list.setSpacing(8)
        self._bar = QProgressBar()
        self._bar.setRange(0, 0)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Registration"))
        self._step = label("", "muted", wrap=True)
        box.addWidget(self._bar)
        box.addWidget(self._step)
        box.addWidget(scrolled(self._lines), 1)
        self.strip = self._make_strip()
        box.addWidget(self.strip)
        self.cancel = button(self.tr("Cancel"), "", self._mounts.cancel)
        self.again = button(self.tr("Look again how they lie"), "", self._mounts.register)
        self.next = button(self.tr("Reconstruct"), "primary", lambda: self.wanted.emit("reconstruct"))
        for made in (self.cancel, self.again, self.next):
            box.addWidget(made)
        services.mounts.changed.connect(self._show_answer)
        services.coverage.changed.connect(self._show_answer)
        services.case.opened.connect(self._show_answer)
        services.rig.changed.connect(self._show_buttons)
        services.acquisition.began.connect(self._begin)
        services.acquisition.ended.connect(self._end)
        self._show_answer()

    def entered(self) -> None:
        self._mounts.find_out()
        self._show_answer()

    def aside(self) -> Aside | None:
        """All mounts, each in its colour."""
        found = self._mounts.found
        if found is not self._shown:
            self._shown, self._aside = found, None
        if found is not None and self._aside is None:
            from app.views.mounts_aside import MountsAside

            self._aside = MountsAside(found.clouds)
        return self._aside

    def _begin(self) -> None:
        """What was advised is about to be done, or about another object."""
        self._advice = None

    def _end(self) -> None:
        """An error-driven scan tells what would come next."""
        result = self.services.acquisition.result
        if result is not None and result.steering is not None:
            self._advice = result.steering.remount
        self._show_answer()

    # -------------------------------------------------------------------------------- parts
    def _make_strip(self) -> QFrame:
        """Why a mount was not joined, and the ways out."""
        made = QFrame()
        made.setProperty("role", "banner")
        mark = Sign(20, "warning", "warning")
        self.reason = label("", wrap=True)
        kept = label(self.tr("Nothing is lost: all points are kept in the case."), "muted", wrap=True)
        words = QVBoxLayout()
        words.setSpacing(4)
        words.addWidget(self.reason)
        words.addWidget(kept)
        head = row(mark, words, spacing=8)
        head.setStretch(1, 1)
        self.pick = button(self.tr("Pick three points"), "primary", lambda: self.wanted.emit("pick"))
        self.another = button(self.tr("Scan another mount"), "", self._set_down_again)
        box = QVBoxLayout(made)
        box.setContentsMargins(10, 10, 10, 10)
        box.addLayout(head)
        box.addWidget(self.pick)
        box.addWidget(self.another)
        return made

    def _set_down_again(self) -> None:
        """The first step of the page is the next one to take."""
        self.strip.hide()
        self.scan.setFocus()

    # -------------------------------------------------------------------------------- showing
    def _show_answer(self) -> None:
        known = self.services.coverage.found
        if known is not None:
            self._advice = known.remount
        elif self.services.case.store is None:
            self._advice = None
        if self._advice is not None:
            self.how.setText(remount_words(self._advice))
        else:
            self.how.setText(self.tr("Tip it by 60 to 90° or turn it over, so that what was hidden comes into view."))
        running, found = self._mounts.running, self._mounts.found
        self._bar.setVisible(running)
        self._step.setText(self.tr("Looking how the mounts lie on each other…") if running else "")
        self._step.setVisible(running)
        self._heading.setVisible(running or found is not None)
        while (item := self._list.takeAt(0)) is not None:
            part = item.widget()
            if part is not None:
                part.hide()
                part.deleteLater()
        if found is not None and not running:
            for outcome in found.registered.outcomes:
                self._list.addWidget(_MountLine(outcome.mount, mount_line(outcome, found.registered.first_mount)))
        self._list.addStretch(1)
        refused = None if running else self._mounts.refused
        self.strip.setVisible(refused is not None)
        if refused is not None:
            self.reason.setText(f"{mount_title(refused.mount)}: {refusal(refused)}")
        self._show_buttons()
        self.aside_changed.emit()

    def _show_buttons(self) -> None:
        mounts, rig, case = self._mounts, self.services.rig.snapshot, self.services.case
        idle = not mounts.running and not self.services.acquisition.running
        ready = idle and rig.connected and not rig.busy and rig.calibration is not None and case.store is not None and case.cloud is not None
        joined = mounts.found is not None and not mounts.running and mounts.refused is None
        self.tip.setVisible(rig.virtual)
        self.tip.setEnabled(ready and not mounts.tipping)
        self.scan.setEnabled(ready and not mounts.tipping)
        self.cancel.setVisible(mounts.running)
        self.again.setVisible(mounts.found is not None and not mounts.running)
        self.next.setVisible(joined)
        self.pick.setEnabled(idle)
        make_primary(self.scan, not joined and mounts.refused is None)


class _MountLine(QWidget):
    """A dot in the colour of the points, the mount, and how it lies."""

    def __init__(self, mount: int, words: str) -> None:
        super().__init__()
        dot = QLabel()
        dot.setFixedSize(12, 12)
        dot.setStyleSheet(f"background: {mount_colour(mount)}; border-radius: 6px;")
        title = label(mount_title(mount))
        title.setStyleSheet("font-weight: 600;")
        head = row(dot, title, 1, spacing=8)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(2)
        box.addLayout(head)
        told = label(words, "muted", wrap=True)
        told.setContentsMargins(20, 0, 0, 0)
        box.addWidget(told)
        self.setAccessibleName(f"{title.text()}: {words}")
