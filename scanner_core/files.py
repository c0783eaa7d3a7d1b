"""Output files that appear whole or not at all."""

from __future__ import annotations

import errno
import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from scanner_core.errors import ImprontaError, StorageError

_NO_SPACE = {errno.ENOSPC, errno.EDQUOT}
_NO_HARD_LINKS = {errno.EPERM, errno.ENOTSUP, errno.EOPNOTSUPP, errno.ENOSYS, errno.EXDEV, errno.EMLINK}


@contextmanager
def replaced_when_whole(path: Path | str, force: bool = False) -> Iterator[Path]:
    """Write a file beside its place and put it there when it is whole.

    The body of the ``with`` writes the path that it is given: a new, empty file in the same folder with the same
    suffix.  When the body ends, that file is flushed to the disk and renamed; when the body raises, whatever it
    raises, the partial file is removed and `path` is as it was before.

    Parameters
    ----------
    path
        Where the file shall appear; the folder must exist.
    force
        Replace an existing file; without it an existing file is never touched, not even one that appears meanwhile.

    Raises
    ------
    StorageError
        E-DISK-01 no space left, E-DISK-02 not allowed (also for an ``OSError`` of the body that concerns the partial
        file), E-DISK-03 exists already.
    """
    asked = Path(path)
    place = Path(os.path.realpath(asked))  # a link stays a link: its target is replaced
    if place.is_dir():
        raise StorageError("E-DISK-02", path=asked, reason="it is a folder")
    if place.exists() and not force:
        raise StorageError("E-DISK-03", path=asked)
    partial = place.with_name(f".{place.stem[:100]}.{secrets.token_hex(4)}.part{place.suffix}")
    try:
        os.close(os.open(partial, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        yield partial
        _flush(partial)
        _put(partial, place, force)
        _flush_folder(place.parent)
    except FileExistsError as fault:
        raise StorageError("E-DISK-03", path=asked) from fault
    except ImprontaError:
        raise
    except OSError as fault:
        if fault.filename is not None and os.fspath(fault.filename) != os.fspath(partial):
            raise  # another file, which the body read
        raise storage_error(asked, fault) from fault
    finally:
        with suppress(OSError):
            partial.unlink(missing_ok=True)


def check_free(path: Path | str, force: bool = False) -> None:
    """Say before long work whether its result can appear at `path`; raises what :func:`replaced_when_whole` would."""
    place = Path(os.path.realpath(path))
    if place.is_dir():
        raise StorageError("E-DISK-02", path=path, reason="it is a folder")
    if place.exists() and not force:
        raise StorageError("E-DISK-03", path=path)
    if not place.parent.is_dir():
        raise StorageError("E-DISK-02", path=path, reason="its folder does not exist")
    if not os.access(place.parent, os.W_OK):
        raise StorageError("E-DISK-02", path=path, reason="its folder cannot be written")


def storage_error(path: Path | str, fault: OSError) -> StorageError:
    """What an ``OSError`` while writing `path` means to a person: E-DISK-01 disk full, E-DISK-02 anything else."""
    if fault.errno in _NO_SPACE:
        return StorageError("E-DISK-01", details=str(fault), path=path)
    return StorageError("E-DISK-02", details=str(fault), path=path, reason=fault.strerror or str(fault))


def _put(partial: Path, place: Path, force: bool) -> None:
    if force:
        os.replace(partial, place)
        return
    try:
        os.link(partial, place)  # unlike a rename it fails when somebody else has made the file meanwhile
    except OSError as fault:
        if isinstance(fault, FileExistsError) or fault.errno not in _NO_HARD_LINKS:
            raise
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(place)) from fault
        os.rename(partial, place)


def _flush(path: Path) -> None:
    descriptor = os.open(path, os.O_RDWR)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _flush_folder(folder: Path) -> None:
    """Make the new name itself last; where a folder cannot be opened (Windows) the system does that alone."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
