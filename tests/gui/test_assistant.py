"""The rig assistant: what is found and chosen, checked and corrected, and written."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers.assistant import AssistantController
from app.controllers.assistant_choice import VIRTUAL_PORT, DeviceChoice, first_choice
from app.controllers.assistant_snapshot import AssistantSnapshot, Job
from app.controllers.emission import Emission
from app.program import Program
from app.theme import look
from app.views import assistant_words, check_names
from app.views.assistant_corrections import Corrections, corrections_of, only
from app.views.assistant_page import CHECK, FIND, WRITE, AssistantPage
from app.views.file_dialogs import FileDialog
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.clock import make_clock
from scanner_core.commissioning import found_devices, rig_check
from scanner_core.commissioning.rig_check import RigCheck
from scanner_core.commissioning.rig_findings import AxisFinding, CameraFinding, RigFindings
from scanner_core.devices.check import Check
from scanner_core.devices.discovery import PortAnswer, PortState, SerialPort, ask_ports
from scanner_core.devices.found_camera import CameraState, FoundCamera
from scanner_core.devices.rig import load_preset, load_rig
from scanner_core.errors import DeviceBusyError, DeviceError, ImprontaError
from tests.core.devices.boards import remote_board
from tests.core.devices.mjpeg_server import MjpegServer
from tests.gui.pictures import near, pixels_of
from tests.gui.test_texts import texts_of
from tests.gui.waiting import until, wait_ms

GREY = np.full((90, 160), 120, np.uint8)
A, B, C = ("opencv", "a"), ("opencv", "b"), ("opencv", "c")


def _port(url: str, state: PortState, error: DeviceError | None = None) -> PortAnswer:
    return PortAnswer(SerialPort(url, "a board"), state, None, error)


def _camera(id: str, state: CameraState = CameraState.READY, error: DeviceError | None = None) -> FoundCamera:
    return FoundCamera("opencv", id, f"Camera {id}", state, error, None, GREY if state is CameraState.READY else None)


# ------------------------------------------------------------------------------------------ choosing
def test_a_camera_that_takes_the_others_side_changes_places_with_it() -> None:
    choice = DeviceChoice("/dev/ttyUSB0", A, B)
    assert (choice.with_camera("left", B).left, choice.with_camera("left", B).right) == (B, A)
    assert choice.with_camera("left", C) == replace(choice, left=C)
    assert choice.exchanged().exchanged() == choice
    assert (choice.exchanged().left, choice.exchanged().right) == (B, A)


def test_clicks_on_pictures_fill_left_then_right_and_take_back() -> None:
    choice = DeviceChoice("/dev/ttyUSB0").next_click(A)
    assert (choice.left, choice.right) == (A, None)
    choice = choice.next_click(B)
    assert (choice.left, choice.right) == (A, B)
    assert choice.next_click(A).left is None


def test_virtual_and_real_devices_do_not_make_a_rig_together() -> None:
    virtual = DeviceChoice("/dev/ttyUSB0", A, B).with_port(VIRTUAL_PORT)
    assert virtual.complete
    assert {virtual.left, virtual.right} == {("virtual", "virtual:left"), ("virtual", "virtual:right")}
    assert virtual.exchanged() == virtual
    real = virtual.with_port("/dev/ttyUSB0")
    assert (real.port, real.left, real.right) == ("/dev/ttyUSB0", None, None)
    one = virtual.with_camera("right", A)
    assert (one.port, one.left, one.right) == ("", None, A)
    assert real.with_camera("right", ("virtual", "virtual:left")) == virtual


def test_where_there_is_one_way_to_choose_it_is_chosen() -> None:
    ports = [_port("/dev/ttyUSB0", PortState.CONTROLLER), _port("/dev/ttyS0", PortState.SILENT), _port(VIRTUAL_PORT, PortState.CONTROLLER)]
    cameras = [_camera("a"), _camera("b"), _camera("c", CameraState.IN_USE), FoundCamera("virtual", "virtual:left", "", CameraState.READY)]
    assert first_choice(ports, cameras, DeviceChoice()) == DeviceChoice("/dev/ttyUSB0", A, B)
    assert first_choice(ports, cameras, DeviceChoice("/dev/ttyUSB7", B, A)) == DeviceChoice("/dev/ttyUSB0", B, A)
    third = first_choice(ports, [*cameras[:2], _camera("c")], DeviceChoice())
    assert (third.left, third.right) == (None, None)


def test_every_state_has_a_word_of_its_own() -> None:
    assert set(assistant_words._PORTS) == set(PortState)
    assert set(assistant_words._CAMERAS) == set(CameraState)
    assert len({word for _, word in assistant_words._PORTS.values()}) == len(PortState)
    assert len({word for _, word in assistant_words._CAMERAS.values()}) == len(CameraState)


def test_every_check_and_every_step_has_a_name_to_translate() -> None:
    assert set(check_names.NAMES) == {*rig_check.LINES, *rig_check.STEPS, "done"}
    assert check_names.check_name("left and right") == "Left and right"


# ------------------------------------------------------------------------------------------ correcting
TURNED = RigFindings(
    cameras={"left": CameraFinding(exposure_ms=7.5, gain_db=2.0), "right": CameraFinding()},
    axes={"x": AxisFinding("x", -1), "y": AxisFinding("y", 1, 1.001, 0.01), "table": AxisFinding("table", 1, 0.5, 0.01)},
)


def test_what_is_to_be_corrected_is_said_and_nothing_else() -> None:
    told = corrections_of(load_preset("bench"), TURNED)
    assert set(told) == {"x", "table", "exposure"}
    assert "other way" in told["x"]
    assert "50 %" in told["table"]
    assert "both cameras for 7.5 ms (left 2 dB, right 4.1 dB)" in told["exposure"]
    assert corrections_of(load_preset("bench"), only(TURNED, set())) == {}


def test_only_what_is_ticked_is_corrected(application: QApplication) -> None:
    taken: list[RigFindings] = []
    panel = Corrections(taken.append)
    panel.show_findings(load_preset("bench"), TURNED)
    panel.boxes["table"].setChecked(False)
    panel.do.click()
    assert set(taken[0].axes) == {"x"}
    assert set(taken[0].cameras) == {"left", "right"}
    for box in panel.boxes.values():
        box.setChecked(False)
    assert not panel.do.isEnabled()
    panel.show_findings(load_preset("bench"), None)
    assert panel.isHidden()


# ------------------------------------------------------------------------------------------ in the window
@pytest.fixture
def page(module_program: Program) -> Iterator[AssistantPage]:
    window = module_program.window
    until(lambda: module_program.services.rig.snapshot.connected and module_program.services.rig.snapshot.calibrating is None, 120, "the rig")
    shown = window.pages["assistant"]
    assert isinstance(shown, AssistantPage)
    window.actions_by_id["set_up_rig"].trigger()
    assert window.page_id == "assistant"
    shown.go_to(FIND)
    yield shown
    window.show_page("home")
    until(lambda: not module_program.services.assistant.holds_devices, 60, "the devices given back")
    until(lambda: module_program.services.rig.snapshot.connected, 120, "the rig of the program")
    module_program.services.assistant.snapshot = AssistantSnapshot()
    window.banner.dismiss()


def _assistant(program: Program) -> AssistantController:
    return program.services.assistant


def _finds(monkeypatch: pytest.MonkeyPatch, ports: list[Callable[[], PortAnswer]], cameras: list[FoundCamera]) -> None:
    """What this machine has."""
    answers = {str(number): ask for number, ask in enumerate(ports)}
    monkeypatch.setattr(found_devices, "serial_ports", lambda: [SerialPort(name, "") for name in answers])
    monkeypatch.setattr(found_devices, "ask_ports", lambda asked, clock, **_: [answers[asked[0].url]()])
    monkeypatch.setattr(found_devices, "find_cameras", lambda: cameras)


def _look(page: AssistantPage, program: Program) -> AssistantSnapshot:
    page.search.click()
    until(lambda: not _assistant(program).snapshot.busy, 60, "the end of the search")
    return _assistant(program).snapshot


def _try_virtual(page: AssistantPage, program: Program) -> None:
    _look(page, program)
    page.finding.use_virtual.click()
    assert page.next.isEnabled()
    page.next.click()
    assert page.step == CHECK


def test_with_no_device_a_sentence_says_so_and_the_virtual_rig_is_offered(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    _finds(monkeypatch, [], [])
    snapshot = _look(page, module_program)
    assert [answer.port.url for answer in snapshot.ports] == [VIRTUAL_PORT]
    texts = " ".join(texts_of(page))
    assert "No serial port was found" in texts
    assert "No camera was found" in texts
    assert not page.next.isEnabled()
    assert page.finding.use_virtual.isVisible()
    assert [card.thumbnail.has_picture for card in page.finding.cards] == [True, True]
    page.finding.use_virtual.click()
    assert [card.thumbnail.word for card in page.finding.cards] == ["Left", "Right"]
    assert page.next.isEnabled()


def test_every_port_and_camera_says_what_it_is_and_what_to_do(module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch) -> None:
    busy = DeviceBusyError("E-MOT-03", port="/dev/ttyUSB1")
    other = DeviceError("E-MOT-07", port="/dev/ttyACM0", said="hello")
    held = DeviceBusyError("E-CAM-05", camera="b", id="b")
    ports = [_port("/dev/ttyUSB1", PortState.BUSY, busy), _port("/dev/ttyACM0", PortState.OTHER, other)]
    _finds(monkeypatch, [lambda: ports[0], lambda: ports[1]], [_camera("a"), _camera("b", CameraState.IN_USE, held)])
    monkeypatch.setattr("scanner_core.devices.camera_drivers.open_camera", _no_camera)
    _look(page, module_program)
    texts = " ".join(texts_of(page))
    for part in ("used by another program", "close the other program", "it said: hello", "The rig needs two cameras", "None of these ports"):
        assert part in texts, part
    usable = {line.answer.port.url: line.choice.isEnabled() for line in page.finding.ports.lines}
    assert usable == {"/dev/ttyUSB1": False, "/dev/ttyACM0": False, VIRTUAL_PORT: True}
    assert [card.thumbnail.isEnabled() for card in page.finding.cards] == [True, False, True, True]
    page.finding.cards[0].thumbnail.setFocus()
    QTest.keyClick(page.finding.cards[0].thumbnail, Qt.Key.Key_Space)
    assert _assistant(module_program).snapshot.choice.left == A
    assert "a controller, the right camera" in " ".join(texts_of(page))


def _no_camera(*_: object) -> Any:
    raise DeviceError("E-CAM-10", camera="left", id="a", reason="it is a test")


def test_a_board_and_two_streams_make_a_rig_and_their_pictures_live(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    def picture(number: int) -> np.ndarray:
        image = np.full((96, 128), 40, np.uint8)
        image[:, : 8 * (number % 16)] = 200
        return image

    with remote_board() as board, MjpegServer(picture, 15.0) as left, MjpegServer(picture, 15.0) as right:
        first, second = sorted((left.url, right.url))
        streams = [FoundCamera("opencv", url, "A stream", CameraState.READY, None, None, GREY) for url in (first, second)]
        _finds(monkeypatch, [lambda: ask_ports([SerialPort(board.url, "a board")], make_clock(1.0))[0]], streams)
        snapshot = _look(page, module_program)
        assert snapshot.choice == DeviceChoice(board.url, ("opencv", first), ("opencv", second))
        card = page.finding.cards[0]
        before = pixels_of(card.thumbnail).copy()
        until(lambda: (pixels_of(card.thumbnail) != before).any(), 20, "a picture that moves")
        page.finding.exchange.click()
        assert _assistant(module_program).snapshot.choice.left == ("opencv", second)
        page.finding.settings.exposure_ms.setValue(4.0)
        page.go_to(WRITE)
        until(lambda: page.writing.text.toPlainText(), 20, "the text")
        text = page.writing.text.toPlainText()
        assert board.url in text
        assert text.count("exposure_ms = 4.0") == 2
        assert text.index(second) < text.index(first)
        module_program.window.show_page("home")  # before the streams end
        until(lambda: not _assistant(module_program).holds_devices, 30, "the devices given back")


def _quick_check(rig: OpenRig, *, on_check: Callable[[RigCheck], None], **_: object) -> RigFindings:
    """As a check of a rig whose beam X goes the wrong way ends."""
    for camera in (rig.left, rig.right):
        camera.grab()
    names = [f"{side} {kind}" for side in ("left", "right") for kind in ("dark", "lit", "difference")]
    places = {name: (40.0, 30.0) for name in names if "dark" not in name}
    on_check(RigCheck(Check("laser seen", "pass", "seen by both."), dict.fromkeys(names, GREY), spots_px=places))
    on_check(RigCheck(Check("beam axis x", "fail", "the spot moves the wrong way.", "Turn it round.")))
    return RigFindings(axes={"x": AxisFinding("x", -1)})


@pytest.mark.parametrize("real", [False, pytest.param(True, marks=pytest.mark.long)])
def test_the_whole_way_on_a_virtual_rig_whose_beam_goes_the_wrong_way(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch, real: bool
) -> None:
    _finds(monkeypatch, [], [])
    if not real:
        monkeypatch.setattr("scanner_core.commissioning.rig_check.check_rig", _quick_check)
    _try_virtual(page, module_program)
    checking, assistant = page.checking, _assistant(module_program)
    bench = load_preset("bench")
    wrong = replace(bench, controller=replace(bench.controller, units_per_deg=(-1.0, 1.0, 1.0)))
    monkeypatch.setattr("app.controllers.assistant.config_of", lambda _: wrong)
    assert not checking.start.isEnabled()
    checking.agreed.click()
    checking.start.click()
    until(lambda: not assistant.snapshot.busy, 180, "the check")
    assert assistant.snapshot.failed is None
    assert len(checking.lines) == len(assistant.snapshot.checks) >= (11 if real else 2)
    until(lambda: assistant.emission is Emission.DARK, 10, "dark")
    seen = next(line for line in checking.lines if line.made.check.name == "laser seen")
    if checking.pictures.check is not seen.made:  # the newest pictures are shown by themselves
        seen.pictures.click()
    shown = checking.pictures.shown
    assert len(shown) == 6
    assert shown["left dark"].mark_px is None
    assert shown["left difference"].mark_px is not None
    assert near(pixels_of(shown["left difference"]), look.accent, 40).sum() > 20
    assert "Beam axis x" in checking.summary.text()
    assert {"x"} <= set(checking.corrections.boxes) <= {"x", "left", "right"}
    checked: list[tuple[float, float, float]] = []

    def check_again(rig: OpenRig, **_: object) -> RigFindings:
        checked.append(rig.config.controller.units_per_deg)
        return RigFindings()

    monkeypatch.setattr("scanner_core.commissioning.rig_check.check_rig", check_again)
    checking.corrections.do.click()
    until(lambda: checked and not assistant.snapshot.busy, 60, "the second check")
    assert checked == [(1.0, 1.0, 1.0)]
    assert checking.corrections.isHidden()
    page.next.click()
    assert page.step == WRITE
    writing = page.writing
    writing.name.setText("bench of mine")
    until(lambda: 'name = "bench of mine"' in writing.text.toPlainText(), 10, "the text")
    assert writing.path.name == "bench-of-mine.toml"
    writing.save.click()
    until(lambda: assistant.snapshot.written is not None, 10, "the file")
    written = load_rig(writing.path)
    assert (written.name, written.virtual, written.controller.units_per_deg) == ("bench of mine", "bench", (1.0, 1.0, 1.0))
    writing.use_now.click()
    assert module_program.window.page_id == "rig"
    rig = module_program.services.rig
    until(lambda: rig.snapshot.connected and rig.snapshot.preset == str(writing.path), 60, "the rig in use")
    rig.choose(preset="bench")


def test_a_file_that_is_there_is_replaced_only_when_asked_twice(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    page.go_to(WRITE)
    writing, assistant = page.writing, _assistant(module_program)
    writing.name.setText("taken")
    until(lambda: 'name = "taken"' in writing.text.toPlainText(), 10, "the text")
    writing.path.parent.mkdir(parents=True, exist_ok=True)
    writing.path.write_text("mine")
    writing.save.click()
    until(lambda: "already" in writing._told.text(), 10, "the question")
    assert writing.path.read_text() == "mine"
    writing.name.setText("taken too")
    assert writing._told.isHidden()
    writing.name.setText("taken")
    writing.save.click()
    until(lambda: "already" in writing._told.text(), 10, "the question again")
    writing.save.click()
    until(lambda: assistant.snapshot.written is not None, 10, "the file")
    assert load_rig(writing.path).name == "taken"


def test_moving_by_hand_and_a_spot_that_escape_turns_off(module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch) -> None:
    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    checking, assistant, window = page.checking, _assistant(module_program), module_program.window
    assert not checking.jog.arrows["x", 1].isEnabled()
    checking.agreed.click()
    checking.open.click()
    until(lambda: assistant.snapshot.opened and not assistant.snapshot.busy, 30, "the rig")
    rig = assistant._devices.rig
    assert rig is not None
    checking.jog.steps[5.0].click()
    checking.jog.arrows["x", 1].click()
    checking.jog.arrows["table", -1].click()
    until(lambda: rig.motion.newest is not None and abs(rig.motion.newest.table_deg + 5.0) < 0.1, 20, "the table")
    assert abs(rig.motion.newest.x_deg - 5.0) < 0.1
    checking.jog.spot.click()
    until(lambda: assistant.emission is Emission.LIT, 20, "the spot")
    until(lambda: window.laser.emission is Emission.LIT, 5, "the window says so")
    views = checking.pictures.live.values()
    until(lambda: all(view.spot is not None or view._miss for view in views), 10, "the spot's size to focus by, or that there is none")
    rig.motion.laser(False)  # as it goes out by itself after a minute
    until(lambda: not checking.jog.spot.isChecked(), 10, "the switch follows")
    checking.jog.spot.click()
    until(lambda: assistant.emission is Emission.LIT, 20, "the spot again")
    QTest.keyClick(window, Qt.Key.Key_Escape)
    until(lambda: assistant.emission is Emission.DARK, 10, "dark")
    until(lambda: all(view.spot is None and not view._miss for view in views), 10, "nobody looks for it any more")
    assert not checking.jog.spot.isChecked()
    wait_ms(400)
    checking.jog.arrows["table", 1].click()
    until(lambda: rig.motion.newest is not None and abs(rig.motion.newest.table_deg) < 0.1, 20, "the table moves again")
    assert not window.banner.text, window.banner.details


@pytest.mark.parametrize("way", ["key", "cancel"])
def test_a_check_ends_dark_whoever_stops_it(module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch, way: str) -> None:
    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    checking, assistant, window = page.checking, _assistant(module_program), module_program.window
    checking.agreed.click()
    checking.start.click()
    until(lambda: assistant.snapshot.checks, 60, "the first line")
    if way == "key":
        QTest.keyClick(window, Qt.Key.Key_Escape)
    else:
        checking.cancel.click()
    until(lambda: not assistant.snapshot.busy, 20, "the end of the check")
    assert assistant.snapshot.findings is None
    until(lambda: assistant.emission is Emission.DARK, 10, "dark")
    assert checking.start.isEnabled()


def test_leaving_gives_the_devices_back_and_the_next_visit_asks_for_protection_anew(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    assistant, rig = _assistant(module_program), module_program.services.rig
    assert not rig.snapshot.connected
    page.checking.agreed.click()
    page.checking.start.click()
    until(lambda: assistant.snapshot.checks, 60, "the first line")
    module_program.window.show_page("home")
    until(lambda: rig.snapshot.connected, 60, "the program's own rig")
    assert not assistant.holds_devices
    assert assistant.snapshot.running is Job.NONE
    assert assistant._devices.rig is None
    module_program.window.set_up_rig()
    assert not page.checking.agreed.isChecked()


def test_a_rig_that_does_not_open_says_why(module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> Any:
        raise DeviceBusyError("E-MOT-03", port="/dev/ttyUSB0")

    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    monkeypatch.setattr("scanner_core.acquisition.rig_session.open_rig", fails)
    page.checking.agreed.click()
    page.checking.start.click()
    until(lambda: _assistant(module_program).snapshot.failed is not None, 20, "the fault")
    failed = _assistant(module_program).snapshot.failed
    assert isinstance(failed, ImprontaError)
    assert "The port /dev/ttyUSB0 is used by another program." in " ".join(texts_of(page.checking))
    assert page.checking.start.isEnabled()


def test_another_file_may_be_chosen_in_a_dialog_that_the_stop_key_reaches(
    module_program: Program, page: AssistantPage, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    _finds(monkeypatch, [], [])
    _try_virtual(page, module_program)
    page.go_to(WRITE)
    page.writing.browse.click()
    until(lambda: module_program.window.findChildren(FileDialog), 10, "the dialog")
    dialog = module_program.window.findChildren(FileDialog)[-1]
    dialog.selectFile(str(tmp_path / "other.toml"))
    dialog.accept()
    assert page.writing.path == tmp_path / "other.toml"
