"""A rig with whose board a person's hands have to do, at the pace of this machine: the virtual bench behind a rig that does not know of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.views.board_watch_view import BoardWatchView
from scanner_core.acquisition import calibrating, rig_session
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.devices.rig import RigConfig, dump_rig, load_preset
from scanner_core.geometry.rigid import RigidTransform
from scanner_core.optics.calibration_session import CalibrationSettings
from scanner_core.virtual.bench import VirtualBench

COMMENT = "# the bench by the window"


def write_rig(path: Path) -> Path:
    """The rig file: hardware, as far as it says."""
    config = load_preset("bench")
    cameras = {side: replace(getattr(config, side), driver="opencv") for side in ("left", "right")}
    hardware = replace(config, name="Lab bench", virtual=None, image_model={}, **cameras)
    path.write_text(f"{COMMENT}\n{dump_rig(hardware)}", encoding="utf-8")
    return path


class Hands:
    """Does what the large sentence on the page says."""

    def __init__(self) -> None:
        self.bench: VirtualBench | None = None
        self._poses: Iterator[RigidTransform] = iter(())
        self._bars: Iterator[RigidTransform] = iter(())
        self._heard = ""

    def open(self, config: RigConfig, *_: Any) -> OpenRig:
        """In the place of ``open_rig``."""
        rig = self._open(load_preset("bench"))
        assert rig.bench is not None
        self.bench, rig.bench, rig.config = rig.bench, None, config
        self._poses, self._bars = iter(self.bench.operator_poses(60)), iter(self.bench.bar_poses(30))
        return rig

    def stand_in(self, patch: pytest.MonkeyPatch, views: int, bar_views: int, table_angles: int) -> None:
        self._open: Callable[[RigConfig], OpenRig] = rig_session.open_rig
        patch.setattr(rig_session, "open_rig", self.open)
        plain = calibrating.default_settings

        def few(rig: OpenRig) -> CalibrationSettings:
            return replace(plain(rig), views=views, bar_views=bar_views, table_angles=table_angles)

        patch.setattr(calibrating, "default_settings", few)

    def obey(self, page: BoardWatchView) -> None:
        """Once a sentence, and a step further where the same one comes again."""
        bench, now = self.bench, page.now
        if bench is None or now == self._heard:
            return
        self._heard = now
        if now.startswith("Lay the board"):
            bench.lay_board_on_table()
        elif now.startswith(("Hold the length bar", "Bar ")) or ("bar" in now and "similar" in now):
            bench.show_bar(next(self._bars))
        elif not now.startswith(("Hold the board still", "Hold the bar still", "Take your hands", "Angle", "Computing")):
            bench.show_board(next(self._poses))
