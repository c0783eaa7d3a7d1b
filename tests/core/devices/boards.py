"""Firmware models for tests: in this process on a stepped clock, or in a process of their own."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

from scanner_core.clock import SteppedClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import GrblController, open_controller
from scanner_core.virtual.firmware import Firmware
from scanner_core.virtual.firmware_registry import register_firmware, unregister_firmware
from scanner_core.virtual.firmware_settings import FirmwareSettings
from scanner_core.virtual.remote_timeline import RemoteTimeline


@dataclass(frozen=True, slots=True)
class Board:
    """A firmware model in this process and how to open it."""

    clock: SteppedClock
    firmware: Firmware
    config: ControllerConfig

    def open(self) -> GrblController:
        return open_controller(self.config, self.clock)


@contextmanager
def board(name: str = "board", table_axis: str = "Z", **settings: Any) -> Iterator[Board]:
    clock = SteppedClock()
    firmware = Firmware(clock, replace(FirmwareSettings(), **settings))
    register_firmware(name, firmware)
    try:
        yield Board(clock, firmware, ControllerConfig("grbl", f"virtual://{name}", table_axis=table_axis))
    finally:
        unregister_firmware(name)


@dataclass(frozen=True, slots=True)
class RemoteBoard:
    """A firmware model in another process, with its witness."""

    url: str
    witness: RemoteTimeline
    side_channel: str

    @property
    def config(self) -> ControllerConfig:
        return ControllerConfig("grbl", self.url, witness=self.side_channel)

    def open(self) -> GrblController:
        return open_controller(self.config, self.witness.clock)


@contextmanager
def remote_board(**settings: Any) -> Iterator[RemoteBoard]:
    process = subprocess.Popen(
        [sys.executable, "-m", "scanner_core.virtual.firmware_process", "--settings", json.dumps({"boot_s": 0.02, **settings})],
        stdout=subprocess.PIPE,
    )
    try:
        assert process.stdout is not None
        about = json.loads(process.stdout.readline())
        host, _, port = about["witness"].partition(":")
        with RemoteTimeline(host, int(port)) as witness:
            yield RemoteBoard(about["serial"], witness, about["witness"])
    finally:
        process.kill()
        process.wait()
        if process.stdout is not None:
            process.stdout.close()
