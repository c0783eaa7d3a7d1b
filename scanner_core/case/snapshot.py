"""A copy of an open case for another process: the file itself is held by the one that has it open."""

from __future__ import annotations

import tempfile
from pathlib import Path
from types import TracebackType

from scanner_core.case.store import CaseStore
from scanner_core.errors import ImprontaError
from scanner_core.files import storage_error


class CaseSnapshot:
    """The case as it stands now, in a folder of its own; it is gone when this is closed."""

    def __init__(self, store: CaseStore) -> None:
        """
        Raises
        ------
        StorageError
            E-DISK-01 or E-DISK-02 when there is no room for it.
        """
        try:
            self._folder = tempfile.TemporaryDirectory(prefix="impronta-case-", ignore_cleanup_errors=True)
        except OSError as fault:
            raise storage_error(Path(tempfile.gettempdir()), fault) from fault
        self.path = Path(self._folder.name) / "case.impronta"
        try:
            store.copy_to(self.path)
        except ImprontaError:
            self.close()
            raise

    def __enter__(self) -> CaseSnapshot:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Remove the copy; may be called again."""
        self._folder.cleanup()
