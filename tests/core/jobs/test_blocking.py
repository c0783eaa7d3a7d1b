"""A job for the command line: waited for, cancelled within a second, nothing left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from scanner_core.errors import ReconstructionError, WorkerLostError
from scanner_core.jobs import registry
from scanner_core.jobs.blocking import run_in_worker
from scanner_core.jobs.progress import Cancelled, Progress
from tests.core.jobs import tiny_jobs


@pytest.fixture(autouse=True)
def _tiny_jobs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "JOBS", tiny_jobs.targets())


def test_result_and_progress_come_in_the_calling_thread() -> None:
    told: list[tuple[Progress, threading.Thread]] = []
    result = run_in_worker("add", (1, 2), progress=lambda p: told.append((p, threading.current_thread())), cancelled=lambda: False)
    assert result == 3
    assert [(p.phase, thread) for p, thread in told] == [("add", threading.current_thread())]


@pytest.mark.parametrize("job", ["patient", "deaf"])
def test_a_cancel_is_raised_whether_the_job_listens_or_not(job: str) -> None:
    begun = threading.Event()
    with pytest.raises(Cancelled):
        run_in_worker(job, 60.0, progress=lambda p: begun.set(), cancelled=begun.is_set)


def test_errors_and_deaths_are_raised() -> None:
    with pytest.raises(ReconstructionError, match="E-REC-01"):
        run_in_worker("refuse", 3, progress=lambda p: None, cancelled=lambda: False)
    with pytest.raises(WorkerLostError, match="killed by signal 9"):
        run_in_worker("die", 9, progress=lambda p: None, cancelled=lambda: False)


def test_an_interrupt_leaves_no_process_behind() -> None:
    def interrupt(progress: Progress) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_in_worker("deaf", 60.0, progress=interrupt, cancelled=lambda: False)


COMMAND = """
import sys
from scanner_core.jobs import registry
from scanner_core.jobs.blocking import run_in_worker

def main():
    registry.JOBS.clear()
    registry.JOBS["deaf"] = "tests.core.jobs.tiny_jobs:deaf"
    try:
        run_in_worker("deaf", 600.0, progress=lambda told: say("progress"), cancelled=lambda: say("start") and False)
    except KeyboardInterrupt:
        sys.exit(130)

said = set()
def say(what):
    if what not in said:
        said.add(what)
        print(what, flush=True)
    return True

if __name__ == "__main__":
    main()
"""


@pytest.mark.skipif(os.name != "posix", reason="process groups")
@pytest.mark.parametrize("when", ["start", "progress"])
def test_ctrl_c_in_the_terminal_ends_quietly(tmp_path: Path, when: str) -> None:
    """Ctrl-C reaches every process of the terminal, also a child that is still importing."""
    script = tmp_path / "command.py"
    script.write_text(COMMAND, encoding="utf-8")
    root = Path(__file__).parents[3]
    with subprocess.Popen(
        [sys.executable, str(script)],
        cwd=root,
        env={**os.environ, "PYTHONPATH": str(root)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as command:
        assert command.stdout is not None
        for line in command.stdout:
            if line.strip() == when:
                break
        os.killpg(command.pid, signal.SIGINT)
        _, noise = command.communicate(timeout=60)
    assert command.returncode == 130
    assert noise == ""
