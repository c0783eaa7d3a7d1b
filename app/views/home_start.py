"""Beside the worklist: the kinds of new orders, the open order, how accurate the rig is, and which rig it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.controllers.readiness import Readiness
from app.services import Services
from app.theme import Sign, icon
from app.views.accuracy_card import AccuracyCard
from app.views.order_words import kind_word
from app.views.parts import SideBadge, button, label, make_primary, row, seam
from app.views.ready_words import ready_sentence
from app.views.rig_choice import specimen_words


class HomeStart(QWidget):
    """Calls what was asked for: `new(kind, side)`, `demo()`, `edit()`, `rig()`, `measure()`."""

    def __init__(
        self,
        services: Services,
        new: Callable[[str, str], None],
        demo: Callable[[], None],
        edit: Callable[[], None],
        rig: Callable[[], None],
        measure: Callable[[], None],
    ) -> None:
        super().__init__()
        self._services = services
        self.pair = button(self.tr("New ear pair"), "primary", lambda: new("ear", "both"), "ear")
        self.pair.setToolTip(self.tr("Left and right: two cases with one order number"))
        self.single = button(self.tr("New ear impression"), "", lambda: new("ear", ""), "ear")
        self.dental = button(self.tr("New dental model"), "", lambda: new("arch", ""), "arch")
        self.demo = button(self.tr("Try a demo order"), "", demo, "play")
        self.demo.setToolTip(self.tr("An ear on the virtual rig: nothing has to be connected, and nothing is overwritten"))
        for made in (self.pair, self.single, self.dental, self.demo):
            made.setMinimumHeight(40)
            made.setIconSize(QSize(18, 18))
        self._number = label("", "")
        self._number.setStyleSheet("font-weight: 600;")
        self._badge, self._kind = SideBadge(), label("", "muted")
        self._edit = button(self.tr("Change the order"), "link", edit)
        self._case = QWidget()
        case = QVBoxLayout(self._case)
        case.setContentsMargins(0, 0, 0, 14)
        case.setSpacing(6)
        case.addWidget(label(self.tr("Open now"), "section"))
        case.addLayout(row(self._number, 1, self._edit))
        case.addLayout(row(self._badge, self._kind, 1))
        case.addSpacing(8)
        case.addWidget(seam())
        self.accuracy = AccuracyCard(measure)
        self._ready_sign, self.ready = Sign(18), label("", "", wrap=True)
        self._on_table = label("", "muted", wrap=True)
        self._change = button(self.tr("Change"), "link", rig)
        table = row(self._on_table, self._change, spacing=12)
        table.setStretch(0, 1)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        box.addWidget(self._case)
        self._new = QVBoxLayout()
        self._new.setSpacing(8)
        for made in (self.pair, self.single, self.dental, self.demo):
            self._new.addWidget(made)
        box.addLayout(self._new)
        box.addSpacing(12)
        box.addWidget(seam())
        box.addSpacing(8)
        box.addWidget(self.accuracy)
        box.addSpacing(8)
        box.addWidget(seam())
        box.addSpacing(8)
        box.addWidget(label(self.tr("Rig"), "section"))
        ready = row(self._ready_sign, self.ready, spacing=9)
        ready.setStretch(1, 1)
        ready.setAlignment(self._ready_sign, Qt.AlignmentFlag.AlignTop)
        box.addLayout(ready)
        box.addLayout(table)
        box.addStretch(1)

    def show_worklist(self) -> None:
        """Which button comes first: a demo while there is nothing at all."""
        first = self._services.worklist.known and not self._services.worklist.orders
        for made, name, primary in ((self.demo, "play", first), (self.pair, "ear", not first)):
            make_primary(made, primary)
            made.setIcon(icon(name, "on_accent" if primary else "text"))
        if self._new.indexOf(self.demo) != (0 if first else 3):
            self._new.insertWidget(0 if first else 3, self.demo)

    def show_rig(self) -> None:
        """Rig, open order, and what keeps a demo from being tried."""
        rig, running = self._services.rig.snapshot, self._services.acquisition.running
        self.demo.setEnabled(not running and not rig.busy and rig.calibrating is None)
        there = self._services.case.store is not None
        self._case.setVisible(there)
        if there:
            values = self._services.draft.values
            self._number.setText(values.order)
            self._badge.show_side(values.side)
            self._kind.setText(kind_word(values.kind))
        self.accuracy.show_rig(rig)
        name = rig.preset if not rig.own else Path(rig.preset).stem
        ready = self._services.readiness.snapshot
        signs = {Readiness.READY: ("check", "good"), Readiness.UNKNOWN: ("order", "muted")}
        self._ready_sign.show_sign(*(("scan", "accent") if running else signs.get(ready.readiness, ("warning", "warning"))))
        self.ready.setText(self.tr("A scan is running.") if running else ready_sentence(ready))
        on_table = self.tr("{rig}, virtual; on the table: {specimen}").format(rig=name, specimen=specimen_words(rig.specimen))
        self._on_table.setText(on_table if rig.virtual else name)
