"""Writes the frames of one camera into a folder, in a thread of its own.

A frame of 604 x 294 pixels takes 2 ms as PNG (Huffman coding alone, no filter: a third of its size, and both faster and smaller
than FFV1 video), one of 1440 x 1080 takes 30 ms: more than a capture thread has.  The writer therefore stands behind a
bounded queue.  In simulated time a full queue is waited for, since time holds still meanwhile.  In real time nobody waits: when the
queue is half full images are written as PGM, which costs the processor nothing, and when it is full the recording has failed.
"""

from __future__ import annotations

import errno
import json
import queue
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.devices.recording import INDEX
from scanner_core.errors import DeviceError
from scanner_core.one_line import one_line

QUEUE_BYTES = 256 << 20
_PATIENCE_S = 4.0
"""How long a full queue is waited for in simulated time: less than a scan waits for a silent camera."""
_PNG = [cv2.IMWRITE_PNG_COMPRESSION, 1, cv2.IMWRITE_PNG_STRATEGY, cv2.IMWRITE_PNG_STRATEGY_HUFFMAN_ONLY]
if hasattr(cv2, "IMWRITE_PNG_FILTER"):  # since OpenCV 4.12; before, the image is a tenth larger
    _PNG += [cv2.IMWRITE_PNG_FILTER, cv2.IMWRITE_PNG_FILTER_NONE]

_Item = tuple[NDArray[np.uint8] | None, dict[str, object]]


class FrameWriter:
    """Frames and lines of the index, written in the order in which they come.

    Parameters
    ----------
    folder : is made; must not hold anything
    camera : its name, for sentences
    frame_bytes : of one frame
    hurry : in real time, where nobody may wait for the disk

    Raises
    ------
    DeviceError
        E-CAM-22: of every method, as soon as something could not be written; nothing more is then.
    """

    def __init__(self, folder: Path, camera: str, frame_bytes: int, *, hurry: bool) -> None:
        self.folder, self._camera, self._hurry = folder, camera, hurry
        self.frames = self.bytes = 0
        """What has been written so far."""
        self._fault: DeviceError | None = None
        self._broken = False
        self._queue: queue.Queue[_Item | None] = queue.Queue(max(16, QUEUE_BYTES // max(1, frame_bytes)))
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._index = (folder / INDEX).open("xb", buffering=0)
        except OSError as fault:
            raise self._failed(fault) from fault
        self._thread = threading.Thread(target=self._run, name=f"record-{camera}")
        self._thread.start()

    def write(self, line: Mapping[str, object], image: NDArray[np.uint8] | None = None) -> None:
        """Add a line to the index; with an image (H, W) it gets its name as ``file`` and its ``size_px``."""
        end_s = time.monotonic() + (0.0 if self._hurry else _PATIENCE_S)
        while True:
            if self._fault is not None:
                raise self._fault
            try:
                self._queue.put((image, dict(line)), timeout=max(0.0, min(0.1, end_s - time.monotonic())))
                return
            except queue.Full:
                if time.monotonic() >= end_s:
                    self._fault = self._refused("frames come faster than they can be written")

    def close(self) -> None:
        """Write what is waiting and end; may be called again."""
        if self._thread.is_alive():
            self._queue.put(None)
            self._thread.join()
        if self._fault is not None:
            raise self._fault

    # ------------------------------------------------------------------------------------------ the writer's thread
    def _run(self) -> None:
        cv2.setNumThreads(1)
        with self._index:
            while (item := self._queue.get()) is not None:
                if self._broken:
                    continue  # the queue is emptied all the same: nobody must wait for room in it
                try:
                    self._keep(*item)
                except Exception as fault:  # also what nobody expected must be told
                    self._broken = True
                    self._fault = self._failed(fault) if isinstance(fault, OSError) else self._refused(one_line(fault))

    def _keep(self, image: NDArray[np.uint8] | None, line: dict[str, object]) -> None:
        if image is not None:
            suffix = ".pgm" if self._hurry and 2 * self._queue.qsize() > self._queue.maxsize else ".png"
            path = self.folder / f"{self.frames + 1:07d}{suffix}"
            try:
                self.bytes += path.write_bytes(cv2.imencode(suffix, image, _PNG if suffix == ".png" else [])[1].tobytes())
            except OSError:
                with suppress(OSError):
                    path.unlink()
                raise
            self.frames += 1
            line |= {"file": path.name, "size_px": [image.shape[1], image.shape[0]]}
        text = json.dumps(line).encode() + b"\n"
        if self._index.write(text) != len(text):
            raise OSError(errno.ENOSPC, "")
        self.bytes += len(text)

    # ------------------------------------------------------------------------------------------ faults
    def _failed(self, fault: OSError) -> DeviceError:
        full = fault.errno in (errno.ENOSPC, errno.EDQUOT)
        there = isinstance(fault, FileExistsError)
        return self._refused("the disk is full" if full else "it holds a recording" if there else fault.strerror or one_line(fault))

    def _refused(self, reason: str) -> DeviceError:
        return DeviceError("E-CAM-22", camera=self._camera, path=self.folder, reason=reason)
