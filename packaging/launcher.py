"""The two commands behind start.py and check.py, once the Python is new enough."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import environment
import system_libraries
from environment import ROOT, Environment
from progress import SetupError, Steps, say

XVFB_RUN = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24"]
SIDE_BY_SIDE = ["-n", "auto", "--maxprocesses", "4", "--dist", "loadfile", "--no-loadscope-reorder"]
"""For the `ci` tests as a whole: a process a core; soaks and benchmarks, whose figures count, run alone.

Whole files in the order of tests/conftest.py, which begins with the longest; xdist's own begins with those of most tests."""


def start(arguments: Sequence[str]) -> int:
    """Set up, then run ``impronta`` with these arguments; without any, the window or ``impronta demo``."""
    try:
        ready, window_possible = _set_up(frozenset(), programs=[])
    except SetupError as error:
        return _give_up(error)
    except KeyboardInterrupt:
        return _interrupted()
    if list(arguments) == ["--set-up-only"]:
        say(f"Impronta is set up. Its command: {ready.command}")
        return 0
    chosen = list(arguments)
    if not chosen and not (window_possible and system_libraries.display_answers()):
        say("No display here: running the whole job headless (impronta demo).")
        chosen = ["demo"]
    return _become([str(ready.command), *chosen], environment.variables())


def check(arguments: Sequence[str]) -> int:
    """Set up with the extra ``test``, then run ruff, mypy and pytest; with arguments only pytest, unless ``--lint`` is among them."""
    lint = not arguments or "--lint" in arguments
    passed_on = [argument for argument in arguments if argument != "--lint"]
    try:
        ready, window_possible = _set_up(frozenset({"test"}), programs=system_libraries.missing_test_programs())
        screen = _screen(window_possible)
    except SetupError as error:
        return _give_up(error)
    except KeyboardInterrupt:
        return _interrupted()
    python = str(ready.python)
    variables = environment.variables()
    if lint:
        for tool, command in (("ruff", ["-m", "ruff", "check", "."]), ("mypy", ["-m", "mypy"])):
            say(f"{tool}: python {' '.join(command)}")
            code = _run([python, *command], variables, ROOT)
            if code == 130:
                return _interrupted()
            if code != 0:
                say(f"{tool} found the faults above; the tests were not run. Correct them, then run this command again.")
                return 1
    if sys.platform.startswith("linux"):
        variables["QT_QPA_PLATFORM"] = "xcb"  # "offscreen" paints noise where 3D should be
        variables.pop("WAYLAND_DISPLAY", None)
    return _become([*screen, python, "-m", "pytest", *(passed_on or SIDE_BY_SIDE)], variables, ROOT)


def _set_up(extras: frozenset[str], programs: Sequence[str]) -> tuple[Environment, bool]:
    """The finished environment, and whether the libraries for a window are there."""
    if sys.maxsize < 2**32:
        raise SetupError(f"{sys.executable} is 32 bit, and the packages exist for 64 bit only. Install a 64-bit Python and start this with it.")
    found, complete = environment.find(extras)
    libraries = [*system_libraries.missing_libraries(), *programs]
    venv = [] if complete else system_libraries.missing_venv()
    missing = [*venv, *libraries]
    if complete and not missing:
        return found, True
    steps = Steps((1 if missing else 0) + (0 if complete else 2))
    if missing:
        steps.run(f"System packages: {' '.join(missing)}", lambda: _system_packages(missing, venv))
    if not complete:
        with environment.locked(found):
            found, complete = environment.find(extras)  # another run may have finished it meanwhile
            if not complete:
                all_extras = extras | (found.extras() or frozenset())
                steps.run("Python environment", lambda: environment.create(found))
                steps.run("Python packages (about 380 MB to download the first time)", lambda: environment.install(found, all_extras))
    return found, not system_libraries.missing_libraries()


def _system_packages(missing: Sequence[str], venv: Sequence[str]) -> None:
    """Install what is missing or say how; only what the environment itself needs stops the set-up."""
    if system_libraries.can_install():
        try:
            system_libraries.install(missing)
        except SetupError as error:
            if venv:
                raise
            say(f"      {error}\n      Going on without them.")
        if venv and system_libraries.missing_venv():
            raise SetupError(f"{sys.executable} still cannot make environments. Start this command with the system's own Python: /usr/bin/python3")
        return
    command = system_libraries.install_command(missing)
    if venv:
        raise SetupError(f"This Python cannot make environments yet. Nothing was changed. Run this once, then this command again:\n    {command}")
    say(f"      missing, and this user may not install them; once, as administrator:\n          {command}\n      Going on without them.")


def _screen(window_possible: bool) -> list[str]:
    """What to put in front of pytest so that windows can open."""
    if not sys.platform.startswith("linux"):
        return []
    if not window_possible:
        raise SetupError(f"The tests open windows, and libraries for that are missing. Run the command that was named above: {_remedy()}")
    if shutil.which("xvfb-run") and shutil.which("xauth"):
        return XVFB_RUN
    if os.environ.get("DISPLAY") and system_libraries.display_answers():
        say("No virtual display is installed; the windows of the tests will open on this screen.")
        return []
    raise SetupError(f"The tests open windows, and there is no display to open them on. Run this once, then this command again:\n    {_remedy()}")


def _remedy() -> str:
    return system_libraries.install_command([*system_libraries.missing_libraries(), *system_libraries.missing_test_programs()])


def _run(command: Sequence[str], variables: dict[str, str], folder: Path | None = None) -> int:
    child = subprocess.Popen(command, env=variables, cwd=folder)
    while True:
        try:
            code = child.wait()
            break
        except KeyboardInterrupt:
            continue  # Ctrl-C reached the child as well; it stops cleanly and says so
    return code if code >= 0 else 128 - code


def _become(command: Sequence[str], variables: dict[str, str], folder: Path | None = None) -> int:
    """Run a command in the place of this one, so that a signal meant for it reaches it."""
    if sys.platform == "win32":
        return _run(command, variables, folder)
    if folder is not None:
        os.chdir(folder)
    os.execvpe(command[0], list(command), variables)


def _give_up(error: SetupError) -> int:
    say(f"\n{error}")
    return 1


def _interrupted() -> int:
    say("\nInterrupted. Run this command again to go on where it stopped.")
    return 130
