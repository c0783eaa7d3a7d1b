"""The very code of OpenCV for Video4Linux, and the program's, against a model of the kernel's side (``video4linux_kernel.c``)."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import scanner_core

COMPILER = shutil.which("cc")
pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux") or COMPILER is None, reason="needs Linux and a C compiler")


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    root = tmp_path_factory.mktemp("video4linux")
    kernel = root / "kernel.so"
    subprocess.run(
        [str(COMPILER), "-shared", "-fPIC", "-O1", "-o", str(kernel), str(Path(__file__).with_name("video4linux_kernel.c")), "-ldl"], check=True
    )
    (root / "dev/v4l/by-id").mkdir(parents=True)
    (root / "dev/video0").touch()
    (root / "dev/v4l/by-id/usb-Model-video-index0").symlink_to("../../video0")
    (root / "sys/class/video4linux/video0").mkdir(parents=True)
    (root / "sys/class/video4linux/video0/name").write_text("Model camera\n")
    (root / "jpeg").write_bytes(cv2.imencode(".jpg", np.full((240, 320, 3), (0, 0, 200), np.uint8))[1].tobytes())
    environment = {**os.environ, "LD_PRELOAD": str(kernel), "V4L_ROOT": str(root)}
    ended = subprocess.run(
        [sys.executable, "-m", "tests.core.devices.video4linux_session", str(root)],
        env=environment,
        cwd=Path(scanner_core.__file__).parents[1],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert ended.returncode == 0, ended.stderr
    return dict(json.loads(ended.stdout))


def test_it_is_found_by_its_stable_name(told: dict[str, Any]) -> None:
    assert told["found"] == [["usb-Model-video-index0", "Model camera", "READY"]]


@pytest.mark.parametrize(("name", "given", "mean"), [("YUYV", "YUYV", 128), ("MJPG", "MJPG", 60), ("GREY", "GREY", 126), ("H264", "YUYV", 128)])
def test_every_format_gives_luminance_and_is_read_back(told: dict[str, Any], name: str, given: str, mean: float) -> None:
    seen, report = told[name], told[name]["report"]
    assert seen["mean"] == pytest.approx(mean, abs=1.0)
    assert seen["frames"] + seen["dropped"] == 15
    assert seen["frames"] >= 10
    assert 0.0 <= seen["age_s"] < 1.0  # the driver's stamps are on the clock of the program
    assert (report["size_px"], report["rate_hz"], report["pixel_format"]) == ([320, 240], 30.0, given)
    assert (report["exposure_ms"], report["gain_db"]) == (5.0, 3.0)
    assert report["refused"] == ([] if name == given else ["The format 'H264' was refused; the camera gives 'YUYV'."])


@pytest.mark.parametrize("name", ["YUYV", "MJPG", "GREY"])
def test_while_it_is_held_a_second_program_is_told_so(told: dict[str, Any], name: str) -> None:
    assert told[name]["again"] == "E-CAM-05"
    assert told[name]["state"] == ["IN_USE"]


def test_broken_frames_are_gaps(told: dict[str, Any]) -> None:
    whole, dropped = told["broken"]
    assert whole + dropped == 20
    assert 2 <= dropped <= 12


def test_a_stall_is_told_in_time_and_it_goes_on_afterwards(told: dict[str, Any]) -> None:
    code, seconds = told["stall"]
    assert (code, seconds < 5.0) == ("E-CAM-01", True)
    assert told["after the stall"] == [240, 320]


def test_it_is_let_go_although_the_driver_hangs(told: dict[str, Any]) -> None:
    assert told["close"] < 5.0


def test_a_pulled_plug_is_told_at_once(told: dict[str, Any]) -> None:
    code, seconds = told["pulled"]
    assert (code, seconds < 5.0) == ("E-CAM-02", True)
