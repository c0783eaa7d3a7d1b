"""Jobs for the tests; they run in the worker process."""

from __future__ import annotations

import os
import resource
import signal
import sys
import time

import numpy as np

from scanner_core.errors import ReconstructionError
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Cancelled, IsCancelled, IsEnough, OnProgress, Progress

_MODULE = __name__


def targets() -> dict[str, str]:
    """For the registry."""
    names = "content add patient deaf die refuse stumble leave previews environment unpicklable hoard echo resident_mb"
    return {name: f"{_MODULE}:{name}" for name in names.split()}


def add(request: tuple[float, float], *, progress: OnProgress, cancelled: IsCancelled) -> float:
    progress(Progress("add", 1.0))
    return request[0] + request[1]


def echo(request: object, *, progress: OnProgress, cancelled: IsCancelled) -> object:
    return request


def patient(request: float, *, progress: OnProgress, cancelled: IsCancelled) -> str:
    """Works for `request` seconds and listens."""
    progress(Progress("patience", 0.1))
    end = time.monotonic() + request
    while time.monotonic() < end:
        if cancelled():
            raise Cancelled
        time.sleep(0.01)
    return "done"


def content(request: float, *, progress: OnProgress, cancelled: IsCancelled, enough: IsEnough) -> str:
    """Works for `request` seconds, listens, and ends with half a result for a caller who is content with it."""
    progress(Progress("patience", 0.1))
    end = time.monotonic() + request
    while time.monotonic() < end:
        if cancelled():
            raise Cancelled
        if enough():
            return "half"
        time.sleep(0.01)
    return "whole"


def deaf(request: float, *, progress: OnProgress, cancelled: IsCancelled) -> str:
    """Works and does not listen."""
    progress(Progress("deaf", 0.5))
    time.sleep(request)
    return "done"


def die(request: int, *, progress: OnProgress, cancelled: IsCancelled) -> None:
    progress(Progress("dying", 0.2))
    if request < 0:
        os._exit(-request)
    os.kill(os.getpid(), request)
    signal.pause()


def refuse(request: int, *, progress: OnProgress, cancelled: IsCancelled) -> None:
    raise ReconstructionError("E-REC-01", details="few", points=request, least=100)


def stumble(request: str, *, progress: OnProgress, cancelled: IsCancelled) -> None:
    raise {"value": ValueError("no such value"), "end": EOFError("mine"), "memory": MemoryError(), "pipe": BrokenPipeError("mine")}[request]


def leave(request: int, *, progress: OnProgress, cancelled: IsCancelled) -> None:
    sys.exit(request)


def previews(request: float, *, progress: OnProgress, cancelled: IsCancelled) -> int:
    """Sends previews as fast as it can for `request` seconds."""
    mesh = TriangleMesh(np.eye(3), np.array([[0, 1, 2]]))
    end, count = time.monotonic() + request, 0
    while time.monotonic() < end:
        count += 1
        progress(Progress("inflate", 0.5, None, mesh))
    return count


def environment(request: None, *, progress: OnProgress, cancelled: IsCancelled) -> dict[str, object]:
    print("noise of a library on standard output")
    return {
        "blas": {name: os.environ.get(name) for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")},
        "interrupt": signal.getsignal(signal.SIGINT) == signal.SIG_IGN,
        "pid": os.getpid(),
        "threads": len(os.listdir("/proc/self/task")) if os.path.isdir("/proc/self/task") else None,
    }


def unpicklable(request: None, *, progress: OnProgress, cancelled: IsCancelled) -> object:
    return lambda: None


def hoard(request: int, *, progress: OnProgress, cancelled: IsCancelled) -> tuple[float, list[object]]:
    """Uses `request` MB, in a cycle that only the garbage collector frees."""
    block = np.ones(request * 131072)
    cycle: list[object] = [block]
    cycle.append(cycle)
    return float(block.sum()), []


def resident_mb(request: None, *, progress: OnProgress, cancelled: IsCancelled) -> float:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20
