"""The project's own Python environment: made once, found again at once, repaired when it was interrupted.

A stamp inside says for which pins and for which extras the environment is complete. It is written last, so an
environment without it is unfinished, and a run that finds it costs next to nothing.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from package_index import explain
from progress import SetupError, last_lines, run_and_follow, say

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("scanner_core", "app", "resources")
CONSTRAINTS = ROOT / "packaging" / "constraints.txt"
NEEDED_MB = 2000  # 1.4 GB stay; the rest is what is being downloaded and unpacked


@dataclass(frozen=True, slots=True)
class Environment:
    """A virtual environment of this checkout.

    Parameters
    ----------
    folder
        Where it stands; need not exist yet.
    """

    folder: Path

    @property
    def python(self) -> Path:
        """Its interpreter."""
        return self.folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")

    @property
    def command(self) -> Path:
        """The command ``impronta`` inside."""
        return self.folder / ("Scripts/impronta.exe" if sys.platform == "win32" else "bin/impronta")

    @property
    def stamp(self) -> Path:
        """Says what the environment is complete for."""
        return self.folder / "impronta-ready.json"

    @property
    def unpacking(self) -> Path:
        """Stands there while packages are being written; found later, it tells that this was interrupted."""
        return self.folder / "impronta-unpacking"

    @property
    def log(self) -> Path:
        """Everything that the installation said."""
        return self.folder / "impronta-setup.log"

    def extras(self) -> frozenset[str] | None:
        """The extras it is complete with, or None when it is absent, unfinished or for other pins."""
        try:
            stamp = json.loads(self.stamp.read_text(encoding="utf-8"))
            complete = stamp["digest"] == digest(self.folder) and self.python.exists() and self.command.exists()
            return frozenset(stamp["extras"]) if complete else None
        except (OSError, ValueError, KeyError, TypeError):
            return None


def find(extras: frozenset[str]) -> tuple[Environment, bool]:
    """The environment to use, and whether it is complete for ``extras``."""
    candidates = [Environment(ROOT / ".venv"), Environment(_user_folder())]
    for candidate in candidates:
        installed = candidate.extras()
        if installed is not None and extras <= installed:
            return candidate, True
    in_checkout = candidates[0].folder
    return (candidates[0] if _writable(in_checkout) else candidates[1]), False


def create(environment: Environment) -> None:
    """Make the bare environment, or leave one that works; an interrupted one is made anew.

    Raises
    ------
    SetupError
        When the disk is full or Python cannot make environments.
    """
    folder = environment.folder
    if environment.python.exists() and not environment.unpacking.exists() and _pip_works(environment):
        say(f"      found in {folder}")
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SetupError(_storage_sentence(folder, error)) from error
    free_mb = shutil.disk_usage(folder).free // 1_000_000
    if free_mb < NEEDED_MB:
        raise SetupError(
            f"{folder} has {free_mb} MB left and the environment needs {NEEDED_MB} MB while it is being set up. "
            "Nothing was changed. Make room, then run this command again."
        )
    if (folder / "pyvenv.cfg").exists():
        say("      an earlier run was interrupted; making it anew")
    say(f"      in {folder}")
    code, lines = run_and_follow([sys.executable, "-I", "-m", "venv", "--clear", str(folder)], show=lambda line: None, environment=_clean_variables())
    if code != 0:
        if "No space left" in "\n".join(lines):
            raise SetupError(_storage_sentence(folder, OSError(errno.ENOSPC, "No space left on device")))
        raise SetupError(
            f"{sys.executable} could not make an environment in {folder}. Solve what it says, then run this command again:\n{last_lines(lines)}"
        )


def install(environment: Environment, extras: frozenset[str]) -> None:
    """Install the pinned packages and the project itself, and write the stamp.

    Raises
    ------
    SetupError
        With the reason and the remedy.
    """
    environment.stamp.unlink(missing_ok=True)
    wanted = ",".join(sorted(extras))
    _pip(environment, ["-c", str(CONSTRAINTS), "setuptools"])
    with _installable() as source:
        project = f"{source}[{wanted}]" if wanted else str(source)
        _pip(environment, ["--no-build-isolation", "-c", str(CONSTRAINTS), *(["-e"] if source == ROOT else []), project])
    stamp = {"digest": digest(environment.folder), "extras": sorted(extras)}
    try:
        beside = environment.stamp.with_suffix(".new")
        beside.write_text(json.dumps(stamp), encoding="utf-8")
        beside.replace(environment.stamp)
    except OSError as error:
        raise SetupError(_storage_sentence(environment.folder, error)) from error


def digest(folder: Path) -> str:
    """What an environment depends on: the pins, the interpreter, both places, and the sources where they were copied."""
    parts = [(ROOT / "pyproject.toml").read_bytes(), CONSTRAINTS.read_bytes()]
    parts += [text.encode() for text in (sys.version, str(ROOT), str(folder))]
    if not _writable(ROOT):
        files = sorted(path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.suffix != ".pyc" and path.is_file())
        parts += [f"{path} {path.stat().st_mtime_ns} {path.stat().st_size}".encode() for path in files]
    return hashlib.sha256(b"\0".join(parts)).hexdigest()


def variables() -> dict[str, str]:
    """The variables for a program of the environment: nothing of another Python's packages leaks in."""
    return {name: value for name, value in os.environ.items() if name not in ("PYTHONHOME", "PYTHONPATH", "__PYVENV_LAUNCHER__")}


