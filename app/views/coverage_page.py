"""Complete: which places are not as certain as wanted, why, and what can be done about each of them; which may stay as they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QButtonGroup, QProgressBar

from app.services import Services
from app.translation import QT_TRANSLATE_NOOP
from app.views import format as fmt
from app.views.aside import Aside
from app.views.coverage_words import remount_words
from app.views.page import Page
from app.views.parts import BigNumber, button, label, make_primary, number_field, row, seam
from app.views.place_list import PlaceList
from scanner_core.coverage.reason import Reason

if TYPE_CHECKING:
    from app.views.coverage_aside import CoverageAside

DEFAULT_UM = 40
_PHASES = {
    "read": QT_TRANSLATE_NOOP("coverage", "Reading the case…"),
    "cover": QT_TRANSLATE_NOOP("coverage", "Following the light to every place…"),
    "remount": QT_TRANSLATE_NOOP("coverage", "Looking for a better way to set the object down…"),
}


class CoveragePage(Page):
    """Stands beside the coloured surface."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._coverage = services.coverage
        self._aside: CoverageAside | None = None
        box = self.inspector(self.tr("Complete"))
        self._reached = BigNumber(self.tr("% of what can be seen"))
        self._all = BigNumber(self.tr("% of all"))
        numbers = row(self._reached, self._all, spacing=6)
        box.addLayout(numbers)
        self.wanted_um = number_field(1, 1000, 5, lambda _: self._ask_anew(), suffix=" µm")
        self.wanted_um.setFixedWidth(110)
        self.wanted_um.setToolTip(self.tr("Standard uncertainty that is enough"))
        self.wanted_um.setValue(services.draft.values.until_um or DEFAULT_UM)
        caption = label(self.tr("Within"), "muted")
        caption.setBuddy(self.wanted_um)
        box.addLayout(row(caption, 1, self.wanted_um))
        self._bar = QProgressBar()
        self._bar.setRange(0, 0)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Computing"))
        box.addWidget(self._bar)
        self._step = label("", "muted", wrap=True)
        box.addWidget(self._step)
        self.by_reason = button(self.tr("Reason"), "choice", self._colour)
        self.by_uncertainty = button(self.tr("Uncertainty"), "choice", self._colour)
        self._colours = QButtonGroup(self)
        for made in (self.by_reason, self.by_uncertainty):
            made.setCheckable(True)
            self._colours.addButton(made)
        self.by_reason.setChecked(True)
        box.addLayout(row(self.by_reason, self.by_uncertainty))
        self.places = PlaceList()
        self.places.wanted.connect(self._fly)
        self.places.accepted.connect(self._coverage.accept)
        self.places.filled.connect(lambda: self.intent.emit("fill"))
        box.addWidget(self.places, 1)
        box.addStretch()  # takes the room while there is no list
        self.counts = label("", "faint", wrap=True)
        box.addWidget(self.counts)
        box.addWidget(seam())
        self.advice = label("", "muted", wrap=True)
        box.addWidget(self.advice)
        self.ask = button(self.tr("Find out"), "primary", self._ask)
        self.cancel = button(self.tr("Cancel"), "", self._coverage.cancel)
        self.fill = button(self.tr("Fill now"), "", lambda: self.intent.emit("fill"))
        self.fill.setToolTip(self.tr("Leave the object as it stands: the scan goes on where points are missing, until it is as wanted (Shift+F5)"))
        self.remount = button(self.tr("Scan another mount"), "", lambda: self.intent.emit("another_mount"))
        self.accept = button(self.tr("Accept"), "", lambda: self._coverage.accept(self.places.chosen))
        self.accept.setToolTip(self.tr("Leave the chosen place as it is: the case keeps that, the certificate tells it (A; again to take it back)"))
        self.edit = button(self.tr("Edit"), "", lambda: self.wanted.emit("edit"))
        self.edit.setToolTip(self.tr("Cut away what does not belong to the object before it becomes a surface"))
        self.next = button(self.tr("Reconstruct"), "", lambda: self.wanted.emit("reconstruct"))
        box.addWidget(self.ask)
        box.addWidget(self.cancel)
        box.addLayout(row(self.fill, self.accept))
        box.addWidget(self.remount)
        box.addLayout(row(self.edit, self.next))
        services.coverage.changed.connect(self._show_answer)
        services.coverage.pictures.drawn.connect(self._show_picture)
        services.rig.changed.connect(self._show_buttons)
        services.draft.changed.connect(self._follow_wish)
        self._show_answer()

    def entered(self) -> None:
        """What is not known yet is found out at once: that is what the page is for."""
        if self._coverage.found is None and not self._coverage.running:
            self._ask()
        self._show_answer()

    def aside(self) -> Aside | None:
        """The answer's surface."""
        found, surface = self._coverage.found, self._coverage.surface
        if found is None or surface is None:
            self._aside = None
        elif self._aside is None or self._aside.surface is not surface:
            from app.views.coverage_aside import CoverageAside

            self._aside = CoverageAside(surface, found.report)
            self._colour_aside()
        return self._aside

    # -------------------------------------------------------------------------------- asking
    def _ask(self) -> None:
        self._coverage.start(float(self.wanted_um.value()))

    def _ask_anew(self) -> None:
        if self.isVisible():
            self._ask()

    def _follow_wish(self, name: str) -> None:
        wanted = self.services.draft.values.until_um
        if name == "until_um" and wanted and not self.isVisible():
            self.wanted_um.setValue(wanted)

    # -------------------------------------------------------------------------------- showing
    def _show_answer(self) -> None:
        found, running = self._coverage.found, self._coverage.running
        report = None if found is None else found.report
        self._reached.show_number(fmt.NO_VALUE if report is None else fmt.percent(report.reachable_within_fraction))
        self._all.show_number(fmt.NO_VALUE if report is None else fmt.percent(report.within_fraction))
        self._bar.setVisible(running)
        self._step.setText(self._sentence())
        self._step.setVisible(bool(self._step.text()))
        places = () if report is None else report.places
        self.places.show_places(places, self._coverage.is_accepted)
        for number in self._coverage.pictures.pictures:
            self._show_picture(number)
        self.places.setVisible(bool(places))
        self.counts.setText(self._count_words())
        self.counts.setVisible(bool(places))
        self._colour_aside()
        advice = None if found is None else found.remount
        self.advice.setText("" if advice is None else remount_words(advice))
        self.remount.setToolTip(self.advice.text())
        self._show_buttons()
        self.aside_changed.emit()

    @property
    def _accepted(self) -> list[int]:
        """Numbers of the places that a person accepts."""
        found = self._coverage.found
        return [] if found is None else [number for number in range(len(found.report.places)) if self._coverage.is_accepted(number)]

    def _count_words(self) -> str:
        """How many places are open, how large they are, and how many are accepted."""
        found = self._coverage.found
        places, accepted = (() if found is None else found.report.places), set(self._accepted)
        left = [place for number, place in enumerate(places) if number not in accepted]
        told = self.tr("{n} open, {mm2:.0f} mm² together").format(n=len(left), mm2=sum(place.area_mm2 for place in left))
        return self.tr("{open}; {n} accepted").format(open=told, n=len(accepted)) if accepted else told

    def _show_picture(self, number: int) -> None:
        picture = self._coverage.pictures.pictures.get(number)
        if picture is not None:
            self.places.show_picture(number, picture)

    def _sentence(self) -> str:
        coverage = self._coverage
        if coverage.running:
            return QCoreApplication.translate("coverage", _PHASES.get(coverage.phase, "")) or self.tr("Making a surface of the points…")
        if coverage.found is None:
            return "" if coverage.able else self.tr("Scan an object or open a case first.")
        if not coverage.found.report.places:
            return self.tr("Every place is as certain as wanted.")
        return "" if coverage.found.of_mesh else self.tr("Of a surface that was made of the points for this; the case has none yet.")

    def _show_buttons(self) -> None:
        coverage, rig = self._coverage, self.services.rig.snapshot
        found = coverage.found
        ready = coverage.able and rig.connected and not rig.busy and rig.calibration is not None
        accepted = set(self._accepted)
        left = [] if found is None else [place for number, place in enumerate(found.report.places) if number not in accepted]
        few = any(place.reason is Reason.FEW_POINTS for place in left)
        hidden = found is not None and found.remount is not None and any(not place.reason.reachable for place in left)
        self.ask.setVisible(found is None and not coverage.running)
        self.ask.setEnabled(coverage.able)
        self.cancel.setVisible(coverage.running)
        self.fill.setVisible(found is not None)
        self.fill.setEnabled(ready and few)
        self.remount.setVisible(found is not None)
        self.remount.setEnabled(ready)
        self.remount.setText(self.tr("Needs another mount") if hidden and not few else self.tr("Scan another mount"))
        make_primary(self.fill, few)
        make_primary(self.remount, hidden and not few)
        self.advice.setVisible(hidden and not few)  # it stands on the pointer as long as something else comes first
        self.accept.setVisible(found is not None)
        self.edit.setVisible(found is not None)
        self.next.setVisible(found is not None)
        make_primary(self.next, not few and not hidden)
        self._show_accept()

    def _colour(self) -> None:
        self._colour_aside()
        self.aside_changed.emit()

    def _colour_aside(self) -> None:
        if self._aside is not None:
            self._aside.colour(by_uncertainty=self.by_uncertainty.isChecked(), accepted=self._accepted)

    def _show_accept(self) -> None:
        chosen = self.places.chosen
        self.accept.setEnabled(chosen >= 0 and self._coverage.able)
        taken = chosen >= 0 and self._coverage.is_accepted(chosen)
        self.accept.setText(self.tr("Do not accept") if taken else self.tr("Accept"))

    def _fly(self, number: int) -> None:
        self._show_accept()
        found = self._coverage.found
        if found is None or self._aside is None or not 0 <= number < len(found.report.members):
            return
        vertices = found.report.members[number]
        self._aside.mark(vertices)
        self.flight.emit(found.surface.vertices[vertices], np.array(found.report.places[number].normal))
