"""How the points of the open case are computed: with which calibration, and what a spot must be; undone like every edit."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QGridLayout, QWidget

from app.services import Services
from app.views.parts import label, number_field

_WIDTH = 140


class ProcessingRows(QWidget):
    """Three lines; what is changed is done at once."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.calibration = QComboBox()
        self.calibration.addItem(self.tr("as scanned"), False)
        self.calibration.addItem(self.tr("of the rig now"), True)
        self.calibration.activated.connect(lambda _: self._choose())
        self.peak = number_field(0, 255, 5, lambda _: self._choose(), special=self.tr("as scanned"))
        self.peak.setToolTip(self.tr("Points of darker spots are left out; the brightest pixel is 255."))
        self.epipolar = number_field(0, 10, 1, lambda _: self._choose(), suffix=self.tr(" σ"), special=self.tr("as scanned"))
        self.epipolar.setToolTip(self.tr("How far the two cameras may disagree, in standard uncertainties; scanned with 3."))
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(0, 1)
        rows = ((self.tr("Calibration"), self.calibration), (self.tr("Spot peak"), self.peak), (self.tr("Epipolar gate"), self.epipolar))
        for line, (name, field) in enumerate(rows):
            caption = label(name, "muted")
            caption.setBuddy(field)
            field.setFixedWidth(_WIDTH)
            field.setAccessibleName(name)
            grid.addWidget(caption, line, 0)
            grid.addWidget(field, line, 1)
        services.case.opened.connect(self.show_choice)
        services.case.edited.connect(self.show_choice)
        services.rig.changed.connect(self._show_able)
        self.show_choice()

    def show_choice(self) -> None:
        """As the case has it."""
        choice = self._services.case.processing
        gates = choice.get("gates")
        known = gates if isinstance(gates, dict) else {}
        for field in (self.calibration, self.peak, self.epipolar):
            field.blockSignals(True)
        self.calibration.setCurrentIndex(int(choice.get("calibration") is not None))
        self.peak.setValue(round(float(known.get("least_peak_dn", 0))))
        self.epipolar.setValue(round(float(known.get("epipolar_sigmas", 0))))
        for field in (self.calibration, self.peak, self.epipolar):
            field.blockSignals(False)
        self._show_able()

    def _show_able(self) -> None:
        services = self._services
        free = services.case.store is not None and services.case.cloud is not None and not services.case.computing
        free = free and not services.acquisition.running and not services.reconstruction.mine
        for field in (self.peak, self.epipolar):
            field.setEnabled(free)
        self.calibration.setEnabled(free and (services.rig.snapshot.calibration is not None or self.calibration.currentIndex() == 1))

    def _choose(self) -> None:
        gates = {name: float(value) for name, value in (("least_peak_dn", self.peak.value()), ("epipolar_sigmas", self.epipolar.value())) if value}
        self._services.case.process(self._services.rig.snapshot.config if self.calibration.currentData() else None, gates)
        self._show_able()