@contextmanager
def locked(environment: Environment) -> Iterator[None]:
    """Only one set-up at a time; a second one waits for the first, also when that one is killed."""
    name = hashlib.sha256(str(environment.folder).encode()).hexdigest()[:16]
    user = 0 if sys.platform == "win32" else os.getuid()
    path = Path(tempfile.gettempdir()) / f"impronta-setup-{user}-{name}.lock"
    try:
        lock = path.open("a+b")
    except OSError as error:
        raise SetupError(_storage_sentence(path, error)) from error
    with lock:
        waiting = False
        while not _taken(lock):
            if not waiting:
                say("Another set-up of this checkout is running; waiting for it.")
            waiting = True
            time.sleep(0.2)
        yield


def _taken(lock: BinaryIO) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            lock.seek(0)
            msvcrt.locking(lock.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


def _pip(environment: Environment, arguments: list[str]) -> None:
    def show(line: str) -> str | None:
        if line.startswith("Installing collected packages"):
            environment.unpacking.touch()
            return "unpacking; this takes a minute"
        if "WARNING: Retrying" in line:
            return "the package index does not answer; trying again"
        return line.strip() if line.lstrip().startswith("Downloading ") and not line.endswith(".metadata") and ".metadata (" not in line else None

    command = [
        str(environment.python),
        "-I",
        "-m",
        "pip",
        "install",
        "--disable-pip-version-check",
        "--no-input",
        "--progress-bar",
        "off",
        *arguments,
    ]
    try:
        code, lines = run_and_follow(command, show=show, environment=_clean_variables())
        with environment.log.open("a", encoding="utf-8") as log:
            log.write("\n".join([" ".join(command), *lines, f"exit {code}", ""]))
        if code == 0:
            environment.unpacking.unlink(missing_ok=True)
            return
    except OSError as error:
        raise SetupError(_storage_sentence(environment.folder, error)) from error
    raise SetupError(explain(lines, environment.folder, environment.log))


@contextmanager
def _installable() -> Iterator[Path]:
    """The checkout, installed in place; when it cannot be written to, a copy of what is installed from it."""
    if _writable(ROOT):
        yield ROOT
        return
    with tempfile.TemporaryDirectory(prefix="impronta-source-") as name:
        copy = Path(name) / "impronta"
        for package in PACKAGES:
            shutil.copytree(ROOT / package, copy / package, ignore=shutil.ignore_patterns("__pycache__"))
        for file in ("pyproject.toml", "README.md", "LICENSE"):
            shutil.copy(ROOT / file, copy / file)
        yield copy


def _pip_works(environment: Environment) -> bool:
    command = [str(environment.python), "-I", "-c", "import pip, sys; print(*sys.version_info[:2])"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, timeout=60, env=_clean_variables(), check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return answer.returncode == 0 and answer.stdout.split() == [str(part) for part in sys.version_info[:2]]


def _clean_variables() -> dict[str, str]:
    # A pip that was told to install elsewhere (user = true, target = ...) would refuse or miss the environment.
    left_out = ("PIP_TARGET", "PIP_PREFIX", "PIP_ROOT", "PIP_REQUIRE_VIRTUALENV", "PIP_CONSTRAINT")
    return {**{name: value for name, value in variables().items() if name not in left_out}, "PIP_USER": "0", "PYTHONUTF8": "1"}


def _writable(folder: Path) -> bool:
    nearest = folder if folder.exists() else folder.parent
    return os.access(nearest, os.W_OK)


def _user_folder() -> Path:
    name = f"environment-{hashlib.sha256(str(ROOT).encode()).hexdigest()[:12]}"
    try:
        home = Path.home()
    except RuntimeError:  # a service account: neither HOME nor an entry in the password file
        return Path(tempfile.gettempdir()) / "impronta" / name
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local") / "Impronta" / name
    if sys.platform == "darwin":
        return home / "Library" / "Application Support" / "Impronta" / name
    return Path(os.environ.get("XDG_DATA_HOME") or home / ".local" / "share") / "impronta" / name


def _storage_sentence(folder: Path, error: OSError) -> str:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return f"The disk that holds {folder} is full. Nothing else was changed. Make room, then run this command again."
    return f"{folder} cannot be written: {error.strerror}. Give this user the right to write there, then run this command again."
