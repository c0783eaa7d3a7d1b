"""``--force`` on a case: the old one survives until the new one holds a measurement."""

from __future__ import annotations

import os
import secrets
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from scanner_core.case.logs import LOGS
from scanner_core.case.store import CaseStore
from scanner_core.files import check_free, storage_error

_WHOLE = ("", *LOGS)
"""A case, and what a killed program may have left beside it."""


def check_case_free(path: Path, force: bool) -> None:
    """Say before the rig is touched whether a new case can be made at `path`.

    Raises
    ------
    CaseError, StorageError
        E-CASE-02 while another program has the old case open, E-CASE-01 when it is no case; as :func:`check_free`.
    """
    check_free(path, force)
    if force and path.exists():
        CaseStore.open(path).close()


@contextmanager
def overwriting(path: Path, force: bool) -> Iterator[Callable[[], None]]:
    """Make way for a new case at `path`; the body makes it, and closes it.

    The body calls what it is given, as often as it likes, once the new case holds something: then the old one is gone.
    When the body ends without that call, however it ends, the new case is removed and the old one is back in its place.
    """
    place = Path(os.path.realpath(path))
    aside = place.with_name(f".{place.stem[:100]}.{secrets.token_hex(4)}.replaced{place.suffix}")
    if not force or not any(os.path.lexists(f"{place}{part}") for part in _WHOLE):
        yield lambda: None
        return
    check_case_free(place, force)
    _move(place, aside)

    def drop() -> None:
        for part in _WHOLE:
            with suppress(OSError):
                os.unlink(f"{aside}{part}")

    try:
        yield drop
    finally:
        if any(os.path.lexists(f"{aside}{part}") for part in _WHOLE):
            for part in _WHOLE:
                with suppress(FileNotFoundError):
                    os.unlink(f"{place}{part}")
            _move(aside, place)


def _move(source: Path, target: Path) -> None:
    try:
        for part in _WHOLE:
            if os.path.lexists(f"{source}{part}"):
                os.replace(f"{source}{part}", f"{target}{part}")
    except OSError as fault:
        raise storage_error(target, fault) from fault
