"""The support bundle of the window: collected beside the work, shown, and saved where a person says; nothing is sent."""

from __future__ import annotations

import threading
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication

from app.controllers.rig_snapshot import RigSnapshot
from app.controllers.transcript import Line
from app.services import Services
from scanner_core.errors import ImprontaError
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.support.private_names import PrivateName, file_names, order_names

if TYPE_CHECKING:
    from scanner_core.support.bundle import SupportBundle


@dataclass(frozen=True, slots=True, eq=False)
class SupportState:
    """`bundle` is what can be looked at; `fraction` 0 to 1 while one is collected; `written` where it was saved, `refused` why not."""

    bundle: SupportBundle | None = None
    fraction: float | None = None
    writing: bool = False
    written: Path | None = None
    refused: Exception | None = None


class SupportController(QObject):
    """`changed` after every news."""

    changed = Signal()

    def __init__(self, services: Services, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self._cancelled = threading.Event()
        self.state = SupportState()

    def collect(self) -> None:
        """Begin to collect; the devices are asked nothing and nothing moves."""
        if self.state.fraction is not None:
            return
        self._cancelled.clear()
        services = self._services
        rig, lines = services.rig.snapshot, services.rig.transcript()
        settings, display, names = asdict(services.settings), _display(), self._names()
        self._news(SupportState(fraction=0.0))

        def work() -> SupportBundle:
            from scanner_core.devices.rig import dump_rig
            from scanner_core.support.bundle import SupportSources, collect

            sources = SupportSources(
                examine=lambda: _report(rig, lines),
                rig_text="" if rig.config is None else dump_rig(rig.config),
                rig_source=rig.preset,
                settings=settings,
                display=display,
                names=names,
            )
            return collect(sources, progress=self._tell, cancelled=self._cancelled.is_set)

        services.background.run("support", work, self._collected, self._failed)

    def cancel(self) -> None:
        """What was being collected is not wanted any more."""
        self._cancelled.set()

    def save(self, path: Path, without: Collection[str]) -> None:
        """Write what is shown, but those; a file that is there is replaced, the dialog has asked."""
        bundle = self.state.bundle
        if bundle is None or self.state.writing:
            return
        self._news(replace(self.state, writing=True, written=None, refused=None))

        def work() -> Path:
            from scanner_core.support.bundle import write_bundle

            write_bundle(bundle.without(list(without)), path, force=True)
            return path

        self._services.background.run("support", work, self._written, self._failed)

    def _names(self) -> tuple[PrivateName, ...]:
        values, path = self._services.draft.values, self._services.case.path
        return (*order_names(values.order, values.patient_code), *file_names([] if path is None else [path]))

    def _tell(self, told: Progress) -> None:
        self._services.background.post(partial(self._progressed, told.fraction))

    def _progressed(self, fraction: float) -> None:
        if self.state.fraction is not None:
            self._news(replace(self.state, fraction=fraction))

    def _collected(self, bundle: SupportBundle) -> None:
        self._news(SupportState(bundle))

    def _written(self, path: Path) -> None:
        self._news(replace(self.state, writing=False, written=path))

    def _failed(self, fault: Exception) -> None:
        refused = None if isinstance(fault, Cancelled) else fault
        self._news(replace(self.state, fraction=None, writing=False, refused=refused))

    def _news(self, state: SupportState) -> None:
        self.state = state
        self.changed.emit()


def _report(rig: RigSnapshot, lines: list[Line]) -> Mapping[str, Any]:
    """The doctor's report as far as it needs no device to move: in the manner of ``impronta doctor --json``."""
    from scanner_core.commissioning.calibration_check import check_calibration
    from scanner_core.commissioning.machine import check_machine
    from scanner_core.devices.check import Check

    checks = check_machine()
    if rig.config is not None:
        checks.append(check_calibration(rig.config))
    if rig.failure is not None:
        fault: ImprontaError = rig.failure.fault
        checks.append(Check(rig.failure.device, "fail", f"{fault.message} [{fault.code}]", fault.hint))
    words = "open" if rig.connected else "not open"
    checks.append(Check("rig", "pass" if rig.connected else "fail", f"{words}; the devices were not asked anew.", "Run 'impronta doctor'."))
    transcript = [{"t_s": line.t_s or 0.0, "direction": line.direction, "line": line.text} for line in lines]
    cameras = [{"name": name, **asdict(report)} for name, report in rig.cameras.items()]
    values: dict[str, Any] = {"rig": rig.preset, "checks": [asdict(check) for check in checks]}
    return values | {"controller": {**rig.controller, "transcript": transcript}, "cameras": cameras}


def _display() -> dict[str, object]:
    """Screens as Qt sees them, in the GUI thread."""
    screens = [
        {"size": [screen.size().width(), screen.size().height()], "pixel_ratio": screen.devicePixelRatio(), "rate_hz": screen.refreshRate()}
        for screen in QGuiApplication.screens()
    ]
    return {"platform": QGuiApplication.platformName(), "screens": screens}
