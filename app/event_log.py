"""What of the window goes into the log: the rig's failures and openings; and whose names must not, as they are known now."""

from __future__ import annotations

from PySide6.QtCore import QObject

from app.controllers.device_failure import DeviceFailure
from app.controllers.rig_snapshot import PRESETS
from app.services import Services
from scanner_core.log_file import keep_out, keep_out_now, log_fault
from scanner_core.support.private_names import PrivateName, file_names, folder_names, order_names


class EventLog(QObject):
    """Listens to the controllers until it is closed."""

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._failure: DeviceFailure | None = None
        self._forget = keep_out_now(self._current)
        settings = services.settings
        keep_out(order_names(settings.last_order))
        keep_out(file_names([*settings.recent_cases, *(name for name in settings.own_rigs)]))
        services.rig.changed.connect(self._note_rig)
        services.case.opened.connect(self._keep_case)

    def close(self) -> None:
        self._forget()

    def names(self) -> tuple[PrivateName, ...]:
        """All that the window knows now."""
        return tuple(self._current())

    def _current(self) -> list[PrivateName]:
        """From any thread: order and folders as they stand in the window."""
        values, settings, path = self._services.draft.values, self._services.settings, self._services.case.path
        names = [*order_names(values.order, values.patient_code), *folder_names([settings.case_folder, settings.export_folder])]
        return [*names, *file_names([] if path is None else [path])]

    def _keep_case(self) -> None:
        """Lines about it may come when it is closed already."""
        keep_out(self._current())

    def _note_rig(self) -> None:
        rig = self._services.rig.snapshot
        if rig.preset not in PRESETS:
            keep_out(file_names([rig.preset]))
        failure, before = rig.failure, self._failure
        self._failure = failure
        if failure is not None and not failure.same_as(before):
            log_fault(failure.fault, f"rig, {failure.device}")
