"""Whether both ears of an order stand on the table, on the pair tray; there only while that can be."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox

from app.controllers.pair_tray import PairTrayController


class ScanTray(QCheckBox):
    """Ticked by the person who has put the tray on the table."""

    def __init__(self, tray: PairTrayController) -> None:
        super().__init__()
        self._tray = tray
        self.setProperty("role", "deliberate")
        self.setText(self.tr("Both ears on the pair tray"))
        self.setToolTip(
            self.tr("The left ear on seat L, the right one on seat R, the arrow at the table's zero: one run measures both for their orders")
        )
        self._asking = False
        self.toggled.connect(tray.want)
        tray.changed.connect(self._show)
        self._show()

    def show_field(self, asking: bool) -> None:
        """Whether a scan is being prepared."""
        self._asking = asking
        self._show()

    def _show(self) -> None:
        self.setVisible(self._asking and (self._tray.possible or self._tray.wanted))
        self.setChecked(self._tray.wanted)
