"""While the rig is calibrated: how far it is, what is covered, what is still missing, and a way out."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QProgressBar, QVBoxLayout, QWidget

from app.controllers.calibration import BoardLook
from app.controllers.rig import RigController
from app.views import format as fmt
from app.views.board_words import missing_texts
from app.views.coverage_map import CoverageMap
from app.views.facts import Facts
from app.views.parts import BigNumber, button, column, label, row, seam
from scanner_core.optics.board_watch import SIDES, Side

_SHOWN_WISHES = 5


class CalibratingPanel(QWidget):
    """The right half of the Rig page during a calibration."""

    def __init__(self, rig: RigController, show_transcript: Callable[[], None] | None = None) -> None:
        super().__init__()
        self._rig = rig
        self._share = BigNumber(self.tr("% done"), "hero")
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._left_time = label("", "muted")
        names: dict[Side, str] = {"left": self.tr("Camera left"), "right": self.tr("Camera right")}
        self.maps = {side: CoverageMap(names[side]) for side in SIDES}
        self._counts = {side: label("", "unit") for side in SIDES}
        maps = row(spacing=16)
        for side in SIDES:
            caption = row(label(names[side], "unit"), 1, self._counts[side])
            maps.addLayout(column(self.maps[side], caption, spacing=6), 1)
        self.spread = Facts()
        self._missing = [label("", wrap=True) for _ in range(_SHOWN_WISHES)]
        self._more = label("", "muted")
        self._cancel = button(self.tr("Cancel"), "", rig.cancel_calibration)
        self._stays = label("", "muted", wrap=True)
        box = QVBoxLayout(self)
        box.setContentsMargins(36, 34, 36, 24)
        box.setSpacing(0)
        box.addWidget(label(self.tr("Calibrating"), "section"))
        box.addWidget(self._share)
        box.addSpacing(10)
        box.addWidget(self._bar)
        box.addSpacing(8)
        box.addWidget(self._left_time)
        box.addSpacing(16)
        box.addWidget(seam())
        box.addSpacing(16)
        box.addWidget(label(self.tr("Covered by the board"), "section"))
        box.addSpacing(10)
        box.addLayout(maps)
        box.addSpacing(14)
        box.addWidget(self.spread)
        box.addSpacing(16)
        box.addWidget(seam())
        box.addSpacing(16)
        box.addWidget(label(self.tr("Still missing"), "section"))
        box.addSpacing(8)
        box.addLayout(column(*self._missing, self._more, spacing=6))
        box.addStretch(1)
        way_out = row(self._cancel, self._stays, spacing=14)
        way_out.setStretch(1, 1)
        if show_transcript is not None:
            way_out.addWidget(button(self.tr("Transcript…"), "link", show_transcript))
        box.addLayout(way_out)
        self.clear()

    @property
    def missing(self) -> list[str]:
        """What is said to be missing."""
        return [shown.text() for shown in self._missing if shown.text()]

    def clear(self) -> None:
        """Before the first look."""
        self._show_missing([])
        for side in SIDES:
            self._counts[side].setText("")
        self._show_spread(None, None)

    def show_progress(self) -> None:
        """How far it is."""
        snapshot = self._rig.snapshot
        fraction = snapshot.calibrating or 0.0
        self._share.show_number(fmt.percent(fraction))
        self._bar.setValue(round(1000 * fraction))
        left = self.tr("{left} left").format(left=fmt.left_time(snapshot.calibration_left_s))
        by_hand = snapshot.by_hand
        self._left_time.setText(left if by_hand else self.tr("{left}  ·  the virtual rig shows the board by itself").format(left=left))
        self._cancel.setEnabled(not snapshot.cancelling)
        self._cancel.setText(self.tr("Cancelling…") if snapshot.cancelling else self.tr("Cancel"))
        calibration = snapshot.calibration
        if calibration is None:
            self._stays.setText(self.tr("Without a calibration the rig cannot scan."))
        else:
            self._stays.setText(self.tr("Then the calibration of {date} stays in use.").format(date=fmt.day(calibration.date)))

    def show_look(self, look: BoardLook) -> None:
        """What all looks so far add up to."""
        watch = look.watch
        for side, covered in zip(SIDES, (watch.coverage_left, watch.coverage_right), strict=True):
            height, width = look.frames[side].image.shape
            self.maps[side].show_covered(covered, (width, height))
            self._counts[side].setText(self.tr("{n} of {count} fields").format(n=int(covered.sum()), count=covered.size))
        self._show_spread(watch.tilt_deg, watch.distance_mm)
        self._show_missing(missing_texts(watch))

    def _show_spread(self, tilt_deg: float | None, distance_mm: tuple[float, float] | None) -> None:
        tilt = fmt.NO_VALUE if tilt_deg is None else f"{tilt_deg:.0f}°"
        distance = fmt.NO_VALUE
        if distance_mm is not None:
            distance = self.tr("{near} to {far} mm").format(near=f"{distance_mm[0]:.0f}", far=f"{distance_mm[1]:.0f}")
        self.spread.show_facts(((self.tr("Largest tilt between two boards"), tilt, ""), (self.tr("Distances of the board"), distance, "")))

    def _show_missing(self, texts: list[str]) -> None:
        for place, shown in enumerate(self._missing):
            shown.setText(texts[place] if place < len(texts) else "")
            shown.setVisible(bool(shown.text()))
        more = len(texts) - len(self._missing)
        self._more.setText(self.tr("and {n} more").format(n=more) if more > 0 else self.tr("Nothing: all views are taken.") if not texts else "")
        self._more.setVisible(bool(self._more.text()))
