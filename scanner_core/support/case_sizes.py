"""The cases of a folder: how many, how large and how old, and the names that must not stay in a text."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from datetime import date
from pathlib import Path

from scanner_core.case.store import SUFFIX, CaseStore
from scanner_core.errors import ImprontaError
from scanner_core.jobs.progress import Cancelled, IsCancelled
from scanner_core.support.private_names import PrivateName, file_names, folder_names, order_names

_MOST = 500
_READING_S = 5.0
"""So long orders are read out of cases; the names of the files are known anyway."""


def cases_of(folders: Iterable[Path], files: Iterable[Path] = ()) -> list[Path]:
    """Cases in these folders (not below them) and these files, the newest first, at most 500."""
    found = {path for path in files if path.suffix.lower() == SUFFIX and path.is_file()}
    for folder in folders:
        with suppress(OSError):
            found |= {path for path in folder.iterdir() if path.suffix.lower() == SUFFIX and path.is_file()}
    return sorted(found, key=_changed_s, reverse=True)[:_MOST]


def case_list(cases: Iterable[Path]) -> list[dict[str, object]]:
    """A number, a size and a day for each; nothing of what is in it."""
    return [{"case": number, **size} for number, size in enumerate(_sizes(cases), 1)]


def case_names(cases: Iterable[Path], *, cancelled: IsCancelled) -> list[PrivateName]:
    """The names of the files and of the orders in them, as far as they can be read in a few seconds.

    Raises
    ------
    Cancelled
    """
    until_s = time.monotonic() + _READING_S
    names: list[PrivateName] = []
    for path in cases:
        if cancelled():
            raise Cancelled
        names += [*file_names([path]), *folder_names([path.parent])]
        if time.monotonic() < until_s:
            with suppress(ImprontaError), CaseStore.open(path, read_only=True) as store:  # one that is being scanned into belongs to its owner
                order = store.order()
                names += order_names(order.number, order.patient_code, order.remarks)
    return list(dict.fromkeys(names))


def _sizes(cases: Iterable[Path]) -> Iterator[dict[str, object]]:
    for path in cases:
        with suppress(OSError):
            known = path.stat()
            yield {"bytes": known.st_size, "changed": date.fromtimestamp(known.st_mtime).isoformat()}


def _changed_s(path: Path) -> float:
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0
