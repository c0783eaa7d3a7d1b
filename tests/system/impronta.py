"""Start the program as a person does: a process of its own, its exit code and what it printed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Outcome:
    """How a run of the program ended."""

    code: int
    out: str
    err: str

    def json(self) -> dict[str, object]:
        """The one JSON object on standard output."""
        values = json.loads(self.out)
        assert isinstance(values, dict)
        return values


def command(*words: object) -> list[str]:
    return [sys.executable, "-m", "app", *map(str, words)]


def environment() -> dict[str, str]:
    """Without a display: every subcommand is headless."""
    kept = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
    return kept | {"PYTHONPATH": str(ROOT)}


def impronta(*words: object, cwd: Path | None = None, timeout_s: float = 300) -> Outcome:
    """Run ``impronta`` with these words."""
    done = subprocess.run(command(*words), capture_output=True, text=True, timeout=timeout_s, check=False, cwd=cwd, env=environment())
    return Outcome(done.returncode, done.stdout, done.stderr)


def one_sentence(outcome: Outcome, code: str) -> None:
    """Exit 1 with one line that carries the code, and nothing else."""
    assert outcome.code == 1, outcome
    assert outcome.out == ""
    assert code in outcome.err
    assert "Traceback" not in outcome.err
    assert len(outcome.err.strip().splitlines()) == 1, outcome.err


def balanced(values: dict[str, object]) -> None:
    """planned = measured + rejected + skipped."""
    rejected = values["rejected"]
    assert isinstance(rejected, dict)
    assert values["planned"] == int(str(values["measured"])) + sum(rejected.values()) + int(str(values["skipped"]))
