"""A few hundred damaged files for every reader, with the harnesses and rules of the long runs."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.fuzz.corpus import dictionary, samples
from tests.fuzz.damage import damaged_files
from tests.fuzz.readers import READERS, REFUSALS

EXAMPLES = {"case": 60, "case-values": 60, "rig": 60}
"""Of those that take longest; the others 150."""


@pytest.mark.parametrize("reader", READERS)
def test_good_files_are_read(reader: str) -> None:
    if reader != "case-values":  # its inputs are damage
        for content in samples(reader):
            READERS[reader](content)


@pytest.mark.parametrize("reader", READERS)
def test_damaged_files_are_read_or_refused(reader: str, capfd: pytest.CaptureFixture[str]) -> None:
    @settings(max_examples=EXAMPLES.get(reader, 150))
    @given(damaged_files(samples(reader), dictionary(reader)))
    def one(content: bytes) -> None:
        said = ""
        try:
            READERS[reader](content)
        except REFUSALS as refusal:
            said = str(refusal)
        assert said.isprintable()

    one()
    assert capfd.readouterr() == ("", "")


@settings(max_examples=100)
@given(st.binary(max_size=300))
def test_noise_is_read_or_refused(content: bytes) -> None:
    for reader in READERS:
        if not reader.startswith("case"):
            try:
                READERS[reader](content)
            except REFUSALS:
                continue
