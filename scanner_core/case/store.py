"""The case file.  What an open case can do stands in its parts; here it is created and opened."""

from __future__ import annotations

from pathlib import Path

from scanner_core.case import connection
from scanner_core.case.creation import SUFFIX, create_case
from scanner_core.case.reading import open_for_reading
from scanner_core.case.records import CaseEdit, MountPose, Order, ScanRecord
from scanner_core.case.scans import ScanTables
from scanner_core.case.stripes import StripeTables
from scanner_core.case.surfaces import SurfaceTables

__all__ = ["SUFFIX", "CaseEdit", "CaseStore", "MountPose", "Order", "ScanRecord"]


class CaseStore(ScanTables, StripeTables, SurfaceTables):
    """An open case.  A context manager: leaving it closes it.  Its methods may be called from any thread.

    Make one with :meth:`create` or :meth:`open`.
    """

    @classmethod
    def create(cls, path: Path) -> CaseStore:
        """A new case; the file must not exist, and appears whole.

        Raises
        ------
        StorageError
            E-DISK-03 when it exists, or the log of a case of that name, E-DISK-01 or E-DISK-02 when it cannot be written.
        """
        create_case(path)
        return cls.open(path)

    @classmethod
    def open(cls, path: Path, *, read_only: bool = False) -> CaseStore:
        """An existing case; brought to this program's schema version when it is older.

        Parameters
        ----------
        read_only : neither the file nor its folder is changed, whatever state it is in; whoever has it open for writing
            keeps others from looking too

        Raises
        ------
        CaseError, CaseFormatError, CaseLockedError
            E-CASE-04 no such file, E-CASE-01 no case or damaged, E-CASE-03 too new, E-CASE-02 open elsewhere.
        StorageError, InputFileError
            E-DISK-02 the file or its folder cannot be written, E-FILE-05 it cannot be read.
        """
        with connection.sentences(path):
            header = connection.read_header(path)
            if read_only:
                return cls(path, *open_for_reading(path, header), read_only=True)
            mark = connection.claim(path)
            try:
                opened = connection.connect(path)
            except BaseException:
                connection.release(mark)
                raise

            def end() -> None:
                try:
                    connection.fold_in(opened)
                finally:
                    connection.release(mark)

            return cls(path, opened, end, read_only=False)

    def __enter__(self) -> CaseStore:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()
