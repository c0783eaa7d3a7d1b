"""Home: the order first, one primary button, how accurate the rig is, and the recent cases."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSize, Qt, QTimer
from PySide6.QtWidgets import QButtonGroup, QGridLayout, QHBoxLayout, QLineEdit, QListWidget, QListWidgetItem, QPushButton, QVBoxLayout, QWidget

from app.controllers.case_files import read_case_name
from app.draft import KINDS, SIDES, DraftValues
from app.faults import sentence_of
from app.services import Services
from app.views import format as fmt
from app.views.interrupted_strip import InterruptedStrip
from app.views.page import Page
from app.views.parts import BigNumber, SideBadge, button, label, number_field, row, seam
from app.views.rig_choice import specimen_words


class HomePage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.strip = InterruptedStrip(services)
        box = QHBoxLayout()
        box.setSpacing(0)
        box.addWidget(self._order(), 6)
        box.addWidget(seam(upright=True))
        box.addWidget(self._aside(), 5)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self.strip)
        whole.addLayout(box, 1)
        services.draft.changed.connect(self._show_field)
        services.rig.changed.connect(self._show_rig_if_seen)
        services.acquisition.ended.connect(self._show_start)
        services.case.opened.connect(self._show_recent)
        services.case.opened.connect(self._show_head)
        for name in DraftValues.__dataclass_fields__:
            self._show_field(name)
        self._show_rig()
        self._show_recent()
        self._show_head()

    def entered(self) -> None:
        self._show_recent()
        self._show_rig()

    # -------------------------------------------------------------------------------- parts
    def _order(self) -> QWidget:
        draft = self.services.draft
        self._number = QLineEdit()
        self._number.setPlaceholderText(self.tr("as on the order form"))
        self._number.textEdited.connect(lambda text: draft.edit("order", text.strip()))
        self._code = QLineEdit()
        self._code.setPlaceholderText(self.tr("a code, not the name"))
        self._code.textEdited.connect(lambda text: draft.edit("patient_code", text.strip()))
        for field in (self._number, self._code):
            field.setMinimumHeight(34)
            field.setTextMargins(6, 0, 6, 0)
        self._sides = self._choices("side", SIDES, side_colours=True)
        self._kinds = self._choices("kind", KINDS)
        grid = QGridLayout()
        grid.setHorizontalSpacing(18)
        grid.setVerticalSpacing(14)
        grid.setColumnMinimumWidth(0, 110)
        grid.setColumnStretch(1, 1)
        for line, (name, part) in enumerate(
            (
                (self.tr("Order number"), self._number),
                (self.tr("Patient code"), self._code),
                (self.tr("Side"), self._sides[0]),
                (self.tr("Type"), self._kinds[0]),
            )
        ):
            caption = label(name, "muted")
            caption.setBuddy(part)
            grid.addWidget(caption, line, 0)
            grid.addWidget(part, line, 1)
        self._views = number_field(1, 360, 1, lambda value: draft.edit("views", value), suffix=self.tr(" views"))
        self._points = number_field(500, 2_000_000, 1000, lambda value: draft.edit("points", value), suffix=self.tr(" points"))
        self._on_table = label("")
        self._change = button(self.tr("Change"), "link", lambda: self.wanted.emit("rig"))
        plan = QGridLayout()
        plan.setHorizontalSpacing(18)
        plan.setVerticalSpacing(14)
        plan.setColumnMinimumWidth(0, 110)
        plan.setColumnStretch(1, 1)
        plan.addWidget(label(self.tr("Scan plan"), "muted"), 0, 0)
        plan.addLayout(row(self._views, self._points), 0, 1)
        self._on_table_caption = label("", "muted")
        plan.addWidget(self._on_table_caption, 1, 0)
        plan.addLayout(row(self._on_table, self._change, 1, spacing=14), 1, 1)
        for count_field in (self._views, self._points):
            count_field.setMinimumHeight(34)
        self._start = button(self.tr("Start scan"), "primary", lambda: self.intent.emit("start_scan"), "play", "on_accent")
        self._start.setMinimumHeight(46)
        self._start.setStyleSheet("font-size: 15px;")
        self._ready = label("", "muted", wrap=True)
        side = QWidget()
        side_box = QVBoxLayout(side)
        side_box.setContentsMargins(40, 38, 40, 30)
        side_box.setSpacing(0)
        self._head = label("", "headline")
        self._about = label("", "muted")
        self._new = button(self.tr("New case"), "link", lambda: self.intent.emit("new_case"))
        side_box.addLayout(row(self._head, 1, self._new))
        side_box.addSpacing(6)
        side_box.addWidget(self._about)
        side_box.addSpacing(28)
        side_box.addLayout(grid)
        side_box.addSpacing(24)
        side_box.addWidget(seam())
        side_box.addSpacing(20)
        side_box.addLayout(plan)
        side_box.addSpacing(28)
        side_box.addWidget(self._start)
        side_box.addSpacing(10)
        side_box.addWidget(self._ready)
        side_box.addStretch(1)
        return side

    def _choices(self, name: str, choices: dict[str, str], *, side_colours: bool = False) -> tuple[QWidget, dict[str, QPushButton]]:
        holder = QWidget()
        box = QHBoxLayout(holder)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        group = QButtonGroup(holder)
        buttons = {}
        for key, word in choices.items():
            made = button(QCoreApplication.translate("draft", word), "choice", partial(self.services.draft.edit, name, key))
            made.setCheckable(True)
            if side_colours:
                made.setProperty("side", key)
            group.addButton(made)
            box.addWidget(made, 1)
            buttons[key] = made
        return holder, buttons

    def _aside(self) -> QWidget:
        self._accuracy = BigNumber("", "hero")
        self._accuracy_note = label("", "muted", wrap=True)
        self._recent = QListWidget()
        self._recent.setAccessibleName(self.tr("Recent cases"))
        self._recent.itemActivated.connect(self._open)
        self._recent.itemClicked.connect(self._open)
        self._no_recent = label(self.tr("No cases yet. Every scan makes one."), "muted")
        self._more = button(self.tr("Open another case…"), "link", lambda: self.intent.emit("open_case"))
        aside = QWidget()
        box = QVBoxLayout(aside)
        box.setContentsMargins(36, 38, 36, 30)
        box.setSpacing(0)
        box.addWidget(label(self.tr("How accurate is it?"), "section"))
        box.addWidget(self._accuracy)
        box.addSpacing(4)
        box.addWidget(self._accuracy_note)
        box.addSpacing(22)
        box.addWidget(seam())
        box.addSpacing(20)
        box.addWidget(label(self.tr("Recent cases"), "section"))
        box.addSpacing(6)
        box.addWidget(self._no_recent)
        box.addWidget(self._recent, 1)
        box.addSpacing(8)
        box.addWidget(self._more, 0, Qt.AlignmentFlag.AlignLeft)
        box.addStretch(0)
        return aside

    # -------------------------------------------------------------------------------- showing
    def _show_head(self) -> None:
        """Whose order this is: of the open case, which keeps every change, or of the next one."""
        there = self.services.case.store is not None
        self._head.setText(self.tr("Open case") if there else self.tr("New case"))
        self._about.setText(
            self.tr("Changes of the order are kept in this case.") if there else self.tr("The order goes with every file that leaves this program.")
        )
        self._new.setVisible(there)
        self._show_start()

    def _show_field(self, name: str) -> None:
        values = self.services.draft.values
        if name == "order" and self._number.text().strip() != values.order:
            self._number.setText(values.order)
        elif name == "patient_code" and self._code.text().strip() != values.patient_code:
            self._code.setText(values.patient_code)
        elif name == "views":
            self._views.setValue(values.views)
        elif name == "points":
            self._points.setValue(values.points)
        elif name == "side":
            for side, made in self._sides[1].items():
                group = made.group()
                group.setExclusive(False)
                made.setChecked(side == values.side)
                group.setExclusive(True)
        elif name == "kind":
            self._kinds[1][values.kind].setChecked(True)

    def _show_rig_if_seen(self) -> None:
        if self.isVisible():
            self._show_rig()

    def _show_rig(self) -> None:
        calibration = self.services.rig.snapshot.calibration
        if calibration is None:
            self._accuracy.show_number(fmt.NO_VALUE)
            unreadable = self.services.rig.snapshot.unreadable
            self._accuracy.show_unit("" if unreadable else self.tr("not calibrated"))
            to_do = self.tr("The Rig page calibrates it in a few minutes.")
            self._accuracy_note.setText(self.tr("The Rig page says what is wrong with the rig file.") if unreadable else to_do)
        else:
            self._accuracy.show_number(fmt.micrometres(calibration.held_out_rms_um))
            self._accuracy.show_unit(self.tr("µm rms error of the calibration"))
            self._accuracy_note.setText(
                self.tr(
                    "Measured on {date} at corners of the board that were not used to calibrate. "
                    "The laser spot adds its own noise: every surface states the error that is expected of it."
                ).format(date=fmt.day(calibration.date))
            )
        self._show_start()

    def _show_start(self) -> None:
        rig, running = self.services.rig.snapshot, self.services.acquisition.running
        self._start.setEnabled(rig.connected and rig.calibration is not None and not running)
        if running:
            self._ready.setText(self.tr("A scan is running."))
        elif rig.failure is not None and not rig.opening:
            self._ready.setText(" ".join(sentence_of(rig.failure.fault)))
        elif not rig.connected:
            self._ready.setText(self.tr("Opening the rig…"))
        elif rig.calibration is None:
            self._ready.setText(self.tr("The rig has to be calibrated first."))
        else:
            self._ready.setText(self.tr("Ready. The scan makes a new case.") if self.services.case.store is not None else self.tr("Ready."))
        self._on_table_caption.setText(self.tr("On the table") if rig.virtual else self.tr("Rig"))
        self._on_table.setText(specimen_words(rig.specimen) if rig.virtual else Path(rig.preset).stem)

    def _show_recent(self) -> None:
        self._recent.clear()
        for text in self.services.settings.recent_cases:
            path = Path(text)
            try:
                changed = datetime.fromtimestamp(path.stat().st_mtime)
            except OSError:
                continue
            item = QListWidgetItem()
            item.setData(Qt.ItemDataRole.UserRole, text)
            item.setToolTip(text)
            entry = _RecentCase(path, fmt.day(changed.isoformat()))
            item.setSizeHint(QSize(0, 46))
            self._recent.addItem(item)
            self._recent.setItemWidget(item, entry)
        empty = self._recent.count() == 0
        self._no_recent.setVisible(empty)
        self._recent.setVisible(not empty)

    def _open(self, item: QListWidgetItem) -> None:
        path = Path(item.data(Qt.ItemDataRole.UserRole))
        if not self.services.acquisition.running:
            QTimer.singleShot(0, lambda: self.services.case.open(path))
            self.wanted.emit("reconstruct")


class _RecentCase(QWidget):
    """A case by what its name tells."""

    def __init__(self, path: Path, day: str) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        told = read_case_name(path.stem)
        title = label(told.order if told else path.stem)
        title.setStyleSheet("font-weight: 600;")
        line = row(title, spacing=10)
        if told:
            badge = SideBadge()
            badge.show_side(told.side)
            line.addWidget(badge)
            line.addWidget(label(QCoreApplication.translate("draft", KINDS[told.kind]), "muted"))
        line.addStretch(1)
        line.addWidget(label(day, "muted"))
        line.setContentsMargins(4, 0, 4, 0)
        self.setLayout(line)
