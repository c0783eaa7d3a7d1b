"""The reference sphere on the open rig: borrowed like for a scan, measured in a thread, kept in the rig's history."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.rig import RigController
from scanner_core.errors import ImprontaError, MotionStoppedError
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.log_file import log_fault

if TYPE_CHECKING:
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.metrology.sphere_check import SphereCheck

VIRTUAL_DIAMETER_MM = 22.266
"""Of the virtual bench's sphere."""


@dataclass(frozen=True, slots=True)
class CertifiedSphere:
    """What its certificate says: the diameter and its expanded uncertainty (k = 2), both mm."""

    diameter_mm: float
    uncertainty_mm: float


VIRTUAL_SPHERE = CertifiedSphere(VIRTUAL_DIAMETER_MM, 0.004)


@dataclass(frozen=True, slots=True, eq=False)
class VerificationSnapshot:
    """What is known of the measurement.

    Attributes
    ----------
    preset : the rig it is of
    running, cancelling : it is being made; it was asked to end
    fraction, left_s : how far it is, 0 to 1; estimate of the rest
    check : what was measured last in this session; None before, and once the rig is another
    rehearsed : a fault had been let happen on the virtual rig, or the rig shows a recording: it is no result of the rig
    refused : why nothing was measured
    cancelled : a person has ended it
    saving, saved : the certificate is being written; where it stands
    """

    preset: str = ""
    running: bool = False
    cancelling: bool = False
    fraction: float = 0.0
    left_s: float | None = None
    check: SphereCheck | None = None
    rehearsed: bool = False
    refused: BaseException | None = None
    cancelled: bool = False
    saving: bool = False
    saved: Path | None = None


class VerificationController(QObject):
    """One measurement at a time; `changed` after every news."""

    changed = Signal()

    def __init__(self, background: Background, rig: RigController, tell: Callable[[BaseException], None], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._background, self._rig, self._tell = background, rig, tell
        self.snapshot = VerificationSnapshot()
        self.watched = False
        """Somebody looks at the page, which says what a fault is."""
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None
        self.plan: tuple[int, int] | None = None
        """Points and views in place of the usual ones."""
        rig.changed.connect(self._hear_rig)
        rig.darkened.connect(self.cancel)

    # -------------------------------------------------------------------------------- commands
    @property
    def running(self) -> bool:
        return self.snapshot.running

    def start(self, sphere: CertifiedSphere) -> None:
        """Measure what stands on the table; the virtual rig puts its own sphere there.  Nothing while the rig is not at rest."""
        if self.running or not self._rig.snapshot.at_rest:
            return
        rig = self._rig.borrow()
        if rig is None:
            return
        preset = self._rig.snapshot.preset
        rehearsed = rig.replayed or bool(self._rig.faults)
        self._stop.clear()
        self._news(VerificationSnapshot(preset, running=True, rehearsed=rehearsed))
        work = partial(self._measure, rig, preset, sphere, not rehearsed)
        self._thread = self._background.run("sphere", work, self._done, self._failed)

    def cancel(self) -> None:
        """Laser off and end; nothing is kept."""
        if self.running:
            self._stop.set()
            self._news(replace(self.snapshot, cancelling=True))

    def save(self, path: Path, *, replace_it: bool) -> None:
        """Write the certificate of what was measured last."""
        check = self.snapshot.check
        if check is None or self.snapshot.saving:
            return
        self._news(replace(self.snapshot, saving=True, saved=None))

        def work() -> Path:
            check.write_certificate(path, replace=replace_it)
            return path

        self._background.run("certificate", work, self._saved, self._not_saved)

    def shutdown(self, timeout_s: float) -> bool:
        """End a measurement and wait for it: the rig is closed after that."""
        self._stop.set()
        if self._thread is None:
            return True
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    # -------------------------------------------------------------------------------- its thread
    def _measure(self, rig: OpenRig, preset: str, sphere: CertifiedSphere, keep: bool) -> tuple[SphereCheck, SphereTrend | None]:
        from scanner_core.metrology.reference_sphere import Reference
        from scanner_core.metrology.sphere_check import POINTS, VIEWS, keep_sphere, measure_sphere, tests_before

        self._rig.settle()
        history = self._rig.files.history(preset)
        points, views = self.plan or (POINTS, VIEWS)
        # of the radius, and a standard uncertainty
        reference = Reference(0.5 * sphere.diameter_mm, 0.25 * sphere.uncertainty_mm)
        result = measure_sphere(
            rig, reference, points=points, views=views, seed=tests_before(history), progress=self._hear, cancelled=self._stop.is_set
        )
        check = keep_sphere(result, rig, Path(preset).name, history, keep=keep)
        return check, self._rig.files.last_sphere(preset)

    def _hear(self, progress: Progress) -> None:
        self._background.post(partial(self._heard, progress.fraction, progress.seconds_left))

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _heard(self, fraction: float, left_s: float | None) -> None:
        self._rig.hear_owner()
        if self.running:
            self._news(replace(self.snapshot, fraction=fraction, left_s=left_s))

    def _done(self, measured: tuple[SphereCheck, SphereTrend | None]) -> None:
        check, trend = measured
        self._thread = None
        self._news(replace(self.snapshot, running=False, cancelling=False, check=check))
        self._rig.take_sphere(self.snapshot.preset, trend)
        self._rig.give_back()
        if check.fault is not None:
            self._tell(check.fault)

    def _failed(self, fault: Exception) -> None:
        self._thread = None
        stopped = isinstance(fault, Cancelled | MotionStoppedError)
        self._news(VerificationSnapshot(self.snapshot.preset, refused=None if stopped else fault, cancelled=stopped))
        self._rig.give_back()
        if stopped:
            return
        if self.watched and isinstance(fault, ImprontaError):
            log_fault(fault, "reference sphere")
        else:
            self._tell(fault)

    def _saved(self, path: Path) -> None:
        self._news(replace(self.snapshot, saving=False, saved=path))

    def _not_saved(self, fault: Exception) -> None:
        self._news(replace(self.snapshot, saving=False))
        self._tell(fault)

    def _hear_rig(self) -> None:
        """What was measured is of one rig, as it was calibrated then."""
        if self.running or not self.snapshot.preset:
            return
        rig, check = self._rig.snapshot, self.snapshot.check
        other = rig.preset != self.snapshot.preset
        if check is not None and rig.calibration is not None and rig.calibration is not check.occasion.calibration:
            other |= rig.calibration.identity() != check.entry.calibration_id
        if other:
            self._news(VerificationSnapshot())

    def _news(self, snapshot: VerificationSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()
