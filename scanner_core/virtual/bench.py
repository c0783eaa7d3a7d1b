"""The virtual rig: cameras, laser, table, and what a person puts before them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import replace
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.clock import Clock
from scanner_core.devices.marks_config import MarksConfig
from scanner_core.errors import UsageError
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.board import DEFAULT_BAR, DEFAULT_TARGET, CharucoTarget, LengthBar
from scanner_core.optics.calibration import StereoCalibration, TurntableAxis
from scanner_core.optics.camera_model import CameraModel
from scanner_core.virtual.bench_faults import BenchFault, ShinyPatch
from scanner_core.virtual.board import BoardRenderer, flat_on_table, operator_poses
from scanner_core.virtual.camera import VirtualCamera
from scanner_core.virtual.disturbed import Disturbed, SlippingTable
from scanner_core.virtual.exposure import Exposure, Shutter
from scanner_core.virtual.image_formation import ImageSensor
from scanner_core.virtual.laser_fan import LaserFan
from scanner_core.virtual.line_view import LineView
from scanner_core.virtual.mechanics import PlayTimeline, warm_up_px
from scanner_core.virtual.motion_state import MotionTimeline
from scanner_core.virtual.presets import VirtualPreset
from scanner_core.virtual.print_errors import FAULTLESS, TYPICAL, BoardFaults
from scanner_core.virtual.projection import ImagePoints
from scanner_core.virtual.rim_balls import RimBalls
from scanner_core.virtual.scene import Scene
from scanner_core.virtual.specimens.specimen import Specimen

_SIDES = ("left", "right")
_REMEMBERED = 64
"""Exposures kept for the other camera."""


class VirtualBench:
    """A rig that exists in numbers only.

    The cameras may be read from two threads; an exposure that both take is computed once.  While the board is shown the
    room's lamp is on and the laser's light is not rendered.

    Parameters
    ----------
    preset : true geometry and image model
    specimen : what stands on the table, or None
    clock : shared with the controller
    timeline : where beam and table are
    seed : of all noise, speckle and board poses
    target, faults : the board as it was drawn, and how the one at hand differs
    bar : the plate of known length; it is as certified
    marks : the balls on the table's rim by the rig file, or None
    fan : the laser makes a line instead of a spot
    """

    def __init__(
        self,
        preset: VirtualPreset,
        specimen: Specimen | None,
        clock: Clock,
        timeline: MotionTimeline,
        seed: int = 0,
        target: CharucoTarget = DEFAULT_TARGET,
        faults: BoardFaults = TYPICAL,
        bar: LengthBar = DEFAULT_BAR,
        marks: MarksConfig | None = None,
        fan: LaserFan | None = None,
    ) -> None:
        self.preset, self.target, self.seed = preset, target, seed
        self._disturbed = Disturbed(preset)
        self._clock = clock
        self._timeline = SlippingTable(PlayTimeline(timeline, preset.backlash_deg), self._disturbed)
        self._sensors = (ImageSensor(preset, 0, seed), ImageSensor(preset, 1, seed))
        self._renderers = (BoardRenderer(preset, 0, target, faults), BoardRenderer(preset, 1, target, faults))
        self.bar = bar
        self._bar_renderers: tuple[BoardRenderer, BoardRenderer] | None = None
        self._board_lowest_mm = self._renderers[0].errors.lowest_mm()
        self._bar_shown = False
        self._shutter = Shutter(preset, seed)
        self._marks = marks
        self._scene = Scene(preset, specimen, balls=self._balls(None))
        self._line = None if fan is None else LineView(preset, fan, specimen, seed)
        self._changed: tuple[tuple[ShinyPatch | None, int | None], Scene] | None = None
        self._lock = threading.Lock()
        self._exposures: OrderedDict[tuple[float, float], Exposure] = OrderedDict()
        self._board: RigidTransform | Literal["table"] | None = None
        self._board_images: dict[int, tuple[object, NDArray[np.float32]]] = {}

    @property
    def timeline(self) -> MotionTimeline:
        """Where beam and table really are; for tests alone."""
        return self._timeline

    @property
    def specimen(self) -> Specimen | None:
        """What stands on the table."""
        return self._scene.specimen

    def camera(self, side: Literal["left", "right"], transfer_frames: int = 1) -> VirtualCamera:
        """One of the two cameras; opened anew by every call."""
        if side not in _SIDES:
            raise UsageError("E-USE-01", what=f"The rig has no camera '{side}'", do="choose left or right")
        index = _SIDES.index(side)
        p = self.preset
        return VirtualCamera(side, index, p.cameras[index].size_px, p.rate_hz, p.exposure_ms, self._clock, self, transfer_frames, self._disturbed)

    # ------------------------------------------------------------------------------------------ a person's operations
    def let_happen(self, fault: BenchFault) -> None:
        """Let something go wrong, at its time on the rig's clock."""
        self._disturbed.let_happen(fault)

    def change_specimen(self, specimen: Specimen | None) -> None:
        """Put something else on the table, or nothing."""
        scene = Scene(self.preset, specimen, balls=self._balls(None))
        with self._lock:
            self._scene, self._changed = scene, None
            self._exposures.clear()
            if self._line is not None:
                self._line.change_specimen(specimen)

    def show_board(self, pose: RigidTransform | None) -> None:
        """Hold the board before the cameras; `pose` takes its frame to the table frame, None takes it away."""
        with self._lock:
            self._board, self._bar_shown = pose, False

    def show_bar(self, pose: RigidTransform) -> None:
        """Hold the length bar before the cameras; `pose` takes its plate's frame to the table frame."""
        with self._lock:
            if self._bar_renderers is None:
                left, right = (BoardRenderer(self.preset, index, self.bar.plate, FAULTLESS) for index in (0, 1))
                self._bar_renderers = left, right
            self._board, self._bar_shown = pose, True

    def lay_board_on_table(self) -> None:
        """Lay the board flat on the table; it turns with it."""
        with self._lock:
            self._board, self._bar_shown = "table", False

    def remove_board(self) -> None:
        """Take the board away."""
        self.show_board(None)

    def operator_poses(self, count: int = 24, seed: int | None = None) -> list[RigidTransform]:
        """How a person would hold the board, see :func:`~scanner_core.virtual.board.operator_poses`."""
        return operator_poses(self.preset, self.target, count, self.seed if seed is None else seed)

    def bar_poses(self, count: int) -> list[RigidTransform]:
        """How a person would hold the length bar: both of its ends in both images."""
        return operator_poses(self.preset, self.bar.plate, count, self.seed + 1, whole=True)

    def board_operator(self) -> BenchOperator:
        """Somebody who shows the board for a calibration."""
        return BenchOperator(self)

    # ------------------------------------------------------------------------------------------ the cameras' side
    def image(self, index: int, start_s: float, exposure_ms: float, gain: float, key: int) -> NDArray[np.uint8]:
        """The frame of camera `index` (0 left) for an exposure that has ended; `key` chooses its noise."""
        sensor = self._sensors[index]
        with self._lock:
            if self._board is not None:
                signal = self._drifted(self._board_signal(index, start_s + 0.5e-3 * exposure_ms), index, start_s)
                return sensor.lit_frame(signal * np.float32(exposure_ms / self.preset.exposure_ms), key, gain)
            room_dn = (self.preset.ambient_dn + self._disturbed.ambient_dn(start_s)) * exposure_ms / self.preset.exposure_ms
            if self._line is not None:
                signal = self._line.signal(index, self._timeline, start_s, exposure_ms, self._disturbed.image_shift_px(index, start_s))
                return sensor.lit_frame(signal + np.float32(room_dn), key, gain)
            spot = self._expose(start_s, exposure_ms).spots[index]
        if spot is not None:
            spot = self._displaced(spot, index, start_s)
        return sensor.frame(spot, key, gain, room_dn)

    def _expose(self, start_s: float, exposure_ms: float) -> Exposure:
        instant = (start_s, exposure_ms)
        exposure = self._exposures.get(instant)
        if exposure is None:
            exposure = self._shutter.expose(self._scene_at(start_s), self._timeline, start_s, exposure_ms)
            self._exposures[instant] = exposure
            if len(self._exposures) > _REMEMBERED:
                self._exposures.popitem(last=False)
        return exposure

    def _displaced(self, spot: ImagePoints, index: int, time_s: float) -> ImagePoints:
        """The spot in the image of a camera that was moved, or whose lens is warm."""
        dx, dy = self._disturbed.image_shift_px(index, time_s)
        if dx or dy:
            spot = replace(spot, x_px=spot.x_px + dx, y_px=spot.y_px + dy)
        if grown := self._disturbed.magnified(time_s):
            x, y = self.preset.cameras[index].matrix[:2, 2]
            spot = replace(spot, x_px=spot.x_px + grown * (spot.x_px - x), y_px=spot.y_px + grown * (spot.y_px - y))
        return spot

    def _scene_at(self, time_s: float) -> Scene:
        change = self._disturbed.shiny(time_s), self._disturbed.lost_mark(time_s)
        if change == (None, None):
            return self._scene
        if self._changed is None or self._changed[0] != change:
            self._changed = change, Scene(self.preset, self._scene.specimen, change[0], self._balls(change[1]))
        return self._changed[1]

    def _balls(self, lost: int | None) -> RimBalls | None:
        return None if self._marks is None else RimBalls(self._marks, lost)

    def _board_signal(self, index: int, time_s: float) -> NDArray[np.float32]:
        board = self._board
        if isinstance(board, RigidTransform):
            known: object = board
            pose = board
        else:
            table_deg = self._timeline.instant(time_s).table_deg
            known, pose = table_deg, flat_on_table(self.target, table_deg, self._board_lowest_mm)
        renderers = self._bar_renderers if self._bar_shown and self._bar_renderers is not None else self._renderers
        remembered = self._board_images.get(index)
        if remembered is None or remembered[0] != known:
            remembered = (known, renderers[index].signal(pose))
            self._board_images[index] = remembered
        return remembered[1]

    def _drifted(self, signal: NDArray[np.float32], index: int, time_s: float) -> NDArray[np.float32]:
        """The image as the warm camera has it; a few hundredths of a pixel, so that interpolation does not blur it."""
        x, y = warm_up_px(self.preset, index, time_s)
        if x == y == 0:
            return signal
        shift = np.array([[1.0, 0.0, x], [0.0, 1.0, y]])
        moved = cv2.warpAffine(signal, shift, signal.shape[::-1], flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(moved, np.float32)

    # ------------------------------------------------------------------------------------------ for tests alone
    def truth_calibration(self) -> StereoCalibration:
        """The true cameras and axis in the left camera's frame.  Tests compare with it; the product measures its own."""
        left, right = self.preset.cameras
        turn = right.rotation @ left.rotation.T
        return StereoCalibration(
            left=CameraModel(left.matrix, left.distortion, np.eye(3), np.zeros(3), left.size_px),
            right=CameraModel(right.matrix, right.distortion, turn, right.translation - turn @ left.translation, right.size_px),
            turntable=TurntableAxis(left.translation.copy(), left.rotation[:, 2].copy()),
            date="1970-01-01",
            views=0,
            reprojection_rms_px=0.0,
            held_out_rms_um=0.0,
        )


class BenchOperator:
    """Shows the board on the virtual bench; see :class:`~scanner_core.optics.calibration_session.BoardOperator`."""

    by_hand = False

    def __init__(self, bench: VirtualBench) -> None:
        self._bench = bench
        self._poses: list[RigidTransform] = []
        self._bar_poses: list[RigidTransform] = []

    def show(self, index: int, count: int) -> None:
        """Pose `index` of a list of `count` seeded poses."""
        if len(self._poses) != count:
            self._poses = self._bench.operator_poses(count)
        self._bench.show_board(self._poses[index])

    def show_bar(self, index: int, count: int) -> None:
        """Pose `index` of a list of `count` seeded poses of the length bar."""
        if len(self._bar_poses) != count:
            self._bar_poses = self._bench.bar_poses(count)
        self._bench.show_bar(self._bar_poses[index])

    def lay_on_table(self) -> None:
        """Lay it flat about the table's middle."""
        self._bench.lay_board_on_table()

    def remove(self) -> None:
        """Take it away."""
        self._bench.remove_board()
