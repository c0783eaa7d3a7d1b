"""Aiming by live pictures: the laser lit by a person's deed and while the page is looked at, the beam and the table moved by hand.

All that concerns devices happens in the rig's device thread.  The spot goes dark when the page is left, on Esc, when nobody has
touched anything for a while, and with every fault.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QObject, Signal
from PySide6.QtGui import QUndoStack

from app.background import Background
from app.controllers.aim_change import AimChange
from app.controllers.aim_snapshot import AimJob, AimSnapshot
from app.controllers.rig import RigController
from app.controllers.tapped_camera import TappedCamera
from scanner_core.acquisition.handover import LatestSlot
from scanner_core.errors import ImprontaError, UsageError
from scanner_core.jobs.progress import Cancelled, Progress

if TYPE_CHECKING:
    from scanner_core.acquisition.learning import LearnedSizes
    from scanner_core.acquisition.live_look import LiveEye, LiveLook
    from scanner_core.acquisition.rig_session import OpenRig
    from scanner_core.devices.aim_settings import AimSettings
    from scanner_core.devices.camera import Frame
    from scanner_core.devices.material import Material

UNTOUCHED_S = 45.0
"""So long the spot stays lit without anybody's doing; the driver's own limit is a minute."""
_RENEWED_S = 20.0
"""A person who goes on working has the driver's minute begun anew."""
_LIVE_S, _DARK_S = 0.09, 0.25
"""Between two looks."""
_SPEED_DEG_S = 30.0
_REPLAYED = "replay"

Work = Callable[["OpenRig", Callable[[], bool]], object]


