from __future__ import annotations

import json
import unicodedata
from urllib.parse import quote

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.support.private_names import Mark, PrivateName, file_names, order_names
from scanner_core.support.redaction import Redactor

# letters of several scripts, spaces, and what file names and JSON treat in their own way
NAMES = st.text(st.sampled_from("AbcdßéÜñøŁж日本 -_.'\"&%\\/"), min_size=3, max_size=24).filter(lambda text: len(text.strip()) >= 3)
AROUND = st.text(st.sampled_from("xyz 0123\n:/=\\[]{}\"'"), max_size=30)


@settings(max_examples=50)
@given(name=NAMES, before=AROUND, after=AROUND)
def test_a_name_is_found_however_it_is_written(name: str, before: str, after: str) -> None:
    name = name.strip()
    redact = Redactor([PrivateName(name, Mark.PATIENT)])
    for form in ("NFC", "NFD"):
        text = unicodedata.normalize(form, name)
        for written in (text, text.upper(), json.dumps(text)[1:-1], quote(text, safe=""), ascii(text)[1:-1]):
            if len(text) >= 5:
                assert written not in redact(before + written + after)
            assert written not in redact(f"{before} {written} {after}")


def test_a_short_name_is_a_whole_word() -> None:
    redact = Redactor(order_names(number="142"))
    assert redact("order 142 and 142_left, 1142 steps, S1420") == "order [order] and [order]_left, 1142 steps, S1420"


def test_the_words_of_a_patient_count_and_those_of_the_remarks_as_lines() -> None:
    redact = Redactor(order_names("A/77-1", "Müller, Anna Maria", "weint leicht\nlinkes Ohr"))
    assert redact("anna MARIA M\u00fcller: linkes Ohr; Ohr") == "[patient] [patient] [patient]: [notes]; Ohr"
    assert redact("A-77-1_left.stl") == "[file].stl"


@pytest.mark.parametrize(
    ("text", "clean"),
    [
        ("/Users/anna/Ohr links/case 1.impronta is open in another window", "[file].impronta is open in another window"),
        ("No such file: '/media/stick/Meyer Anna/ear.stl'", "No such file: '[file].stl'"),
        ("rel/Meyer/ear.ply is gone", "[file].ply is gone"),
        ('"C:\\\\Users\\\\Anna M\\\\Documents\\\\p.stl"', '"[file].stl"'),
        ("C:\\Users\\anna\\AppData", "C:\\Users\\[user]\\AppData"),
        ("in /Users/anna/work", "in /Users/[user]/work"),
        ("rtsp://anna:secret@10.0.0.7/left", "rtsp://[login]@10.0.0.7/left"),
        ("write to anna.meyer@lab.example now", "write to [mail] now"),
        ("/dev/serial/by-id/usb-1a86_USB_Serial-if00-port0 opened", "/dev/serial/by-id/usb-1a86_USB_Serial-if00-port0 opened"),
        ("<Idle|MPos:0.000,0.000,0.000|FS:0,0> [VER:1.1h.20190825:]", "<Idle|MPos:0.000,0.000,0.000|FS:0,0> [VER:1.1h.20190825:]"),
        ("$110=500.000 $32=1 G1X10.5Y-3F600S1000", "$110=500.000 $32=1 G1X10.5Y-3F600S1000"),
    ],
)
def test_paths_of_the_users_own_go_and_what_helps_stays(text: str, clean: str) -> None:
    assert Redactor()(text) == clean


def test_the_programs_own_files_are_told_by_their_place_in_it() -> None:
    from scanner_core import __file__ as here

    assert Redactor()(f'File "{here}", line 3') == 'File "[program]/scanner_core/__init__.py", line 3'.replace("/", "\\" if "\\" in here else "/")


def test_a_devices_name_is_no_files() -> None:
    assert file_names(["/dev/ttyUSB0", "bench"]) == []
