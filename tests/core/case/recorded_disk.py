"""What the store writes, as a sequence: a virtual file system of SQLite that notes every write and every sync.

The real store runs on it: only ``sqlite3.connect`` is exchanged for a connection of apsw, whose SQLite calls back into
Python for every operation on a file.  What the store does to files by itself (the creation is built beside and put in
place) is noted as well.  From any prefix of the sequence the files can be made again, as a kill leaves them or as a power
cut may.

That SQLite (3.54.1) is the one inside apsw, not the one inside Python (3.40.1 when this was written).  Both went through
the same life under ``strace -f -e trace=openat,pwrite64,ftruncate,fsync,fdatasync,unlink,link``: the same 283 calls in the
same order, with the same offsets and lengths.
"""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import apsw
import pytest

SECTOR = 512
REPLACED: dict[str, str] = {}
"""Statements that another one takes the place of: a store that is worse on purpose."""


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation on one file; `name` is relative to the folder that is watched.

    Attributes
    ----------
    kind : create, write, truncate, sync, delete, link (of `name` to `other`) or sync_folder
    at : offset of a write, or the new length
    lasting : a delete that syncs the folder too
    """

    kind: str
    name: str = ""
    at: int = 0
    data: bytes = b""
    other: str = ""
    lasting: bool = False


@dataclass(slots=True)
class Recording:
    """All operations below a folder, in their order."""

    folder: Path
    operations: list[Operation] = field(default_factory=list)

    def note(self, kind: str, path: str | os.PathLike[str], **details: Any) -> None:
        place = Path(os.path.realpath(path))
        if place == Path(os.path.realpath(self.folder)):
            self.operations.append(Operation(kind, **details))
        elif place.parent == Path(os.path.realpath(self.folder)):
            self.operations.append(Operation(kind, place.name, **details))


class _RecordingFile(apsw.VFSFile):
    def __init__(self, recording: Recording, name: str | apsw.URIFilename | None, flags: list[int]) -> None:
        super().__init__("", name, flags)
        self._recording = recording
        self._path = name.filename() if isinstance(name, apsw.URIFilename) else str(name)

    def xWrite(self, data: bytes, offset: int) -> None:  # noqa: N802
        super().xWrite(data, offset)
        self._recording.note("write", self._path, at=offset, data=bytes(data))

    def xTruncate(self, newsize: int) -> None:  # noqa: N802
        super().xTruncate(newsize)
        self._recording.note("truncate", self._path, at=newsize)

    def xSync(self, flags: int) -> None:  # noqa: N802
        super().xSync(flags)
        self._recording.note("sync", self._path)


class _RecordingSystem(apsw.VFS):
    def __init__(self, recording: Recording) -> None:
        self.system_name = f"recording-{id(recording)}"
        self._recording = recording
        super().__init__(self.system_name, "")

    def xOpen(self, name: str | apsw.URIFilename | None, flags: list[int]) -> _RecordingFile:  # noqa: N802
        path = name.filename() if isinstance(name, apsw.URIFilename) else name
        if path is not None and not os.path.exists(path):
            self._recording.note("create", path)
        return _RecordingFile(self._recording, name, flags)

    def xDelete(self, filename: str, syncdir: bool) -> None:  # noqa: N802
        super().xDelete(filename, syncdir)
        self._recording.note("delete", filename, lasting=bool(syncdir))


class _Cursor:
    """As much of ``sqlite3.Cursor`` as the store uses."""

    def __init__(self, connection: apsw.Connection, rows: Iterator[Any]) -> None:
        self._rows = list(rows)
        self.lastrowid = connection.last_insert_rowid()

    def __iter__(self) -> Iterator[Any]:
        return iter(self._rows)

    def fetchone(self) -> Any:
        return self._rows[0] if self._rows else None

    def fetchall(self) -> list[Any]:
        return self._rows


class _Connection:
    """As much of ``sqlite3.Connection`` as the store uses."""

    def __init__(self, path: str, flags: int, system: str) -> None:
        self._connection = apsw.Connection(path, flags=flags, vfs=system)

    def execute(self, query: str, values: tuple[object, ...] = ()) -> _Cursor:
        return _Cursor(self._connection, self._connection.execute(REPLACED.get(query, query), values))

    def executemany(self, query: str, values: list[tuple[object, ...]]) -> _Cursor:
        return _Cursor(self._connection, self._connection.executemany(query, values))

    def executescript(self, script: str) -> None:
        list(self._connection.execute(script))

    def setlimit(self, category: int, limit: int) -> int:
        return self._connection.limit(category, limit)

    def set_progress_handler(self, handler: Callable[[], bool] | None, steps: int) -> None:
        self._connection.set_progress_handler(handler, steps or 100)

    @property
    def in_transaction(self) -> bool:
        return self._connection.in_transaction

    def close(self) -> None:
        self._connection.close()


@contextmanager
def recorded(folder: Path) -> Iterator[Recording]:
    """Note everything that is done to the files of a folder meanwhile."""
    recording = Recording(folder)
    system = _RecordingSystem(recording)
    names: dict[int, str] = {}
    real_connect = sqlite3.connect
    real_open, real_fsync, real_link, real_unlink = os.open, os.fsync, os.link, os.unlink

    def connect(place: str, **given: Any) -> _Connection | sqlite3.Connection:
        if place == ":memory:":
            return real_connect(place, **given)
        parts = urlsplit(place)
        assert parts.query == "mode=rw"
        return _Connection(unquote(parts.path), apsw.SQLITE_OPEN_READWRITE, system.system_name)

    def opened(path: str, flags: int, *rest: Any, **named: Any) -> int:
        descriptor = real_open(path, flags, *rest, **named)
        names[descriptor] = os.fspath(path)
        if flags & os.O_CREAT:
            recording.note("create", path)
        return descriptor

    def synced(descriptor: int) -> None:
        real_fsync(descriptor)
        path = names[descriptor]
        recording.note("sync_folder" if os.path.isdir(path) else "sync", path)

    def linked(source: str, target: str, **named: Any) -> None:
        real_link(source, target, **named)
        recording.note("link", source, other=Path(target).name)

    def unlinked(path: str, **named: Any) -> None:
        real_unlink(path, **named)
        recording.note("delete", path)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sqlite3.connect", connect)
        for name, replacement in (("open", opened), ("fsync", synced), ("link", linked), ("unlink", unlinked)):
            patch.setattr(os, name, replacement)
        try:
            yield recording
        finally:
            system.unregister()


Files = dict[str, bytearray]


@dataclass(slots=True)
class _Inode:
    """The bytes of a file as they are on the disk for certain, and what was done since the last sync."""

    lasting: bytearray = field(default_factory=bytearray)
    pending: list[Operation] = field(default_factory=list)

    def content(self, keep: Callable[[], bool]) -> bytearray:
        """`keep` decides of every sector of every operation since the last sync."""
        content = bytearray(self.lasting)
        for operation in self.pending:
            if operation.kind == "truncate":
                if keep():
                    _resize(content, operation.at)
                continue
            start, end = operation.at, operation.at + len(operation.data)
            while start < end:
                stop = min((start // SECTOR + 1) * SECTOR, end)
                if keep():
                    _resize(content, max(len(content), stop))
                    content[start:stop] = operation.data[start - operation.at : stop - operation.at]
                start = stop
        return content

    def sync(self) -> None:
        self.lasting, self.pending = self.content(lambda: True), []


def _resize(content: bytearray, length: int) -> None:
    if length < len(content):
        del content[length:]
    else:
        content.extend(bytes(length - len(content)))


class Disk:
    """A disk that follows a recording and can tell what a kill or a power cut would leave."""

    def __init__(self, files: Files) -> None:
        """`files` are there from the beginning, and last."""
        self._names = {name: _Inode(bytearray(content)) for name, content in files.items()}
        self._lasting_names = dict(self._names)

    def apply(self, operation: Operation) -> None:
        name, names = operation.name, self._names
        if operation.kind == "create":
            names.setdefault(name, _Inode())
        elif operation.kind in ("write", "truncate"):
            names[name].pending.append(operation)
        elif operation.kind == "sync":
            names[name].sync()
            self._lasting_names[name] = names[name]  # SQLite syncs the folder with the first sync of a file that it made
        elif operation.kind == "link":
            names[operation.other] = names[name]
        elif operation.kind == "delete":
            names.pop(name, None)
            if operation.lasting:
                self._lasting_names = dict(names)
        elif operation.kind == "sync_folder":
            self._lasting_names = dict(names)
        else:
            raise AssertionError(operation.kind)

    def after_kill(self) -> Files:
        """Everything that was handed to the system is there."""
        return {name: inode.content(lambda: True) for name, inode in self._names.items()}

    def after_power_cut(self, keep: Callable[[], bool]) -> Files:
        """What was synced is there; of the rest what `keep` says, by sector, and by change of the folder."""
        names = dict(self._lasting_names)
        for name in sorted(self._names.keys() | self._lasting_names.keys()):
            here = self._names.get(name)
            if here is not self._lasting_names.get(name) and keep():
                names.pop(name, None)
                if here is not None:
                    names[name] = here
        return {name: inode.content(keep) for name, inode in names.items()}
