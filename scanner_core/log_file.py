"""The program's log: five files of at most 1 MB in the user's state folder, of the window and of every command alike.

It holds warnings and faults with their code, details and traceback, and the few events that tell what was going on: the
start with its versions, a rig that was opened, a scan with its end and counts.  Orders, patients and the names of their files
are taken out before a line is written (:mod:`scanner_core.support.redaction`); :func:`keep_out` says what they are.

Every line is one append by one call, and no file stays open: several programs write the same log, and any of them may
rotate it, on Windows too.  A folder that cannot be written is said once on standard error, and the program goes on.
"""

from __future__ import annotations

import errno
import logging
import os
import platform
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from scanner_core import __version__
from scanner_core.errors import ImprontaError
from scanner_core.support.private_names import PrivateName, file_names
from scanner_core.support.redaction import Redactor
from scanner_core.user_folders import log_folder

NAME = "impronta.log"
FILES = 5
MOST_BYTES = 1_000_000
"""Of one file."""
LIBRARIES = ("numpy", "scipy", "opencv-contrib-python-headless", "vtk", "pyserial", "pyvista", "pyvistaqt", "PySide6_Essentials", "pypylon")

_PATH_FIELDS = ("path", "case", "before", "after", "name")
"""Fields of an error's sentence that name a file of the user's own."""
_MOST_NAMES = 500
_log = logging.getLogger("impronta")
_names: dict[PrivateName, None] = {}
_sources: list[Callable[[], Iterable[PrivateName]]] = []
_names_lock = threading.Lock()


def log_files(folder: Path) -> list[Path]:
    """The files that are there, the newest first."""
    return [path for path in _generations(folder) if path.is_file()]


def keep_out(names: Iterable[PrivateName]) -> None:
    """What must not stand in any line from now on."""
    with _names_lock:
        for name in names:
            _names.pop(name, None)
            _names[name] = None
        for oldest in list(_names)[: max(0, len(_names) - _MOST_NAMES)]:
            del _names[oldest]


def keep_out_now(names: Callable[[], Iterable[PrivateName]]) -> Callable[[], None]:
    """What must not stand in a line is asked for at every line, in the thread that writes it, until what is returned is called."""
    with _names_lock:
        _sources.append(names)

    def forget() -> None:
        with _names_lock, suppress(ValueError):
            _sources.remove(names)

    return forget


@contextmanager
def logging_to_file(what: str, names: Iterable[PrivateName] = (), folder: Path | None = None) -> Iterator[None]:
    """Write the log while the body runs; that `what` was started is its first line.

    Parameters
    ----------
    names : what must not stand in it, as :func:`keep_out`
    folder : default :func:`log_folder`
    """
    keep_out(names)
    root = logging.getLogger()
    handler: logging.Handler
    try:
        handler = LogFile(folder or log_folder())
    except (OSError, RuntimeError) as fault:
        print(f"There will be no log: {fault}. Everything else works.", file=sys.stderr)
        handler = logging.NullHandler()
    screen = logging.StreamHandler()
    screen.setLevel(logging.WARNING)
    screen.addFilter(lambda record: not getattr(record, "told", False))
    screen.setFormatter(logging.Formatter("%(asctime)s %(name)s %(levelname)s %(message)s"))
    handlers = [handler] if root.handlers else [handler, screen]
    level = _log.level
    _log.setLevel(logging.INFO)
    for each in handlers:
        root.addHandler(each)
    _log.info("start: %s", what)
    try:
        yield
    finally:
        _log.info("end: %s", what)
        for each in handlers:
            root.removeHandler(each)
            each.close()
        _log.setLevel(level)


def log_versions() -> None:
    """One line; to find them takes some hundredths of a second."""
    _log.info("versions: %s", ", ".join(f"{name} {version}" for name, version in versions().items()))


def log_fault(fault: BaseException, where: str) -> None:
    """A fault that a person is told elsewhere: code, details and traceback, in the file only."""
    code, details = (fault.code, fault.details) if isinstance(fault, ImprontaError) else (type(fault).__name__, "")
    _log.error("%s: %s%s", where, f"{code} {fault}", f"\ndetails: {details}" if details else "", exc_info=fault, extra={"told": True})


