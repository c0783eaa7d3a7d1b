"""What to do where nothing is being measured: of every device's fault, and about nothing that is not there."""

from __future__ import annotations

from string import Formatter

import pytest

from scanner_core.errors import DeviceError
from scanner_core.remedies import REMEDIES, remedy_of
from scanner_core.sentences import SENTENCES

RECORDING = "E-CAM-22"
"""Happens to measurements only."""


def _fields(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_no_fault_of_a_device_speaks_of_points_that_nobody_measured() -> None:
    said = {code for code, sentence in SENTENCES.items() if code.startswith(("E-CAM", "E-MOT")) and "points so far" in sentence.do}
    assert said - set(REMEDIES) == {RECORDING}
    assert not any("points" in remedy or "resume" in remedy for remedy in REMEDIES.values())


@pytest.mark.parametrize("code", sorted(REMEDIES))
def test_it_knows_the_fields_of_its_sentence(code: str) -> None:
    sentence = SENTENCES[code]
    fields = _fields(sentence.what) | _fields(sentence.do)
    assert _fields(REMEDIES[code]) <= fields
    error = DeviceError(code, **dict.fromkeys(fields, "x"))
    assert remedy_of(error) != error.hint


def test_what_has_none_keeps_its_own() -> None:
    error = DeviceError("E-MOT-03", port="COM3")
    assert remedy_of(error) == error.hint
