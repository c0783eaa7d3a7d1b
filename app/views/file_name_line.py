"""What the files of an order will be called: a live preview, and the template behind a link."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QLineEdit, QVBoxLayout, QWidget

from app.controllers.preferences import Preferences
from app.draft import DraftValues, orders_of
from app.file_names import FIELDS, PATIENT, file_name, names_the_patient, unknown_fields
from app.views.parts import button, give_role, label
from scanner_core import wall_clock


class FileNameLine(QWidget):
    """Edits the template of the settings."""

    def __init__(self, preferences: Preferences) -> None:
        super().__init__()
        self._preferences, settings = preferences, preferences.settings
        self._values = DraftValues()
        self.names = label("", "", wrap=True, selectable=True)
        self.names.setMinimumWidth(1)  # a name is one long word, which would push the form out of the window
        self.remark = label("", "muted", wrap=True)
        self._change = button(self.tr("Change the file names…"), "quiet-link", lambda: self.unfold(not self.template.isVisible()))
        self.template = QLineEdit(settings.name_template)
        self.template.setAccessibleName(self.tr("Template of the file names"))
        self.template.setToolTip(self.tr("In braces: {fields}").format(fields=", ".join(FIELDS)))
        self.template.setMinimumHeight(30)
        self.template.textEdited.connect(lambda _: self.show_order(self._values))
        self.template.editingFinished.connect(lambda: preferences.edit("name_template", self.template.text()))
        self.patient = QCheckBox(self.tr("The patient code may stand in file names"))
        self.patient.setChecked(settings.code_in_names)
        self.patient.toggled.connect(lambda on: preferences.edit("code_in_names", on))
        preferences.changed.connect(self._show_setting)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(5)
        for part in (self.names, self.remark, self._change, self.template, self.patient):
            box.addWidget(part)
        self.unfold(False)

    def unfold(self, on: bool) -> None:
        self.template.setVisible(on)
        self.patient.setVisible(on)

    def show_order(self, values: DraftValues) -> None:
        """The names of its files, and what is wrong with the template."""
        self._values = values
        template, allowed = self.template.text(), self._preferences.settings.code_in_names
        names = [file_name(template, order, 1, ".stl", wall_clock.today(), with_code=allowed) for order in orders_of(values)]
        self.names.setText("\n".join(names))
        self.names.setToolTip("\n".join(names))
        unknown = unknown_fields(template)
        remark, role = "", "muted"
        if unknown:
            told = self.tr("There is no field {unknown}; the fields are {fields}.")
            remark, role = told.format(unknown=_braced(unknown), fields=_braced(FIELDS)), "bad"
        elif len(names) > len(set(names)):
            remark, role = self.tr("Both files would have one name: put {side} into the template."), "bad"
        elif names_the_patient(template) and not allowed:
            remark = self.tr("{field} is left out: no patient in file names unless that is switched on below.").format(field=_braced((PATIENT,)))
        self.remark.setText(remark)
        self.remark.setVisible(bool(remark))
        give_role(self.remark, role)

    def _show_setting(self, name: str) -> None:
        """It was changed, here or elsewhere."""
        settings = self._preferences.settings
        if name == "name_template" and self.template.text() != settings.name_template:
            self.template.setText(settings.name_template)
        elif name == "code_in_names":
            self.patient.setChecked(settings.code_in_names)
        self.show_order(self._values)


def _braced(names: tuple[str, ...] | list[str]) -> str:
    return ", ".join(f"{{{name}}}" for name in names)
