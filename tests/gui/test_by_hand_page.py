"""A person shows the board to a real rig: what is asked before, what the page says meanwhile, and where the result is kept."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.controllers.calibration import ByHand
from app.settings import Settings
from app.views.board_watch_view import BoardWatchView
from app.views.board_words import now_text
from app.views.by_hand_panel import ByHandPanel
from scanner_core.devices.rig import load_rig
from scanner_core.optics.board_view import BoardMissReason
from scanner_core.optics.board_watch import CameraSighting, Phase, ViewVerdict, Wish, WishKind
from tests.gui.rig_window import RigWindow
from tests.gui.shown_by_hand import COMMENT, Hands, write_rig
from tests.gui.test_calibration_page import board_look
from tests.gui.waiting import until

NOTHING, DARK, CUT = (CameraSighting(0, reason) for reason in (BoardMissReason.NO_BOARD, BoardMissReason.TOO_DARK, BoardMissReason.CUT))
FEW_MORE = (Wish(WishKind.MORE_VIEWS, count=3),)


@pytest.fixture
def window(application: QApplication, tmp_path: Path) -> Iterator[RigWindow]:
    made = RigWindow(tmp_path)
    yield made
    made.close()


@pytest.mark.parametrize(
    ("look", "words"),
    [
        ({"verdict": ViewVerdict.TAKEN}, "View 7 taken. Now tilt it another way."),
        ({"verdict": ViewVerdict.MOVING}, "Hold the board still."),
        ({"verdict": ViewVerdict.TOO_SIMILAR}, "Tilt the board more, each time to another side"),
        (
            {"verdict": ViewVerdict.TOO_SIMILAR, "wishes": FEW_MORE},
            "Too similar to an earlier view: move or tilt the board.",
        ),
        ({"verdict": ViewVerdict.MISSED, "left": NOTHING, "right": NOTHING}, "Hold the board into the volume"),
        (
            {"verdict": ViewVerdict.ONE_CAMERA, "right": CUT},
            "Cut by the picture's edge in the right camera's picture",
        ),
        (
            {
                "verdict": ViewVerdict.MISSED,
                "left": DARK,
                "right": DARK,
            },
            "Too dark",
        ),
        ({"verdict": ViewVerdict.TOO_SIMILAR, "phase": Phase.TABLE, "index": 0}, "Lay the board on the table"),
        ({"verdict": ViewVerdict.MOVING, "phase": Phase.TABLE, "index": 3}, "Take your hands away."),
    ],
)
def test_one_sentence_says_what_to_do_now(look: dict[str, object], words: str) -> None:
    assert now_text(board_look(**look).watch) == words


def test_it_is_large_and_stays_long_enough_to_be_read(application: QApplication) -> None:
    view = BoardWatchView()
    view.resize(590, 746)
    view.clear(by_hand=True)
    view.show()
    view.show_look(board_look(verdict=ViewVerdict.TAKEN))
    assert view.now.startswith("View 7 taken")
    assert view._now.property("role") == "large-good"
    view.show_look(board_look(verdict=ViewVerdict.MOVING))
    assert view.now.startswith("View 7 taken"), "read from where the board is held"
    view.show_look(board_look(verdict=ViewVerdict.TAKEN, index=7))
    assert view.now.startswith("View 8 taken"), "that must not wait"
    view.close()


def test_the_known_length_is_asked_for_and_remembered(application: QApplication) -> None:
    asked: list[ByHand] = []
    settings = Settings(length_kind="print", print_width_mm=224.6)
    panel = ByHandPanel(settings, asked.append, lambda: None)
    assert not panel.bar_mm.isEnabled()
    panel.thickness_mm.setValue(3.2)
    panel._begin.click()
    panel.kinds["bar"].setChecked(True)
    panel.bar_mm.setValue(149.998)
    panel._begin.click()
    panel.kinds["none"].setChecked(True)
    panel._begin.click()
    assert asked == [ByHand(None, 224.6, 3.2), ByHand(149.998, None, 3.2), ByHand(None, None, 3.2)]
    assert (settings.length_kind, settings.length_mm, settings.board_thickness_mm) == ("none", 149.998, 3.2)


@pytest.mark.long
def test_a_person_is_led_through_it_by_the_large_sentence(window: RigWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hands = Hands()
    hands.stand_in(monkeypatch, views=8, bar_views=4, table_angles=6)
    path = write_rig(tmp_path / "lab.toml")
    before = load_rig(path).calibration
    window.open(path)
    page = window.page
    assert window.rig.snapshot.connected
    QTest.mouseClick(window.button("Calibrate"), Qt.MouseButton.LeftButton)
    assert page.by_hand.isVisible()
    QTest.mouseClick(page.by_hand._begin, Qt.MouseButton.LeftButton)
    assert page.board.isVisible()

    def over() -> bool:
        hands.obey(page.board)
        return window.rig.snapshot.calibrating is None

    until(over, 180, "the end")
    assert window.rig.snapshot.refused is None, window.rig.snapshot.refused
    until(lambda: page.calibration.state.startswith("Accepted"), 10, "accepted")
    until(lambda: load_rig(path).calibration != before, 10, "kept")
    kept, used = load_rig(path).calibration, window.rig.snapshot.calibration
    assert kept is not None
    assert used is not None
    assert kept.identity() == used.identity()
    assert kept.scale is not None
    assert kept.scale.verified
    assert path.read_text(encoding="utf-8").startswith(f"{COMMENT}\n"), "all else stays as it was written"
