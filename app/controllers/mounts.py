"""Several mounts of one object in the open case: brought together in the worker process after every scan, or from picked points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.case import CaseController
from app.controllers.case_job import CaseJob
from app.controllers.rig import RigController
from scanner_core.acquisition.status import FinishReason
from scanner_core.jobs.progress import Cancelled

if TYPE_CHECKING:
    from pathlib import Path

    from scanner_core.acquisition.remount import RemountAdvice
    from scanner_core.case.mount_job import FoundMounts, MountCloud
    from scanner_core.case.mount_registration import MountOutcome, Picks
    from scanner_core.case.store import CaseStore


class MountsController(QObject):
    """Whatever comes of it, all points stay in the case."""

    changed = Signal()
    """It began, it ended, or what was known is stale."""
    began = Signal()
    """The mounts of a case are brought together, after a scan."""

    def __init__(
        self,
        background: Background,
        case: CaseController,
        acquisition: AcquisitionController,
        rig: RigController,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._background, self._case, self._acquisition, self._rig, self._tell = background, case, acquisition, rig, tell
        self._job = CaseJob("mounts", "register-mounts", background, case)
        self._of: CaseStore | None = None
        self.found: FoundMounts | None = None
        self.tipping = False
        """The virtual object is being put down anew."""
        case.opened.connect(self._look)
        acquisition.began.connect(self._forget)
        acquisition.ended.connect(self._after_scan)
        rig.changed.connect(self._see_rig)

    @property
    def running(self) -> bool:
        return self._job.running

    @property
    def refused(self) -> MountOutcome | None:
        """The first mount that was not joined."""
        refused = () if self.found is None else self.found.registered.refused
        return refused[0] if refused else None

    def cloud(self, mount: int) -> MountCloud | None:
        """The points of a mount."""
        clouds = () if self.found is None else self.found.clouds
        return next((cloud for cloud in clouds if cloud.mount == mount), None)

    # -------------------------------------------------------------------------------- commands
    def register(self, picks: Mapping[int, Picks] | None = None) -> None:
        """Bring the mounts of the open case together; those that were joined stay, those that were not are tried again."""
        if self._job.running or self._acquisition.running:
            return
        self._of = self._case.store
        self._job.start(partial(_request, picks or {}), lambda found: found, self._done, self._failed)
        self.changed.emit()

    def find_out(self) -> None:
        """How the mounts of a case lie that was opened with several."""
        store = self._case.store
        if store is not None and self.found is None and not self._job.running and not self._acquisition.running:
            self._background.run("mounts-count", store.next_mount, partial(self._counted, store, False), lambda _: None)

    def cancel(self) -> None:
        self._job.cancel()

    def tip(self, advice: RemountAdvice | None) -> None:
        """Put the virtual object down in another way: as advised, or on its side."""
        if self._rig.snapshot.virtual and not self.tipping:
            self.tipping = True
            self._background.run("tip", partial(_pose, advice, self._rig.snapshot.pose), self._put_down, self._not_tipped)
            self.changed.emit()

    def drain(self) -> None:
        """For the pump."""
        self._job.newest()

    def shutdown(self) -> None:
        self._job.shutdown()

    # -------------------------------------------------------------------------------- inside
    def _after_scan(self) -> None:
        store, result = self._case.store, self._acquisition.result
        if store is not None and result is not None and result.finish_reason is FinishReason.COMPLETED:
            self._background.run("mounts-count", store.next_mount, partial(self._counted, store, True), self._tell)

    def _counted(self, store: CaseStore, scanned: bool, mounts: int) -> None:
        if mounts > 1 and store is self._case.store:
            self.register()
            if scanned:
                self.began.emit()

    def _done(self, found: FoundMounts) -> None:
        if self._of is not self._case.store:
            return
        self.found = found
        self._case.change(found.keep, reread=True, step=False)
        self.changed.emit()

    def _failed(self, fault: Exception) -> None:
        self.changed.emit()
        if not isinstance(fault, Cancelled):
            self._tell(fault)

    def _look(self) -> None:
        if self._case.store is not self._of:
            self._forget()

    def _forget(self) -> None:
        self._job.cancel()
        self._of, self.found = None, None
        self.changed.emit()

    def _put_down(self, pose: str) -> None:
        self._rig.choose(pose=pose)

    def _not_tipped(self, fault: Exception) -> None:
        self.tipping = False
        self._tell(fault)
        self.changed.emit()

    def _see_rig(self) -> None:
        rig = self._rig.snapshot
        if self.tipping and not rig.opening:
            self.tipping = False
            self.changed.emit()


def _request(picks: Mapping[int, Picks], path: Path) -> object:
    from scanner_core.case.mount_job import MountsRequest

    return MountsRequest(path, picks)


def _pose(advice: RemountAdvice | None, pose: str | None) -> str:
    from scanner_core.geometry.rigid import RigidTransform
    from scanner_core.virtual.specimens.tipping import tipped_pose

    on_its_side = RigidTransform.from_vector((0.0, 1.2, 0.0), (0.0, 0.0, 0.0))
    return tipped_pose(on_its_side if advice is None else advice.transform(), pose)