class AimController(QObject):
    """`changed` after every news; the pictures wait in :attr:`looks`, what was seen of sizes in :attr:`sizes`."""

    changed = Signal()

    def __init__(
        self,
        background: Background,
        rig: RigController,
        stack: QUndoStack,
        materials: Path,
        tell: Callable[[BaseException], None],
        parent: QObject | None = None,
    ) -> None:
        """`materials` is the folder of a person's own ones."""
        super().__init__(parent)
        self._background, self._rig, self._stack, self._folder, self._tell = background, rig, stack, materials, tell
        self.snapshot = AimSnapshot()
        self.looks: LatestSlot[LiveLook] = LatestSlot()
        self.sizes: deque[tuple[int, bool]] = deque(maxlen=4000)
        """Area in pixels of every candidate, and whether it was accepted; filled by the device thread, emptied by the page."""
        self._shown = False
        self._touched_s = 0.0
        self._lit_s: float | None = None
        self._jogged: dict[str, float] = {}
        self._run = 0
        self._eye: tuple[object, LiveEye] | None = None
        rig.changed.connect(self._hear)
        rig.darkened.connect(self.end)

    # -------------------------------------------------------------------------------- the page and the laser
    def show(self, on: bool) -> None:
        """The page is looked at, or no longer: then the laser is off."""
        if on == self._shown:
            return
        self._shown = on
        if not on:
            self.end()
            self._rig.watch_with(None)
            return
        if not self.snapshot.materials:
            self._background.run("materials", partial(_materials, self._folder), self._take_materials, self._tell)
        self._rig.watch_with(self._look, _DARK_S)
        self._hear()

    @property
    def possible(self) -> bool:
        """The rig is open, idle, and its pictures are not recorded ones."""
        rig = self._rig.snapshot
        recorded = rig.config is not None and _REPLAYED in (rig.config.left.driver, rig.config.right.driver)
        return self._shown and rig.connected and not rig.busy and rig.calibrating is None and not recorded

    def start(self) -> None:
        """A person wants to see the spot: light it, and find the object where it is not seen at once."""
        if self.snapshot.live or not self.possible:
            return
        self.touch()
        self._rig.aim(True)
        self._rig.watch_with(self._look, _LIVE_S)
        self._news(replace(self.snapshot, live=True, left_s=UNTOUCHED_S))
        self._do(AimJob.FIND, _find)

    def end(self) -> None:
        """Laser off, whatever it was wanted for."""
        self._run += 1
        self._jogged.clear()
        if not self.snapshot.live:
            return
        self._rig.use(self._darken)
        if self._shown:
            self._rig.watch_with(self._look, _DARK_S)
        self._news(replace(self.snapshot, live=False, left_s=None, job=AimJob.NONE, fraction=None))
        self._rig.aim(False)

    def touch(self) -> None:
        """A person is there."""
        self._touched_s = time.monotonic()

    def tick(self) -> None:
        """For the page, while it is looked at: time runs out."""
        if not self.snapshot.live:
            return
        left_s = UNTOUCHED_S - (time.monotonic() - self._touched_s)
        if left_s <= 0:
            self.end()
        elif self.snapshot.left_s is None or int(left_s) != int(self.snapshot.left_s):
            self._news(replace(self.snapshot, left_s=left_s))

    # -------------------------------------------------------------------------------- moving
    def jog(self, **degrees: float) -> None:
        """Move by so many degrees: ``x_deg``, ``y_deg``, ``table_deg``.  What is asked for while something moves is done in one go."""
        self.touch()
        if self.snapshot.job not in (AimJob.NONE, AimJob.MOVE) or not self.possible:
            return
        waiting = bool(self._jogged)
        for axis, value in degrees.items():
            self._jogged[axis] = self._jogged.get(axis, 0.0) + value
        if not waiting:
            self._do(AimJob.MOVE, self._jog)

    def point(self, side: str, pixel: tuple[float, float]) -> None:
        """Bring the spot to a place in a camera's picture."""
        self.touch()
        if self.snapshot.live and self.snapshot.job is AimJob.NONE:
            self._do(AimJob.POINT, partial(_point, side, pixel))

    # -------------------------------------------------------------------------------- settings
    def expose(self) -> None:
        """Exposure and gain by what both cameras see of the spot."""
        self.touch()
        if self.snapshot.live and self.snapshot.job is AimJob.NONE:
            self._do(AimJob.EXPOSE, self._expose)

    def learn(self) -> None:
        """Limits of the spot's size from two seconds of live pictures, while the beam moves a little."""
        self.touch()
        if self.snapshot.live and self.snapshot.job is AimJob.NONE:
            self.sizes.clear()
            self._do(AimJob.LEARN, self._learn)

    def limit(self, min_area_px: int, max_area_px: int) -> None:
        """A person has moved a limit."""
        self.touch()
        settings = self.snapshot.settings
        if settings is not None:
            spot = replace(settings.spot, min_area_px=min_area_px, max_area_px=max_area_px)
            self._set(replace(settings, spot=spot), "limits")

    def choose(self, material: Material | None) -> None:
        """Set exposure and detector for a material; as the rig's own file says for None."""
        self.touch()
        filed = self._rig.files.filed(self._rig.snapshot.preset)
        if filed is None:
            return
        if material is not None:
            self._set(material.settings(filed), "material")
            return
        from scanner_core.devices.aim_settings import AimSettings

        self._set(AimSettings.of(filed), "material")

    def keep(self, title: str) -> None:
        """Keep what is set now as a material of a person's own."""
        settings = self.snapshot.settings
        if settings is None:
            return
        reason = QCoreApplication.translate("aim", "As it was set on the Aim page.")

        def work() -> tuple[Material, tuple[Material, ...]]:
            from scanner_core.devices.material import keep_material

            return keep_material(title, settings, reason, self._folder), _materials(self._folder)[0]

        def done(kept: tuple[Material, tuple[Material, ...]]) -> None:
            self._news(replace(self.snapshot, materials=kept[1]))
            self._set(replace(settings, material=kept[0].id), "material")

        self._background.run("keep-material", work, done, self._tell)

    # -------------------------------------------------------------------------------- the device thread
    def _look(self, rig: OpenRig) -> None:
        status = rig.motion.status()
        lit_s, now_s = self._lit_s, time.monotonic()
        if lit_s is not None and status.laser_power <= 0:  # by the driver, or the board itself
            self._lit_s = None
            self._background.post(self.end)
        elif lit_s is not None and now_s - lit_s > _RENEWED_S and self._touched_s > lit_s:
            self._light(rig)
        if _REPLAYED in (rig.config.left.driver, rig.config.right.driver):
            return  # its pictures are those of a measurement, which would miss them
        key = (rig.config, rig.calibration)
        if self._eye is None or self._eye[0] != key:
            from scanner_core.acquisition.live_look import LiveEye

            self._eye = key, LiveEye(rig.config, rig.calibration)
        self._put(self._eye[1].look(rig.left.grab(), rig.right.grab(), status.table_deg))

    def _put(self, look: LiveLook) -> None:
        self.looks.put(look)
        if self._lit_s is not None or self.snapshot.job is AimJob.LEARN:
            self.sizes.extend((candidate.area_px, candidate.accepted) for seen in look.looks.values() for candidate in seen.candidates)

    def _light(self, rig: OpenRig) -> None:
        rig.motion.laser(True)
        self._lit_s = time.monotonic()

    def _darken(self, rig: OpenRig) -> None:
        self._lit_s = None
        rig.motion.laser(False)

    def _do(self, job: AimJob, work: Work) -> None:
        """Have something done with the lit spot, and light it again after; nothing of it once :meth:`end` was asked for."""
        run = self._run
        self._news(replace(self.snapshot, job=job, fraction=None))

        def over() -> bool:
            return run != self._run

        def done() -> None:
            if not over():
                self._news(replace(self.snapshot, job=AimJob.NONE, fraction=None))

        def doing(rig: OpenRig) -> None:
            try:
                if over():
                    return
                work(rig, over)
                if not over() and self.snapshot.live:
                    self._light(rig)
            except Cancelled:
                pass
            except UsageError as fault:  # beyond a limit: nothing was moved, and what was lit is lit
                self._tell(fault)
            except BaseException:
                self._background.post(self.end)
                raise
            finally:
                self._background.post(done)

        self._rig.use(doing)

    def _jog(self, rig: OpenRig, over: Callable[[], bool]) -> None:
        degrees, self._jogged = self._jogged, {}
        limits = rig.config.limits
        if not over():
            rig.motion.jog(**degrees, speed_deg_s=min(_SPEED_DEG_S, limits.travel_speed_deg_s, limits.table_speed_deg_s))

    def _expose(self, rig: OpenRig, over: Callable[[], bool]) -> None:
        from scanner_core.acquisition.exposing import propose_for_rig
        from scanner_core.optics.auto_exposure import ExposureVerdict

        before = rig.motion.status()

        def tapped(_: Frame) -> None:
            if over():
                raise Cancelled

        found = propose_for_rig(replace(rig, left=TappedCamera(rig.left, tapped), right=TappedCamera(rig.right, tapped)))
        results = found[rig.left.name], found[rig.right.name]
        rig.motion.aim(before.x_deg, before.y_deg)
        readings = results[0].readings[-1], results[1].readings[-1]
        good = all(result.verdict is ExposureVerdict.GOOD for result in results) and all(reading.exposure_ms > 0 for reading in readings)
        exposed = results[0].verdict.value, results[1].verdict.value
        exposures = readings[0].exposure_ms, readings[1].exposure_ms
        gains = readings[0].gain_db, readings[1].gain_db

        def take() -> None:
            self._news(replace(self.snapshot, exposed=exposed))
            settings = self.snapshot.settings
            if good and settings is not None:
                self._set(replace(settings, exposure_ms=exposures, gain_db=gains), "exposure")

        self._background.post(take)

    def _learn(self, rig: OpenRig, over: Callable[[], bool]) -> None:
        from scanner_core.acquisition.learning import learn_sizes

        def tell(told: Progress) -> None:
            self._background.post(lambda: None if over() else self._news(replace(self.snapshot, fraction=told.fraction)))

        learned = learn_sizes(rig, progress=tell, cancelled=over, on_look=self._put)
        self._background.post(partial(self._take_learned, learned))

    def _apply(self, settings: AimSettings, rig: OpenRig) -> None:
        """What the cameras make of it is what counts, and what a case records."""
        for camera, exposure_ms, gain_db in zip((rig.left, rig.right), settings.exposure_ms, settings.gain_db, strict=True):
            if exposure_ms > 0 and camera.exposure_ms > 0:
                camera.exposure_ms, camera.gain_db = exposure_ms, gain_db
        used = replace(
            settings,
            exposure_ms=(rig.left.exposure_ms, rig.right.exposure_ms),
            gain_db=(rig.left.gain_db, rig.right.gain_db),
        )
        rig.config = used.applied(rig.config)
        self._rig.reconfigure(rig.config)

    # -------------------------------------------------------------------------------- back in the GUI thread
    def _hear(self) -> None:
        """The rig has news: another one, other settings, or it is gone."""
        rig = self._rig.snapshot
        if self.snapshot.live and (not rig.connected or rig.busy or rig.failure is not None or rig.calibrating is not None):
            self.end()
        if self._lit_s is not None and not self.snapshot.live and rig.connected and not rig.busy:
            self._rig.use(self._darken)  # it was lent just when it was to be darkened
        settings = None if rig.config is None else self._rig.files.aimed(rig.preset)
        if settings != self.snapshot.settings:
            self._news(replace(self.snapshot, settings=settings))
        else:
            self.changed.emit()

    def _take_materials(self, found: tuple[tuple[Material, ...], list[ImprontaError]]) -> None:
        self._news(replace(self.snapshot, materials=found[0]))
        for fault in found[1]:
            self._tell(fault)

    def _take_learned(self, learned: LearnedSizes) -> None:
        self._news(replace(self.snapshot, learned=learned))
        settings = self.snapshot.settings
        if learned.limits is not None and settings is not None:
            self._set(replace(settings, spot=learned.limits.of(settings.spot)), "learned")

    def _set(self, settings: AimSettings, what: str) -> None:
        """A person's change, which can be taken back."""
        before = self.snapshot.settings
        if before is not None and settings != before:
            self._stack.push(AimChange(self.put, self._rig.snapshot.preset, before, settings, what))

    def put(self, preset: str, settings: AimSettings) -> None:
        """Use and keep settings of a rig, without a way back; for the undo stack."""
        self._rig.files.hold_aim(preset, settings)
        self._background.run("keep-aim", partial(self._rig.files.keep_aim, preset), None, self._tell)
        if preset == self._rig.snapshot.preset:
            self._rig.use(partial(self._apply, settings))
            self._news(replace(self.snapshot, settings=settings))

    def _news(self, snapshot: AimSnapshot) -> None:
        self.snapshot = snapshot
        self.changed.emit()


def _find(rig: OpenRig, over: Callable[[], bool]) -> None:
    from scanner_core.acquisition.pointing import find_object

    find_object(rig, over)


def _point(side: str, pixel: tuple[float, float], rig: OpenRig, over: Callable[[], bool]) -> None:
    from scanner_core.acquisition.pointing import point_at

    point_at(rig, side, pixel, over)


def _materials(folder: Path) -> tuple[tuple[Material, ...], list[ImprontaError]]:
    from scanner_core.devices.material import own_materials, shipped_materials

    own, faults = own_materials(folder)
    return (*shipped_materials(), *own), list(faults)
