from __future__ import annotations

import cv2
import numpy as np

from tests.core.devices.mjpeg_server import MjpegServer


def test_opencv_reads_its_stream() -> None:
    with MjpegServer(lambda number: np.full((48, 64), 100, np.uint8)) as server:
        capture = cv2.VideoCapture(server.url, cv2.CAP_FFMPEG, [cv2.CAP_PROP_OPEN_TIMEOUT_MSEC, 5000])
        try:
            taken, image = capture.read()
        finally:
            capture.release()
    assert taken
    assert image.shape == (48, 64, 3)
    assert abs(int(image.mean()) - 100) <= 1
