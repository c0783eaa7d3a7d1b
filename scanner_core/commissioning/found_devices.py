"""Which ports and cameras this machine has: everything is asked, side by side, and what answered is listed.

Nothing is moved and no laser is lit; a board may restart when its port is opened, so it is done when a person asks for it.
"""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from scanner_core.clock import Clock
from scanner_core.devices.camera_drivers import find_cameras
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort, ask_ports, serial_ports
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress

_POLL_S = 0.1
_PORT_S = 5.0
"""About what the slowest port takes; for the progress alone."""


@dataclass(frozen=True, slots=True, eq=False)
class FoundDevices:
    """Every port and every camera with what became of it, each in the order of its name, streams as they were given."""

    ports: tuple[PortAnswer, ...]
    cameras: tuple[FoundCamera, ...]

    def controller(self) -> PortAnswer | None:
        """The controller, where there is exactly one that the rig can use."""
        usable = [answer for answer in self.ports if answer.state is PortState.CONTROLLER]
        return usable[0] if len(usable) == 1 else None

    def usable_cameras(self) -> tuple[FoundCamera, ...]:
        """Those that deliver frames."""
        return tuple(camera for camera in self.cameras if camera.state is CameraState.READY)


def find_devices(
    clock: Clock,
    *,
    progress: OnProgress,
    cancelled: IsCancelled,
    on_port: Callable[[PortAnswer], None] = lambda answer: None,
    on_camera: Callable[[FoundCamera], None] = lambda camera: None,
    ports: Sequence[SerialPort] | None = None,
    streams: Sequence[str] = (),
) -> FoundDevices:
    """Ask every port and look at every camera, side by side.

    Parameters
    ----------
    clock : real time
    progress : also tells what is waited for
    on_port, on_camera : called in this thread as soon as an answer is there
    ports : to ask; None = those that the system lists
    streams : network cameras to look at, by their URLs, instead of the cameras of this machine; the first two are left and right

    Raises
    ------
    Cancelled
        Within 0.5 s; what was asked goes on to its own deadline and is then released.
    """
    asked = serial_ports() if ports is None else list(ports)
    news: queue.SimpleQueue[PortAnswer | list[FoundCamera] | BaseException] = queue.SimpleQueue()
    jobs: list[tuple[str, Callable[[], PortAnswer | list[FoundCamera]]]] = [(f"ask-{port.url}", partial(_ask, port, clock)) for port in asked]
    jobs.append(("find-cameras", partial(find_cameras, streams) if streams else find_cameras))
    threads = [threading.Thread(target=_tell, args=(job, news), name=name) for name, job in jobs]
    for thread in threads:
        thread.start()
    answers: list[PortAnswer] = []
    cameras: list[FoundCamera] = []
    began_s, waiting = time.monotonic(), len(threads)
    while waiting:
        if cancelled():
            raise Cancelled
        progress(Progress("find", min(0.99, max(1 - waiting / len(threads), (time.monotonic() - began_s) / _PORT_S))))
        try:
            told = news.get(timeout=_POLL_S)
        except queue.Empty:
            continue
        waiting -= 1
        if isinstance(told, BaseException):
            _join(threads)
            raise told
        if isinstance(told, PortAnswer):
            answers.append(told)
            on_port(told)
        else:
            cameras = told if streams else sorted(told, key=lambda camera: (camera.driver, camera.id))
            for camera in cameras:
                on_camera(camera)
    _join(threads)
    progress(Progress("find", 1.0))
    return FoundDevices(tuple(sorted(answers, key=lambda answer: answer.port.url)), tuple(cameras))


def _ask(port: SerialPort, clock: Clock) -> PortAnswer:
    return ask_ports([port], clock)[0]


def _tell(job: Callable[[], PortAnswer | list[FoundCamera]], news: queue.SimpleQueue[PortAnswer | list[FoundCamera] | BaseException]) -> None:
    try:
        news.put(job())
    except BaseException as fault:  # an unexpected fault belongs to who asked, not to this thread
        news.put(fault)


def _join(threads: list[threading.Thread]) -> None:
    for thread in threads:
        thread.join()
