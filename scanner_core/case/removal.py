"""A case that is taken out of the list of orders: moved into the folder ``Removed`` beside it, never deleted."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from scanner_core.case.connection import looking, refuse_open
from scanner_core.case.logs import LOGS, left_behind
from scanner_core.case.store import CaseStore
from scanner_core.errors import CaseFormatError
from scanner_core.files import storage_error

REMOVED = "Removed"
"""Name of the folder."""


def remove_case(path: Path) -> Path:
    """Move a case into the folder of removed ones; returns its new place.

    What a killed program left beside it is folded in first, so that nothing of it stays behind.  A file that is damaged is moved
    as it is, with what lies beside it.

    Raises
    ------
    CaseError, CaseLockedError
        E-CASE-04 it is gone, E-CASE-02 it is open here or elsewhere.
    StorageError
        E-DISK-01 or E-DISK-02 when it cannot be moved; it is then where it was.
    """
    with suppress(CaseFormatError):
        CaseStore.open(path).close()
    return _moved(path, path.parent / REMOVED / path.name)


def put_back(path: Path, to: Path) -> Path:
    """Move a removed case back to where it was, or beside that when the name is taken; returns its place.  Errors as for :func:`remove_case`."""
    return _moved(path, to)


def _moved(path: Path, to: Path) -> Path:
    folder = to.parent
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with looking:  # nobody of this process opens it meanwhile
            refuse_open(path)
            place, number = to, 1
            while place.exists() or left_behind(place) is not None:
                number += 1
                place = folder / f"{to.stem}-{number}{to.suffix}"
            _rename_all([(f"{path}{part}", f"{place}{part}") for part in (*LOGS, "") if os.path.exists(f"{path}{part}")])
    except OSError as fault:
        raise storage_error(path, fault) from fault
    return place


def _rename_all(ways: list[tuple[str, str]]) -> None:
    """All of them or none: a case without its log would lack its newest part."""
    done: list[tuple[str, str]] = []
    try:
        for before, after in ways:
            os.rename(before, after)
            done.append((before, after))
    except OSError:
        for before, after in reversed(done):
            with suppress(OSError):
                os.rename(after, before)
        raise
