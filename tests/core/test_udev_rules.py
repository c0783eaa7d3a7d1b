"""The udev rules that two sentences name: there, well-formed, and for what laboratories plug in."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from scanner_core.sentences import SENTENCES

RULES = Path(__file__).resolve().parents[2] / "packaging" / "udev" / "70-impronta.rules"
KEY = re.compile(r'(ACTION|SUBSYSTEMS?|ATTRS?\{\w+\}|ENV\{\w+\}|GROUP|MODE|TAG|GOTO|LABEL)(==|!=|\+=|=)"([^"]*)"')
MATCHES = ("==", "!=")


def _verifies() -> bool:
    return shutil.which("udevadm") is not None and subprocess.run(["udevadm", "verify", "--help"], capture_output=True, check=False).returncode == 0


def _lines() -> list[list[tuple[str, str, str]]]:
    """Every rule as (key, operator, value)."""
    rules = []
    for line in RULES.read_text(encoding="ascii").splitlines():
        if not line or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split(", ")]
        found = [KEY.fullmatch(part) for part in parts]
        assert all(found), line
        rules.append([match.groups() for match in found if match])
    return rules


def _port_rule(vendor: str, product: str) -> dict[str, str] | None:
    """Follow the rules for a serial port as udev would; what is assigned."""
    given = {"ACTION": "add", "SUBSYSTEM": "tty", "ATTRS{idVendor}": vendor, "ATTRS{idProduct}": product}
    assigned: dict[str, str] = {}
    label = ""
    for rule in _lines():
        if label:
            if rule != [("LABEL", "=", label)]:
                continue
            label = ""
        if not all((given.get(key) in value.split("|")) is (operator == "==") for key, operator, value in rule if operator in MATCHES):
            continue
        for key, operator, value in rule:
            if key == "GOTO":
                label = value
            elif operator not in MATCHES and key != "LABEL":
                assigned[key] = value
    assert not label, f"nothing is called {label}"
    return assigned or None


@pytest.mark.parametrize(
    ("vendor", "product"),
    [("1a86", "7523"), ("0403", "6001"), ("10c4", "ea60"), ("2341", "0043"), ("2341", "8036"), ("0483", "5740"), ("2e8a", "000a"), ("16c0", "0483")],
)
def test_a_controllers_port_is_the_users_and_no_modem(vendor: str, product: str) -> None:
    rule = _port_rule(vendor, product)
    assert rule is not None
    assert rule["TAG"] == "uaccess"
    assert rule["GROUP"] == "dialout"
    assert rule["ENV{ID_MM_DEVICE_IGNORE}"] == "1"


def test_another_port_is_left_alone() -> None:
    assert _port_rule("12d1", "1001") is None  # a modem


def test_every_goto_leads_forward_to_one_label() -> None:
    labels = [value for rule in _lines() for key, _, value in rule if key == "LABEL"]
    assert len(set(labels)) == len(labels)
    for place, rule in enumerate(_lines()):
        for key, _, value in rule:
            if key == "GOTO":
                assert any(("LABEL", "=", value) in later for later in _lines()[place + 1 :])


def test_cameras_are_the_users_too() -> None:
    video = next(rule for rule in _lines() if ("SUBSYSTEM", "==", "video4linux") in rule)
    basler = next(rule for rule in _lines() if ("ATTR{idVendor}", "==", "2676") in rule)
    assert all(("TAG", "+=", "uaccess") in rule for rule in (video, basler))


def test_the_sentences_lead_to_it() -> None:
    assert all("packaging/udev" in SENTENCES[code].do for code in ("E-MOT-12", "E-CAM-06"))


@pytest.mark.skipif(not _verifies(), reason="no udev that verifies rules")
def test_udev_itself_accepts_it() -> None:
    answer = subprocess.run(["udevadm", "verify", str(RULES)], capture_output=True, text=True, check=False, timeout=20)
    assert answer.returncode == 0, answer.stderr + answer.stdout
