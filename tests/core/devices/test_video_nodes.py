"""Cameras as Linux names them: a tree of files as udev makes it, and a kernel whose answers are given."""

from __future__ import annotations

import errno
import os
import struct
import sys
from pathlib import Path

import pytest

from scanner_core.devices.video_nodes import Access, VideoNodes

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no Video4Linux")

CAPTURE, META, STREAMING, OF_NODE = 0x1, 0x00800000, 0x04000000, 0x80000000
QUERYCAP, REQBUFS = 0x80685600, 0xC0145608


pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="nodes of Linux; the fake kernel finds them by /proc")


class Machine:
    """`capabilities` by node name, and the faults that a node answers with: to QUERYCAP and to REQBUFS."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.capabilities: dict[str, int] = {}
        self.faults: dict[tuple[str, int], int] = {}
        self.nodes = VideoNodes(root, self._ioctl)
        (root / "dev/v4l/by-id").mkdir(parents=True)
        (root / "dev/v4l/by-path").mkdir(parents=True)

    def plug_in(self, node: str, name: str, capabilities: int = CAPTURE | STREAMING, by_id: str = "", by_path: str = "") -> Path:
        path = self.root / "dev" / node
        path.touch()
        about = self.root / "sys/class/video4linux" / node
        about.mkdir(parents=True)
        (about / "name").write_text(name + "\n")
        for folder, link in (("by-id", by_id), ("by-path", by_path)):
            if link:
                (self.root / "dev/v4l" / folder / link).symlink_to(f"../../{node}")
        self.capabilities[node] = capabilities
        return path

    def _ioctl(self, descriptor: int, request: int, buffer: bytearray) -> None:
        node = os.path.basename(os.readlink(f"/proc/self/fd/{descriptor}"))
        if (node, request) in self.faults:
            raise OSError(self.faults[node, request], "as the kernel says it")
        if request == QUERYCAP:
            assert len(buffer) == 104
            struct.pack_into(
                "16s32s32sIII", buffer, 0, b"uvcvideo", b"card", b"usb-1", 0x60800, OF_NODE | CAPTURE | META | STREAMING, self.capabilities[node]
            )
        else:
            assert request == REQBUFS
            count, kind, memory = struct.unpack_from("III", buffer)
            assert (count, kind, memory) == (0, 1, 1)


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


def test_cameras_have_stable_names_and_their_other_nodes_are_left_out(machine: Machine) -> None:
    machine.plug_in("video0", "HD Pro Webcam C920", by_id="usb-046d_HD_Pro_Webcam_C920_1234-video-index0", by_path="pci-0-usb-0:1:1.0-video-index0")
    machine.plug_in("video1", "HD Pro Webcam C920", META | STREAMING, by_id="usb-046d_HD_Pro_Webcam_C920_1234-video-index1")
    machine.plug_in("video2", "Twin", by_id="usb-Twin-video-index0", by_path="pci-0-usb-0:2:1.0-video-index0")
    machine.plug_in("video10", "Twin", by_path="pci-0-usb-0:3:1.0-video-index0")  # its name of by-id is the first twin's
    machine.plug_in("video3", "Built in")
    found = machine.nodes.list()
    assert [(node.path.name, node.id, node.description) for node in found] == [
        ("video0", "usb-046d_HD_Pro_Webcam_C920_1234-video-index0", "HD Pro Webcam C920"),
        ("video2", "usb-Twin-video-index0", "Twin"),
        ("video3", str(machine.root / "dev/video3"), "Built in"),
        ("video10", "pci-0-usb-0:3:1.0-video-index0", "Twin"),
    ]
    for node in found:
        assert machine.nodes.resolve(node.id).resolve() == node.path


def test_a_camera_that_cannot_be_asked_is_listed_all_the_same(machine: Machine) -> None:
    machine.plug_in("video0", "Webcam", by_id="usb-Webcam-video-index0")
    machine.faults["video0", QUERYCAP] = errno.EACCES
    assert [node.id for node in machine.nodes.list()] == ["usb-Webcam-video-index0"]


@pytest.mark.parametrize(
    ("request_code", "fault", "access"),
    [
        (REQBUFS, errno.EBUSY, Access.BUSY),
        (QUERYCAP, errno.EBUSY, Access.BUSY),
        (QUERYCAP, errno.EACCES, Access.NOT_PERMITTED),
        (QUERYCAP, errno.ENODEV, Access.GONE),
        (QUERYCAP, errno.ENOTTY, Access.NO_CAMERA),
        (QUERYCAP, errno.EIO, Access.FAULTY),
    ],
)
def test_what_keeps_a_program_from_a_camera(machine: Machine, request_code: int, fault: int, access: Access) -> None:
    path = machine.plug_in("video0", "Webcam")
    assert machine.nodes.access(path) is Access.FREE
    machine.faults["video0", request_code] = fault
    assert machine.nodes.access(path) is access


def test_a_node_that_is_not_there_is_gone_and_no_file_is_a_camera(tmp_path: Path) -> None:
    nodes = VideoNodes(tmp_path)
    assert nodes.list() == []
    assert nodes.access(nodes.resolve("usb-nothing")) is Access.GONE
    (tmp_path / "plain").touch()
    assert nodes.access(tmp_path / "plain") is Access.NO_CAMERA  # by the real ioctl


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may open everything")
def test_a_node_of_another_user_is_not_permitted(tmp_path: Path) -> None:
    (tmp_path / "video0").touch(0o000)
    assert VideoNodes(tmp_path).access(tmp_path / "video0") is Access.NOT_PERMITTED
