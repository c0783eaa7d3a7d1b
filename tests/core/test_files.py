"""Files appear whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from scanner_core import files
from scanner_core.errors import StorageError, UsageError
from scanner_core.files import replaced_when_whole


def _names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_whole_file_appears_with_its_suffix_and_usual_permissions(tmp_path: Path) -> None:
    place = tmp_path / "mesh.stl"
    with replaced_when_whole(place) as partial:
        assert partial.suffix == ".stl"
        assert partial.parent == tmp_path
        partial.write_bytes(b"whole")
        assert not place.exists()
    assert place.read_bytes() == b"whole"
    assert _names(tmp_path) == ["mesh.stl"]
    if os.name == "posix":
        mask = os.umask(0)
        os.umask(mask)
        assert stat.S_IMODE(place.stat().st_mode) == 0o666 & ~mask


@pytest.mark.parametrize("fault", [RuntimeError("mine"), KeyboardInterrupt(), UsageError("E-USE-01", what="w", do="d")])
def test_whatever_the_body_raises_nothing_is_left(tmp_path: Path, fault: BaseException) -> None:
    (tmp_path / "old").write_bytes(b"old")

    def write() -> None:
        with replaced_when_whole(tmp_path / "old", force=True) as partial:
            partial.write_bytes(b"half")
            raise fault

    with pytest.raises(type(fault)):
        write()
    assert (tmp_path / "old").read_bytes() == b"old"
    assert _names(tmp_path) == ["old"]


def test_an_existing_file_is_replaced_only_by_force(tmp_path: Path) -> None:
    place = tmp_path / "points.xyz"
    place.write_bytes(b"old")
    with pytest.raises(StorageError, match="E-DISK-03"), replaced_when_whole(place):
        pytest.fail("the body must not run")
    assert place.read_bytes() == b"old"
    with replaced_when_whole(place, force=True) as partial:
        partial.write_bytes(b"new")
    assert place.read_bytes() == b"new"


def test_a_file_that_appears_meanwhile_is_kept(tmp_path: Path) -> None:
    place = tmp_path / "mesh.ply"

    def write() -> None:
        with replaced_when_whole(place) as partial:
            partial.write_bytes(b"ours")
            place.write_bytes(b"theirs")

    with pytest.raises(StorageError, match="E-DISK-03"):
        write()
    assert place.read_bytes() == b"theirs"
    assert _names(tmp_path) == ["mesh.ply"]


@pytest.mark.parametrize("taken", [False, True])
def test_a_disk_without_hard_links_works_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, taken: bool) -> None:
    place = tmp_path / "mesh.ply"

    def no_links(source: object, target: object) -> None:
        if taken:
            place.write_bytes(b"theirs")
        raise OSError(errno.EPERM, "no hard links")

    monkeypatch.setattr(files.os, "link", no_links)
    if taken:
        with pytest.raises(StorageError, match="E-DISK-03"), replaced_when_whole(place) as partial:
            partial.write_bytes(b"ours")
    else:
        with replaced_when_whole(place) as partial:
            partial.write_bytes(b"ours")
    assert place.read_bytes() == (b"theirs" if taken else b"ours")
    assert _names(tmp_path) == ["mesh.ply"]


@pytest.mark.parametrize(
    ("number", "code"), [(errno.ENOSPC, "E-DISK-01"), (errno.EDQUOT, "E-DISK-01"), (errno.EACCES, "E-DISK-02"), (errno.EIO, "E-DISK-02")]
)
@pytest.mark.parametrize("place", ["body", "fsync"])
def test_faults_of_the_disk_are_told_and_nothing_is_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, code: str, place: str) -> None:
    def fail(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    if place == "fsync":
        monkeypatch.setattr(files.os, "fsync", fail)

    def write() -> None:
        with replaced_when_whole(tmp_path / "mesh.stl") as partial:
            partial.write_bytes(b"half")
            if place == "body":
                fail()

    with pytest.raises(StorageError) as caught:
        write()
    assert caught.value.code == code
    assert _names(tmp_path) == []


def test_a_fault_of_another_file_stays_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), replaced_when_whole(tmp_path / "out"):
        (tmp_path / "missing").read_bytes()
    assert _names(tmp_path) == []


def test_a_missing_folder_and_a_folder_in_place_of_the_file(tmp_path: Path) -> None:
    for path in (tmp_path / "no" / "mesh.stl", tmp_path):
        with pytest.raises(StorageError, match="E-DISK-02"), replaced_when_whole(path, force=True):
            pytest.fail("the body must not run")


@pytest.mark.skipif(os.name != "posix", reason="symbolic links")
def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "target").write_bytes(b"old")
    (tmp_path / "link").symlink_to(tmp_path / "target")
    with replaced_when_whole(tmp_path / "link", force=True) as partial:
        partial.write_bytes(b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").read_bytes() == b"new"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_disk_that_is_really_full(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="E-DISK-01"), replaced_when_whole(tmp_path / "mesh.stl"), open("/dev/full", "wb", buffering=0) as full:
        full.write(b"0")


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_a_killed_program_leaves_the_old_file(tmp_path: Path) -> None:
    place = tmp_path / "mesh.stl"
    place.write_bytes(b"old")
    program = (
        "import os, signal, sys\nfrom scanner_core.files import replaced_when_whole\n"
        "with replaced_when_whole(sys.argv[1], force=True) as partial:\n"
        "    partial.write_bytes(b'half')\n    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    root = Path(__file__).parents[2]
    subprocess.run([sys.executable, "-c", program, str(place)], cwd=root, check=False, timeout=60)
    assert place.read_bytes() == b"old"
