from __future__ import annotations

import string
import threading

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from app.faults import details_of, sentence_of, unmeasured_words
from app.program import Program
from app.views.banner import Banner
from scanner_core.errors import CaseLockedError, ImprontaError
from scanner_core.sentences import SENTENCES
from tests.gui.waiting import until


@pytest.mark.parametrize("code", SENTENCES)
def test_every_code_makes_a_sentence_with_its_fields(code: str) -> None:
    sentence = SENTENCES[code]
    names = {name for part in (sentence.what, sentence.do) for _, name, _, _ in string.Formatter().parse(part) if name}
    what, do = sentence_of(ImprontaError(code, **{name: f"<{name}>" for name in names}))
    assert all(f"<{name}>" in what + do for name in names)
    assert what.strip()
    assert do.strip()


def test_while_nothing_is_measured_nothing_is_said_of_points_and_rig_files() -> None:
    gone = ImprontaError("E-MOT-08", port="COM3")
    assert "rig file" in " ".join(sentence_of(gone))
    assert unmeasured_words(gone) == f"{gone.message} Nothing was moved; plug the controller in again, then try again."
    taken = ImprontaError("E-MOT-03", port="COM3")
    assert unmeasured_words(taken) == " ".join(sentence_of(taken))
    assert "details help us" in unmeasured_words(ValueError())


def test_the_newest_sentence_stands_and_the_details_of_the_one_before_stay(application: QApplication) -> None:
    banner = Banner()
    assert banner.text == ""
    banner.tell_fault(CaseLockedError("E-CASE-02", path="a.impronta", details="database is locked"))
    assert banner.text == "a.impronta is open in another window or program. Nothing was changed; close it there, or choose another case."
    banner.tell_fault(ValueError("second"))
    assert "ValueError" in banner.text
    assert "E-CASE-02" in banner.details
    assert "database is locked" in banner.details
    banner.dismiss()
    assert banner.text == ""


def test_the_details_hold_code_and_traceback() -> None:
    try:
        raise CaseLockedError("E-CASE-02", path="x", details="locked by 17")
    except CaseLockedError as fault:
        text = details_of(fault)
    assert "E-CASE-02" in text
    assert "locked by 17" in text
    assert "Traceback" in text


def test_a_fault_in_a_slot_and_one_in_a_thread_end_in_the_same_banner(program: Program) -> None:
    banner = program.window.banner

    def fail_in_slot() -> None:
        raise ZeroDivisionError("slot")

    QTimer.singleShot(0, fail_in_slot)
    until(lambda: "ZeroDivisionError" in banner.text)

    def fail_in_thread() -> None:
        raise KeyError("thread")

    thread = threading.Thread(target=fail_in_thread, name="failing")
    thread.start()
    thread.join()
    until(lambda: "KeyError" in banner.text)
    assert "slot" in banner.details
