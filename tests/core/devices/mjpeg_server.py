"""A camera that is a stream: pictures as JPEG over HTTP, as network cameras and telephones send them, from a thread of the test.

It is real input for the FFmpeg in OpenCV, and can misbehave: stall, cut its connections, send something else than JPEG.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Self

import cv2
import numpy as np
from numpy.typing import NDArray

_BOUNDARY = "frame"
_POLL_S = 0.02

Picture = Callable[[int], NDArray[np.uint8]]
"""Frame number (from 0, one more every period since the server's start) to a picture, (H, W) or (H, W, 3) BGR."""


class MjpegServer:
    """Serves ``picture(k)`` at ``start + k / rate_hz`` to everyone who asks for `url`.  A context manager.

    Attributes
    ----------
    stalled : while it is set connections stay open and nothing is sent
    cut : while it is set connections are closed and new ones refused
    garbage : while it is set frames are no JPEG
    starved : while it is set only every second frame is sent
    """

    def __init__(self, picture: Picture, rate_hz: float = 30.0, quality: int = 95, start_s: float | None = None) -> None:
        """`start_s` on ``time.monotonic``, also in the past; now when None."""
        self._picture, self._rate_hz, self._quality = picture, rate_hz, quality
        self.stalled, self.cut, self.garbage, self.starved = (threading.Event() for _ in range(4))
        self._closing = threading.Event()
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), self._handler())
        self._server.daemon_threads = False
        self._start_s = time.monotonic() if start_s is None else start_s
        self._thread = threading.Thread(target=self._server.serve_forever, args=(_POLL_S,), name="mjpeg-server")
        self._thread.start()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self._server.server_address[1]}/stream.mjpg"

    def close(self) -> None:
        """End every connection and every thread."""
        self._closing.set()
        self._server.shutdown()
        self._server.server_close()  # joins the threads of the connections
        self._thread.join()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _handler(self) -> type[BaseHTTPRequestHandler]:
        server = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                if server.cut.is_set():
                    self.send_error(503)
                    return
                self.send_response(200)
                self.send_header("Content-Type", f"multipart/x-mixed-replace; boundary={_BOUNDARY}")
                self.end_headers()
                with contextlib.suppress(ConnectionError, TimeoutError):  # the reader may go at any time
                    server._stream(self.wfile.write)

            def log_message(self, format: str, *args: object) -> None:
                pass

        return Handler

    def _stream(self, write: Callable[[bytes], object]) -> None:
        number = int((time.monotonic() - self._start_s) * self._rate_hz)
        while not (self._closing.is_set() or self.cut.is_set()):
            number += 2 if self.starved.is_set() else 1
            wait_s = self._start_s + number / self._rate_hz - time.monotonic()
            if wait_s > 0 and self._closing.wait(wait_s):
                return
            if self.stalled.is_set():
                continue
            body = b"no picture" * 100 if self.garbage.is_set() else self._jpeg(number)
            write(b"--%s\r\nContent-Type: image/jpeg\r\nContent-Length: %d\r\n\r\n" % (_BOUNDARY.encode(), len(body)) + body + b"\r\n")

    def _jpeg(self, number: int) -> bytes:
        ok, coded = cv2.imencode(".jpg", self._picture(number), [cv2.IMWRITE_JPEG_QUALITY, self._quality])
        assert ok
        return coded.tobytes()