def versions() -> dict[str, str]:
    """Program, Python, system and the libraries that are installed."""
    from importlib import metadata

    found = {"impronta": __version__, "Python": platform.python_version(), "system": f"{platform.system()} {platform.release()} {platform.machine()}"}
    for name in LIBRARIES:
        with suppress(metadata.PackageNotFoundError):
            found[name] = metadata.version(name)
    return found


_FULL = (errno.ENOSPC, errno.EFBIG, getattr(errno, "EDQUOT", errno.ENOSPC))
"""A full disk: whoever writes what was measured says so, and one sentence is enough."""


class LogFile(logging.Handler):
    """Appends to :data:`NAME` in a folder; OSError when nothing can be written there."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder, self._path = folder, folder / NAME
        self._redactor = Redactor()
        self._names: list[PrivateName] = []
        self._failed = False
        self.setFormatter(logging.Formatter("%(asctime)s [%(process)d %(threadName)s] %(levelname)s %(message)s"))
        folder.mkdir(parents=True, exist_ok=True)
        with self._path.open("ab"):
            pass

    def emit(self, record: logging.LogRecord) -> None:
        try:
            line = (self._redacted(record) + "\n").encode("utf-8", "backslashreplace")
            self._rotate(len(line))
            with self._path.open("ab", buffering=0) as file:
                file.write(line)
        except Exception as fault:  # a full disk, a folder that went away: the program is more important than its log
            told, self._failed = self._failed, True
            if not told and getattr(fault, "errno", None) not in _FULL:
                with suppress(OSError):
                    print(f"The log could not be written ({fault}). Everything else goes on.", file=sys.stderr)

    def _redacted(self, record: logging.LogRecord) -> str:
        with _names_lock:
            names, sources = list(_names), list(_sources)
        for source in sources:
            names += source()
        if self._names != names:
            self._redactor, self._names = Redactor(names), names
        text = self.format(record)
        fault = record.exc_info[1] if record.exc_info else None
        extra = file_names(_files_of(fault, *(argument for argument in _arguments(record) if isinstance(argument, BaseException))))
        return self._redactor(Redactor(extra)(text) if extra else text)

    def _rotate(self, more: int) -> None:
        if not self._is_full(more):
            return
        with suppress(OSError), self._alone():  # held by another program: the file grows until the next line tries again
            files = _generations(self._folder)
            if self._is_full(more):
                for older, newer in zip(files[:0:-1], files[-2::-1], strict=True):
                    if newer.exists():
                        os.replace(newer, older)

    def _is_full(self, more: int) -> bool:
        with suppress(FileNotFoundError):  # another program has just moved it away
            return self._path.stat().st_size + more > MOST_BYTES
        return False

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Only one program moves the files; FileExistsError when another does.  What a killed one left counts for ten seconds."""
        mark = self._path.with_suffix(".moving")
        with suppress(FileNotFoundError):
            if time.time() - mark.stat().st_mtime > 10.0:
                mark.unlink(missing_ok=True)
        os.close(os.open(mark, os.O_CREAT | os.O_EXCL | os.O_WRONLY))
        try:
            yield
        finally:
            mark.unlink(missing_ok=True)


def _generations(folder: Path) -> list[Path]:
    return [folder / NAME, *(folder / f"{NAME}.{number}" for number in range(1, FILES))]


def _arguments(record: logging.LogRecord) -> tuple[object, ...]:
    return record.args if isinstance(record.args, tuple) else ()


def _files_of(*faults: BaseException | None) -> Iterator[str]:
    """The files that faults and their causes name."""
    waiting, seen = [fault for fault in faults if fault is not None], 0
    while waiting and seen < 20:
        fault = waiting.pop()
        seen += 1
        if isinstance(fault, ImprontaError):
            yield from (str(fault.fields[key]) for key in _PATH_FIELDS if fault.fields.get(key))
        elif isinstance(fault, OSError):
            yield from (os.fspath(name) for name in (fault.filename, fault.filename2) if isinstance(name, str | os.PathLike))
        waiting += [cause for cause in (fault.__cause__, fault.__context__) if cause is not None]
