"""Runs a reader on inputs and writes down what must not happen: crashes, hangs, memory without bound."""

from __future__ import annotations

import hashlib
import json
import resource
import signal
import time
import traceback
from dataclasses import asdict, dataclass, field
from pathlib import Path
from types import FrameType

import psutil

from tests.fuzz.corpus import samples
from tests.fuzz.readers import READERS, REFUSALS

MOST_SECONDS = 5.0
"""For one input."""
MOST_MEMORY = 1 << 30
"""Bytes of address space beyond what the process has at the start: an allocation that would exceed it fails, which is a finding."""


class HangError(Exception):
    """An input took longer than :data:`MOST_SECONDS`."""


@dataclass
class Summary:
    """What came of a run; findings by where they happened."""

    reader: str
    inputs: int = 0
    accepted: int = 0
    refused: int = 0
    slowest_s: float = 0.0
    seconds: float = 0.0
    memory_growth_mb: float = 0.0
    findings: dict[str, str] = field(default_factory=dict)


class Watch:
    """Calls one reader; never raises."""

    def __init__(self, reader: str, folder: Path) -> None:
        """Inputs that made a finding, and the summary, are written to `folder`."""
        self._read = READERS[reader]
        self._folder = folder
        self.summary = Summary(reader)
        self._begin_s = time.perf_counter()
        for sample in (b"", *samples(reader)):  # imports and caches are no growth
            self._outcome(sample)
        process = psutil.Process()
        self._memory = process.memory_info().rss
        most = process.memory_info().vms + MOST_MEMORY
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
        signal.signal(signal.SIGALRM, self._hangs)

    def __call__(self, content: bytes) -> None:
        begin_s = time.perf_counter()
        signal.setitimer(signal.ITIMER_REAL, MOST_SECONDS)
        outcome = self._outcome(content)
        signal.setitimer(signal.ITIMER_REAL, 0)
        took_s = time.perf_counter() - begin_s
        if outcome == "" and took_s > MOST_SECONDS:
            outcome = "hang in native code"
        said = self.summary
        said.inputs += 1
        if took_s > said.slowest_s:
            said.slowest_s = round(took_s, 4)
        if outcome not in ("", "refused") and outcome not in said.findings:
            name = f"{said.reader}-{hashlib.sha256(content).hexdigest()[:12]}"
            (self._folder / name).write_bytes(content)
            said.findings[outcome] = name
            self.write()
        said.accepted += outcome == ""
        said.refused += outcome == "refused"
        if said.inputs % 1000 == 0:
            self.write()

    def write(self) -> None:
        """The summary so far, to a file: a fuzzer may end the process without a word."""
        self.summary.seconds = round(time.perf_counter() - self._begin_s, 1)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
        self.summary.memory_growth_mb = round(max(0, peak - self._memory) / 1e6, 1)
        (self._folder / "summary.json").write_text(json.dumps(asdict(self.summary)))

    def _outcome(self, content: bytes) -> str:
        """Nothing for a value, ``refused``, or what went wrong and where."""
        try:
            self._read(content)
            return ""
        except REFUSALS as refusal:
            return "refused" if str(refusal).isprintable() else f"unprintable sentence of {type(refusal).__name__}"
        except Exception as fault:
            places = [frame for frame in traceback.extract_tb(fault.__traceback__) if "scanner_core" in frame.filename]
            place = f"{Path(places[-1].filename).name}:{places[-1].lineno}" if places else "?"
            return f"hang at {place}" if isinstance(fault, HangError) else f"{type(fault).__name__} at {place}"

    @staticmethod
    def _hangs(_number: int, _frame: FrameType | None) -> None:
        raise HangError
