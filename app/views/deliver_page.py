"""Deliver: is the surface fit for the laboratory, what goes there and under which name; one button writes everything."""

from __future__ import annotations

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QCheckBox, QComboBox, QProgressBar, QStackedWidget, QVBoxLayout, QWidget

from app.services import Services
from app.theme import Sign
from app.views import format as fmt
from app.views.check_list import CheckList
from app.views.delivery_words import READY_SIGNS, check_sentence, profile_name, readiness_word
from app.views.page import Page
from app.views.parts import SideBadge, button, column, label, make_primary, row, seam
from app.views.profile_panel import ProfilePanel
from scanner_core.delivery.check import Check, CheckVerdict, Readiness

_WIDTH = 348
_SENTENCE_LINES = 4


class DeliverPage(Page):
    """Stands beside the surface."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        box = self.inspector(self.tr("Deliver"))
        self.setFixedWidth(_WIDTH)
        self._delivery = services.delivery
        self._profiles = services.delivery.profiles
        self._shown: object = None
        self._stack = QStackedWidget()
        self._panel = ProfilePanel(services, self._profiles)
        self._stack.addWidget(self._make_checks())
        self._stack.addWidget(self._panel)
        box.addWidget(self._stack, 1)
        self._panel.closed.connect(self._back)
        services.delivery.changed.connect(self._show)
        services.case.opened.connect(self._show)
        services.case.meshed.connect(self._show)
        services.preferences.changed.connect(lambda _: self._show())
        self._profiles.changed.connect(self._show)
        services.draft.changed.connect(lambda _: self._show())
        self._show()

    def entered(self) -> None:
        self._delivery.check()
        self._show()

    def tick(self) -> None:
        """What was found may have become stale while the page is looked at."""
        if self.isVisible() and self._delivery.examination is None and not self._delivery.cancelled:
            self._delivery.check()

    # -------------------------------------------------------------------------------- what it is made of
    def _make_checks(self) -> QWidget:
        self._sign = Sign(30)
        self._verdict = label("", "headline", wrap=True)
        self._badge = SideBadge()
        self._counts = label("", "muted", wrap=True)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress"))
        self.stop = button(self.tr("Cancel"), "link", self._delivery.cancel)
        self.again = button(self.tr("Check"), "", self._check_again)
        self.checks = CheckList()
        self.checks.explained.connect(self._explain)
        self._sentence = label("", "muted", wrap=True, selectable=True)
        self._sentence.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._sentence.setFixedHeight(_SENTENCE_LINES * self._sentence.fontMetrics().lineSpacing())
        head = row(self._sign, column(self._verdict, self._counts, spacing=1), self._badge, spacing=12)
        head.setStretch(1, 1)
        head.setAlignment(self._sign, Qt.AlignmentFlag.AlignTop)
        head.setAlignment(self._badge, Qt.AlignmentFlag.AlignTop)
        made = QWidget()
        box = QVBoxLayout(made)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        box.addLayout(head)
        box.addWidget(self._bar)
        box.addLayout(row(self.stop, self.again, 1))
        box.addWidget(self.checks, 1)
        box.addWidget(self._sentence)
        self._room = QWidget()
        box.addWidget(self._room, 1)
        self._add_files(box)
        return made

    def _add_files(self, box: QVBoxLayout) -> None:
        self.profile = QComboBox()
        self.profile.setMinimumHeight(32)
        self.profile.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.profile.setAccessibleName(self.tr("Profile"))
        self.profile.activated.connect(lambda _: self._profiles.choose(self.services.draft.values.kind, self.profile.currentData()))
        self.edit = button(self.tr("Edit…"), "", self._edit)
        self.edit.setAccessibleName(self.tr("Edit the profile"))
        line = row(self.profile, self.edit, spacing=6)
        line.setStretch(0, 1)
        self._name = label("", "", wrap=True, selectable=True)
        self._name.setStyleSheet("font-weight: 600;")
        self._note = label("", "muted", wrap=True)
        self.anyway = QCheckBox(self.tr("Deliver it although it is not ready"))
        self.anyway.setToolTip(self.tr("The certificate says so, in words and in its JSON."))
        self.anyway.toggled.connect(self._show)
        self.replace = QCheckBox(self.tr("Replace the existing files"))
        self.replace.toggled.connect(self._show)
        self.primary = button(self.tr("Deliver"), "primary", self._deliver)
        self.open = button(self.tr("Open folder"), "", self._open_folder, "folder")
        self.another = button(self.tr("Deliver once more"), "", self._deliver)
        self.next = button(self.tr("Next order"), "primary", lambda: self.intent.emit("new_case"))
        box.addWidget(seam())
        box.addLayout(line)
        box.addWidget(self._name)
        box.addWidget(self._note)
        for part in (self.anyway, self.replace, self.primary):
            box.addWidget(part)
        box.addLayout(row(self.open, self.another, spacing=6))
        box.addWidget(self.next)

    # -------------------------------------------------------------------------------- commands
    def _check_again(self) -> None:
        if self._delivery.ready_to_check:
            self._delivery.check()
        else:
            self.wanted.emit("home" if self.services.case.cloud is None else "reconstruct")

    def _deliver(self) -> None:
        profile = self._profiles.chosen(self.services.draft.values.kind)
        self._delivery.deliver(profile, anyway=self.anyway.isChecked(), replace=self.replace.isChecked())

    def _open_folder(self) -> None:
        if self._delivery.last is not None:
            QDesktopServices.openUrl(QUrl.fromLocalFile(self._delivery.last.folder))

    def _edit(self) -> None:
        self._stack.setCurrentWidget(self._panel)
        self._panel.done.setFocus()

    def _back(self) -> None:
        self._stack.setCurrentIndex(0)
        self.edit.setFocus()

    def _explain(self, check: Check | None) -> None:
        self._sentence.setText("" if check is None else check_sentence(check))

    # -------------------------------------------------------------------------------- what it shows
    def _show(self) -> None:
        delivery, found = self._delivery, self._delivery.examination
        if found is not self._shown:
            self._shown = found
            self.anyway.setChecked(False)
            self.replace.setChecked(False)
            self.checks.show_checks(() if found is None else found.checks)
        self._badge.show_side(self.services.draft.values.side if delivery.ready_to_check else "")
        for part in (self.checks, self._sentence):
            part.setVisible(found is not None)
        self._room.setVisible(found is None)
        self._show_verdict()
        busy = delivery.checking or delivery.writing
        self._bar.setVisible(busy)
        self._bar.setValue(0 if delivery.progress is None else round(1000 * delivery.progress.fraction))
        self.stop.setVisible(busy)
        self.again.setVisible(not busy and found is None)
        make_primary(self.again, not delivery.ready_to_check)
        self._show_profiles()
        self._show_files()

    def _show_verdict(self) -> None:
        delivery, found = self._delivery, self._delivery.examination
        self._sign.setVisible(found is not None)
        if found is not None:
            counts = {verdict: len(found.of(verdict)) for verdict in CheckVerdict}
            self._sign.show_sign(*READY_SIGNS[found.verdict])
            self._verdict.setText(readiness_word(found.verdict) if delivery.last is None else self.tr("Delivered"))
            self._counts.setText(self._counted(counts) if delivery.last is not None else self._before(found.facts.delivered, self._counted(counts)))
            return
        if not delivery.ready_to_check:
            scanned = self.services.case.cloud is not None
            words = self.tr("Reconstruct first"), self.tr("There is no surface to deliver yet.")
            if not scanned:
                words = self.tr("No surface yet"), self.tr("Open an order or begin one, then scan and reconstruct it.")
            self.again.setText(self.tr("Reconstruct") if scanned else self.tr("Orders"))
        elif delivery.checking:
            words = self.tr("Checking…"), self._phase()
        else:
            words = self.tr("Not checked"), self.tr("The check was cancelled.")
            self.again.setText(self.tr("Check"))
        self._verdict.setText(words[0])
        self._counts.setText(words[1])

    def _counted(self, counts: dict[CheckVerdict, int]) -> str:
        if counts[CheckVerdict.FAIL]:
            return self.tr("Failed: {failed}. Remarks: {remarks}. Passed: {passed}.").format(
                failed=counts[CheckVerdict.FAIL], remarks=counts[CheckVerdict.WARN], passed=counts[CheckVerdict.PASS]
            )
        if counts[CheckVerdict.WARN]:
            return self.tr("Remarks: {remarks}. Passed: {passed}.").format(remarks=counts[CheckVerdict.WARN], passed=counts[CheckVerdict.PASS])
        return self.tr("All {passed} checks passed.").format(passed=counts[CheckVerdict.PASS])

    def _before(self, delivered: dict[str, object], counted: str) -> str:
        """With what the case remembers of an earlier delivery."""
        files = delivered.get("files")
        if not isinstance(files, list) or not files:
            return counted
        day = fmt.day(str(delivered.get("time", "")))
        return self.tr("{counted}\nDelivered before, on {day}: {name}").format(counted=counted, day=day, name=files[0])

    def _phase(self) -> str:
        phase = "" if self._delivery.progress is None else self._delivery.progress.phase
        words = {
            "measured": self.tr("How it was measured"),
            "shape": self.tr("Closed, and free of self-intersections"),
            "side": self.tr("Whether it mirrors the other ear"),
        }
        return words.get(phase, "")

    def _show_profiles(self) -> None:
        chosen = self._profiles.chosen(self.services.draft.values.kind)
        entries = [(profile_name(profile), profile.name) for profile in self._profiles.every]
        if [(self.profile.itemText(place), self.profile.itemData(place)) for place in range(self.profile.count())] != entries:
            self.profile.clear()
            for words, name in entries:
                self.profile.addItem(words, name)
        self.profile.setCurrentIndex(self.profile.findData(chosen.name))

    def _show_files(self) -> None:
        delivery, found, last = self._delivery, self._delivery.examination, self._delivery.last
        profile = self._profiles.chosen(self.services.draft.values.kind)
        folder, stem = delivery.place(profile)
        exists = any(folder.joinpath(stem + suffix).exists() for suffix in profile.suffixes)
        there = delivery.ready_to_check
        if last is not None:
            self._name.setText(last.files[0])
            others = ", ".join(name[name.rindex(".") :] for name in last.files[1:])
            written = self.tr("Written to {folder}").format(folder=fmt.short_path(last.folder))
            self._note.setText(self.tr("{written}, with {others}").format(written=written, others=others) if others else written)
        else:
            self._name.setText(f"{stem}{profile.format}" if there else "")
            others = ", ".join(profile.suffixes[1:])
            place = self.tr("In {folder}").format(folder=fmt.short_path(str(folder)))
            note = self.tr("{place}, with {others}").format(place=place, others=others) if others else place
            if exists:
                note = self.tr("These files exist already. With {rev} in the name every delivery gets its own number.")
            self._note.setText(note if there else "")
        not_ready = found is not None and found.verdict is Readiness.NOT_READY
        self.anyway.setVisible(there and not_ready and last is None)
        self.replace.setVisible(there and exists and last is None)
        able = found is not None and not delivery.checking and not delivery.writing
        allowed = able and (not not_ready or self.anyway.isChecked()) and (not exists or self.replace.isChecked())
        self.primary.setText(self.tr("Deliver anyway") if not_ready and self.anyway.isChecked() else self.tr("Deliver"))
        self.primary.setVisible(last is None and there)
        self.primary.setEnabled(allowed)
        for part in (self.open, self.another, self.next):
            part.setVisible(last is not None)
        self.another.setEnabled(able and not exists)
