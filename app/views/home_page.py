"""Home: the orders, newest first; a number that is scanned or typed opens one or begins a new one; how accurate the rig is."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QVBoxLayout, QWidget

from app.controllers.case_files import DEMO, free_number
from app.draft import ORDER_FIELDS, DraftValues, first_order
from app.services import Services
from app.views.home_start import HomeStart
from app.views.interrupted_strip import InterruptedStrip
from app.views.order_form import OrderForm
from app.views.order_list import OrderList
from app.views.order_words import kind_word, next_step, page_of, side_word
from app.views.page import Page
from app.views.parts import button, label, row, scrolled, seam
from app.views.removed_strip import RemovedStrip
from app.views.wedge_field import WedgeField
from scanner_core.case.case_glance import CaseGlance

_ASIDE = 412


class HomePage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._begun: DraftValues | None = None
        self.strip = InterruptedStrip(services)
        to_rig, to_sphere = (partial(self.wanted.emit, page) for page in ("rig", "verify"))
        self.start = HomeStart(services, self.new_order, self.demo, self.edit_order, to_rig, to_sphere)
        self.form = OrderForm(services.new_order, services.preferences, lambda values: services.worklist.has(values), new=True)
        self.open_form = OrderForm(services.draft, services.preferences, lambda values: services.worklist.has(values, services.case.path), new=False)
        self._aside = QStackedWidget()
        self._aside.setFixedWidth(_ASIDE)
        for part in (self.start, self.form, self.open_form):
            part.setContentsMargins(28, 24, 28, 20)
            self._aside.addWidget(scrolled(part))
        box = QHBoxLayout()
        box.setSpacing(0)
        box.addWidget(self._orders(), 1)
        box.addWidget(seam(upright=True))
        box.addWidget(self._aside)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self.strip)
        whole.addLayout(box, 1)
        self.form.scan.connect(self._scan_new)
        self.form.keep.connect(self._keep_new)
        for form in (self.form, self.open_form):
            form.left.connect(self.show_start)
        services.worklist.changed.connect(self._show_orders)
        services.preferences.changed.connect(lambda name: services.worklist.look() if name == "case_folder" else None)
        services.case.opened.connect(self._show_case)
        services.acquisition.began.connect(self._show_case)
        services.acquisition.ended.connect(self._show_case)
        services.rig.changed.connect(self._show_rig_if_seen)
        services.readiness.changed.connect(self._show_rig_if_seen)
        self._show_orders()
        self._show_case()

    def entered(self) -> None:
        if self.window().isVisible():  # what it needs is imported after the window stands
            self.services.worklist.look()
        self._show_orders()
        self._show_case()
        if self._begun and self._aside.currentIndex() == 1 and self.services.new_order.values != self._begun:
            self.form.start()  # what was typed for a new order is still to be made
        else:
            self.show_start()

    def show_start(self) -> None:
        """The list with its field, which has the keys."""
        self._aside.setCurrentIndex(0)
        self.wedge.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.wedge.selectAll()

    # -------------------------------------------------------------------------------- parts
    def _orders(self) -> QWidget:
        self.wedge = WedgeField()
        self.wedge.textChanged.connect(self._show_orders)
        self.wedge.entered.connect(self._enter)
        self.hint = label("", "faint")
        self.list = OrderList(self.services.worklist)
        self.wedge.down.connect(self.list.select_first)
        self.list.chosen.connect(self.open_order)
        self.list.removal.connect(self._remove)
        self.list.typed.connect(self._type)
        self.list.selected.connect(self._show_selected)
        self.empty = label("", "muted", wrap=True)
        self.empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._open = button("", "", lambda: self._with_selected(self.open_order))
        self._open.setToolTip(self.tr("Enter, or a double click"))
        self._remove_button = button(self.tr("Remove"), "", lambda: self._with_selected(self._remove))
        self._remove_button.setToolTip(self.tr("Del; the file is moved, never deleted"))
        more = button(self.tr("Open another case…"), "link", lambda: self.intent.emit("open_case"))
        head = QVBoxLayout()
        head.setContentsMargins(22, 18, 22, 8)
        head.setSpacing(6)
        head.addWidget(self.wedge)
        head.addWidget(self.hint)
        foot = row(self._open, self._remove_button, 1, more, spacing=8)
        foot.setContentsMargins(22, 9, 22, 10)
        made = QWidget()
        box = QVBoxLayout(made)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addLayout(head)
        box.addWidget(seam())
        box.addWidget(RemovedStrip(self.services.worklist))
        box.addWidget(self.list, 1)
        box.addWidget(self.empty, 1)
        box.addWidget(seam())
        box.addLayout(foot)
        return made

    # -------------------------------------------------------------------------------- what a person does
    def new_order(self, kind: str = "ear", side: str = "", number: str = "") -> None:
        """The form for another order; what is open stays so until that is made."""
        number = number or self._next_number()
        for name, value in (("order", number), ("patient_code", ""), ("kind", kind), ("side", side)):
            self.services.new_order.put(name, value)
        self._begun = self.services.new_order.values
        self._aside.setCurrentIndex(1)
        self.form.start()

    def _next_number(self) -> str:
        """The one after that of the order that was made last."""
        orders = [told for told in self.services.worklist.orders if told.order.number and not told.order.number.startswith(DEMO)]
        last = max(orders, key=lambda told: told.created, default=None)
        number = self.services.settings.last_order if last is None else last.order.number
        return free_number(first_order(number).order, [told.order.number for told in orders])

    def edit_order(self) -> None:
        """The form of the open case."""
        self._aside.setCurrentIndex(2)
        self.open_form.start()

    def demo(self) -> None:
        """An order on the virtual rig, whose ear stands on the table, ready to be scanned."""
        rig = self.services.rig
        if not (rig.snapshot.virtual and rig.snapshot.specimen == "ear"):
            rig.choose(preset=rig.snapshot.preset if rig.snapshot.virtual else "bench", specimen="ear")
        number = free_number(f"{DEMO}01", [told.order.number for told in self.services.worklist.orders])
        self._make(DraftValues(order=number, side="left", kind="ear"))

    def open_order(self, told: CaseGlance) -> None:
        """Open its case, at the page where the work goes on."""
        services = self.services
        if services.acquisition.running:
            if services.case.path == told.path:
                self.wanted.emit("scan")
            else:
                self.noted.emit(self.tr("A scan is running."), self.tr("Wait for its end or stop it first (Esc)."))
            return
        self.wedge.clear()
        if services.case.path != told.path:
            QTimer.singleShot(0, lambda: services.case.open(told.path))
        self.wanted.emit(page_of(told) if told.trouble is None else "home")

    def _enter(self, number: str) -> None:
        """The order of that number, or a new one."""
        found = self.services.worklist.find(number)
        if found:
            self.open_order(found[0])
        else:
            self.wedge.clear()
            self.new_order(number=number)

    def _scan_new(self) -> None:
        self._make(self.services.new_order.values)

    def _make(self, order: DraftValues) -> None:
        """Make an order's files and go on with the first."""
        services = self.services
        if services.acquisition.running:
            return
        services.case.close()
        services.draft.load(replace(services.draft.values, **{name: getattr(order, name) for name in ORDER_FIELDS}))
        services.case.create(self._show_made)

    def _show_made(self, _: object) -> None:
        self._begun = None
        self.wanted.emit("scan")

    def _keep_new(self) -> None:
        order = self.services.new_order.values
        self.show_start()
        self.services.case.place(order, lambda _: self.services.worklist.look())

    def _remove(self, told: CaseGlance) -> None:
        if self.services.acquisition.running and self.services.case.path == told.path:
            self.noted.emit(self.tr("This order is being scanned."), self.tr("Wait for its end or stop it first (Esc)."))
        elif self.services.reconstruction.is_for(told.path):
            self.noted.emit(self.tr("The surface of this order is being made."), self.tr("Wait for it, or cancel it on the Reconstruct page."))
        else:
            self.services.worklist.remove(told)

    def _type(self, text: str) -> None:
        """Keys that belong to no other part of the page go into the field."""
        self.show_start()
        self.wedge.end(False)
        self.wedge.insert(text)

    # -------------------------------------------------------------------------------- showing
    def _show_orders(self) -> None:
        worklist, typed = self.services.worklist, self.wedge.number
        running = self.services.case.path if self.services.acquisition.running else None
        self.list.show_orders(typed, running)
        shown = self.list.orders.rowCount()
        self.list.setVisible(shown > 0)
        self.empty.setVisible(shown == 0)
        if typed:
            self.empty.setText(self.tr("No order has that in it."))
        else:
            self.empty.setText(self.tr("No orders yet. They stand here as soon as they are entered.") if worklist.known else self.tr("Looking…"))
        self._show_hint()
        self.start.show_worklist()

    def _show_hint(self) -> None:
        """What Enter does."""
        typed, count = self.wedge.number, len(self.services.worklist.orders)
        found = self.services.worklist.find(typed) if typed else []
        if found:
            order = found[0].order
            what = ", ".join(part for part in (order.number, side_word(order.side), kind_word(order.type)) if part)
            self.hint.setText(self.tr("Enter opens {order}.").format(order=what))
        elif typed:
            self.hint.setText(self.tr("Enter makes a new order {number}.").format(number=typed))
        elif count < 2:
            self.hint.setText(self.tr("Enter opens the order of that number, or begins a new one."))
        else:
            self.hint.setText(self.tr("{n} orders, the newest first. Arrow down goes into the list.").format(n=count))

    def _show_selected(self) -> None:
        told = self.list.current
        self._open.setText(next_step(told))
        self._open.setEnabled(told is not None)
        self._remove_button.setEnabled(told is not None)

    def _with_selected(self, call: object) -> None:
        told = self.list.current
        if told is not None and callable(call):
            call(told)

    def _show_case(self) -> None:
        if self._aside.currentIndex() == 2 and self.services.case.store is None:
            self.show_start()
        self._show_orders()
        self._show_rig()

    def _show_rig_if_seen(self) -> None:
        if self.isVisible():
            self._show_rig()

    def _show_rig(self) -> None:
        self.form.block_scan(self.tr("A scan is running: the order can wait in the list.") if self.services.acquisition.running else "")
        self.start.show_rig()

    # -------------------------------------------------------------------------------- keys
    def event(self, event: QEvent) -> bool:
        """A key that a part of the page leaves is typed into the field, before it is a shortcut of the 3D view."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and _is_typed(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        if _is_typed(event) and self._aside.currentIndex() == 0:
            self._type(event.text())
        else:
            super().keyPressEvent(event)


def _is_typed(event: QKeyEvent) -> bool:
    """A letter or a digit, without another key."""
    plain = not event.modifiers() & ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier)
    return plain and event.text().isalnum()
