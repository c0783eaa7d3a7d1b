"""What SQLite leaves beside the file of a program that was killed, before SQLite itself looks at it.

SQLite believes a log by its name alone.  One that was made by somebody else, or that a case left which is gone, must
never reach it.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path

from scanner_core.errors import CaseFormatError, InputFileError

LOGS = ("-wal", "-journal")

_MAGIC = bytes.fromhex("d9d505f920a163d7")
"""Of a rollback journal: its first eight bytes; and its last ones where it belongs to a transaction over several files."""
_TRAILER = 16
"""Length and checksum of a name, and the magic."""


def refuse_foreign_logs(path: Path) -> None:
    """E-CASE-01 when what lies beside a case is nothing that this program has left there; E-FILE-05 when it cannot be read.

    A journal whose end names a super-journal lets SQLite *delete* the file of that name, even when it opens the case for
    reading alone; only transactions over several databases write one, and a case is a single database.
    """
    place = os.path.realpath(path)  # the logs lie beside the file itself, not beside a link to it
    for suffix in LOGS:
        log = place + suffix
        try:
            told = os.lstat(log)
            if not stat.S_ISREG(told.st_mode):
                raise CaseFormatError("E-CASE-01", path=path, reason=f"what lies beside it as {os.path.basename(log)} is no file")
            if suffix == "-journal" and told.st_size >= _TRAILER:
                with open(log, "rb") as file:
                    file.seek(-len(_MAGIC), os.SEEK_END)
                    named = file.read() == _MAGIC
                if named:
                    raise CaseFormatError("E-CASE-01", path=path, reason=f"its journal {os.path.basename(log)} speaks of another file")
        except (FileNotFoundError, NotADirectoryError):
            continue
        except OSError as fault:
            raise unreadable(Path(log), fault) from fault


def unreadable(path: Path, fault: OSError) -> InputFileError:
    """E-FILE-05."""
    return InputFileError("E-FILE-05", path=path, reason=fault.strerror or fault, details=str(fault))


def left_behind(path: Path) -> Path | None:
    """A log that lies there though the case itself may be gone; SQLite would take it for one of a new case of that name."""
    place = os.path.realpath(path)
    for log in (Path(place + suffix) for suffix in LOGS):
        try:
            told = os.lstat(log)
        except (FileNotFoundError, NotADirectoryError):
            continue
        if told.st_size or not stat.S_ISREG(told.st_mode):
            return log
    return None
