"""Every port is asked, and each answer is a value."""

from __future__ import annotations

from scanner_core.devices.discovery import PortState, SerialPort, ask_ports, serial_ports
from tests.core.devices.boards import board


def test_each_kind_of_port_is_told_apart() -> None:
    with (
        board("usable") as usable,
        board("cutter", laser_mode=False) as cutter,
        board("taken") as taken,
        board("dead", resets_on_connect=False) as dead,
        taken.open(),
    ):
        dead.firmware.freeze()
        answers = {}
        for here, name in ((usable, "usable"), (cutter, "cutter"), (taken, "taken"), (dead, "dead"), (usable, "nowhere")):
            port = SerialPort(f"virtual://{name}", "a board")
            answers[name] = ask_ports([port], here.clock)[0]
        assert {name: answer.state for name, answer in answers.items()} == {
            "usable": PortState.CONTROLLER,
            "cutter": PortState.UNSUITABLE,
            "taken": PortState.BUSY,
            "dead": PortState.SILENT,
            "nowhere": PortState.GONE,
        }
        identity, error = answers["usable"].identity, answers["dead"].error
        assert identity is not None
        assert identity.laser_mode
        assert error is not None
        assert error.code == "E-MOT-24"
        usable.open().close()  # the port was released


def test_listing_opens_nothing() -> None:
    assert all(port.url for port in serial_ports())
