"""What a person asks of a scan: views, points, and how certain the surface is to become."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QGridLayout, QLabel, QSpinBox

from app.draft import Draft, DraftValues
from app.views.parts import label, number_field

_FIELD_WIDTH = 120
_MOST_UM = 1000


class ScanWish(QGridLayout):
    """Three fields of the draft, one a line."""

    def __init__(self, draft: Draft) -> None:
        super().__init__()
        self._draft = draft
        self.setColumnStretch(0, 1)
        views = number_field(1, 360, 1, lambda value: draft.edit("views", value))
        points = number_field(500, 2_000_000, 1000, lambda value: draft.edit("points", value))
        until = number_field(
            0, _MOST_UM, 5, lambda value: draft.edit("until_um", value), suffix=" µm", special=QCoreApplication.translate("ScanPage", "none")
        )
        until.setToolTip(
            QCoreApplication.translate(
                "ScanPage",
                "How far off the surface may be (standard uncertainty). With a value, the scan measures more where the surface is less certain, until"
                " it is as certain everywhere that light can reach or the points are spent. With none, the points are spread evenly.",
            )
        )
        self.fields: dict[str, QSpinBox] = {"views": views, "points": points, "until_um": until}
        self._captions: dict[str, QLabel] = {}
        for line, (name, field) in enumerate(self.fields.items()):
            caption = self._captions[name] = label("", "muted", wrap=True)
            caption.setBuddy(field)
            caption.setToolTip(field.toolTip())
            field.setFixedWidth(_FIELD_WIDTH)
            self.addWidget(caption, line, 0)
            self.addWidget(field, line, 1)
        self._captions["views"].setText(QCoreApplication.translate("ScanPage", "Views"))
        self._captions["until_um"].setText(QCoreApplication.translate("ScanPage", "Uncertainty wanted"))
        draft.changed.connect(self._show)
        self._show()

    def show_fields(self, on: bool) -> None:
        """Whether the fields are shown: while a scan runs they say nothing about it."""
        for part in (*self.fields.values(), *self._captions.values()):
            part.setVisible(on)

    def _show(self, _name: str = "") -> None:
        values = self._draft.values
        for name, field in self.fields.items():
            field.setValue(getattr(values, name))
        most = QCoreApplication.translate("ScanPage", "Points at most")
        self._captions["points"].setText(most if values.until_um else QCoreApplication.translate("ScanPage", "Points"))


def start_words(values: DraftValues, *, again: bool) -> str:
    """What the button says that it will do."""
    if values.until_um:
        return QCoreApplication.translate("ScanPage", "Scan until {wanted} µm").format(wanted=values.until_um)
    return QCoreApplication.translate("ScanPage", "Scan again") if again else QCoreApplication.translate("ScanPage", "Start scan")
