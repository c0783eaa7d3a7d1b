"""The cameras that Linux knows: nodes ``/dev/video*``, their stable names, and what keeps a program from one."""

from __future__ import annotations

import errno
import os
import struct
import sys
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

_QUERYCAP = 0x80685600
_CAPABILITY = "16s32s32sIII12x"
_REQBUFS = 0xC0145608
_REQUEST_BUFFERS = "IIII4x"
_DEVICE_CAPS, _STREAMING = 0x80000000, 0x04000000
_VIDEO_CAPTURE = 0x00000001 | 0x00001000  # of one plane, of several planes
_MMAP = 1
_HIDDEN_BY = ("pispbe", "bcm2835-codec", "bcm2835-isp")
"""Drivers of image processors, whose nodes call themselves cameras."""

Ioctl = Callable[[int, int, bytearray], object]


class Access(Enum):
    """Whether this program may have a camera."""

    FREE = "free"
    BUSY = "another program holds it"
    NOT_PERMITTED = "the user may not open it"
    GONE = "there is none"
    NO_CAMERA = "it delivers no pictures"
    FAULTY = "it does not answer"


@dataclass(frozen=True, slots=True)
class VideoNode:
    """A node that delivers pictures: `path` to open, `id` as it goes into a rig file, `description` as the system names it."""

    path: Path
    id: str
    description: str


def _ioctl(descriptor: int, request: int, buffer: bytearray) -> None:
    from fcntl import ioctl  # only POSIX has it

    ioctl(descriptor, request, buffer)


class VideoNodes:
    """Video4Linux below a root folder.

    A node's number depends on the order of plugging in, so its id is its name of ``/dev/v4l/by-id`` (maker, model, serial
    number), or of ``/dev/v4l/by-path`` (the USB socket) where two cameras without a serial number share the former, or as the
    last resort the node itself.
    """

    def __init__(self, root: Path = Path("/"), ioctl: Ioctl = _ioctl) -> None:
        self._root, self._ioctl = root, ioctl

    def list(self) -> list[VideoNode]:
        """Every node that delivers pictures or cannot be asked, by number; a camera's nodes for other data are left out."""
        nodes = sorted((self._root / "dev").glob("video[0-9]*"), key=lambda path: (len(path.name), path.name))
        links = self._links()
        return [
            VideoNode(node, links.get(node.resolve(), str(node)), self.description(node))
            for node in nodes
            if self.access(node, quick=True) not in (Access.NO_CAMERA, Access.GONE)
        ]

    def resolve(self, identity: str) -> Path:
        """The path of an id: a name of by-id or by-path, with or without its folder, or a node."""
        given = Path(identity)
        if given.is_absolute():
            return given
        for folder in self._folders():
            if os.path.lexists(folder / identity):
                return folder / identity
        return self._folders()[0] / identity

    def access(self, path: Path, *, quick: bool = False) -> Access:
        """Whether it is there, delivers pictures, and is free.

        OpenCV tells none of that.  Any number of programs may open a node, but only one may own its buffers: to ask for none
        of them is refused while another one streams, and changes nothing.  `quick` leaves that question out.
        """
        try:
            descriptor = os.open(path, os.O_RDWR | getattr(os, "O_NONBLOCK", 0))
        except OSError as fault:
            return _access(fault)
        try:
            capability = bytearray(struct.calcsize(_CAPABILITY))
            self._ioctl(descriptor, _QUERYCAP, capability)
            driver, _, _, _, of_device, of_node = struct.unpack(_CAPABILITY, capability)
            able = of_node if of_device & _DEVICE_CAPS else of_device
            if not (able & _VIDEO_CAPTURE and able & _STREAMING) or driver.rstrip(b"\0").decode("ascii", "replace") in _HIDDEN_BY:
                return Access.NO_CAMERA
            if not quick:
                kind = 1 if able & 0x1 else 9
                self._ioctl(descriptor, _REQBUFS, bytearray(struct.pack(_REQUEST_BUFFERS, 0, kind, _MMAP, 0)))
        except OSError as fault:
            return _access(fault)
        finally:
            os.close(descriptor)
        return Access.FREE

    def _links(self) -> dict[Path, str]:
        """Node to its stable name: of by-id before by-path."""
        links: dict[Path, str] = {}
        for folder in self._folders():
            for link in sorted(folder.glob("*")):
                links.setdefault(link.resolve(), link.name)
        return links

    def _folders(self) -> tuple[Path, Path]:
        return self._root / "dev/v4l/by-id", self._root / "dev/v4l/by-path"

    def description(self, node: Path) -> str:
        try:
            return (self._root / "sys/class/video4linux" / node.name / "name").read_text("utf-8", "replace").strip() or node.name
        except OSError:
            return node.name


def has_video_nodes() -> bool:
    """Whether this system knows cameras by nodes."""
    return sys.platform.startswith("linux")


def _access(fault: OSError) -> Access:
    if fault.errno == errno.EBUSY:
        return Access.BUSY
    if fault.errno in (errno.EACCES, errno.EPERM):
        return Access.NOT_PERMITTED
    if fault.errno in (errno.ENOENT, errno.ENODEV, errno.ENXIO):
        return Access.GONE
    if fault.errno in (errno.ENOTTY, errno.EINVAL):  # a file, or a node of another kind
        return Access.NO_CAMERA
    return Access.FAULTY
