from __future__ import annotations

import json
import logging
import os
import unicodedata
import zipfile
from pathlib import Path
from urllib.parse import quote

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.case.store import CaseStore, Order
from scanner_core.errors import DeviceError, StorageError, UsageError
from scanner_core.jobs.progress import Cancelled, Progress
from scanner_core.support import bundle as bundles
from scanner_core.support.bundle import SupportBundle, SupportSources, collect, write_bundle
from scanner_core.support.private_names import Mark, PrivateName, file_names, order_names

SECRETS = ("Praxis Huber", "QX-7731", "Zwölfender", "Ottilie", "schläft schlecht", "Xanten-1962", "kxuser9", "host-kx77.example")
"""Order, patient (two words), remarks, a folder and file, the user, the machine; before them the rig."""


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> SupportSources:
    """Secrets in every place where they can be: cases, settings, logs, rig, transcript, report, display."""
    home = tmp_path / "kxuser9"
    cases = home / "Xanten-1962"
    cases.mkdir(parents=True)
    monkeypatch.setattr("pathlib.Path.home", lambda: home)
    monkeypatch.setattr("getpass.getuser", lambda: "kxuser9")
    monkeypatch.setattr("socket.gethostname", lambda: "host-kx77.example")
    with CaseStore.create(cases / "QX-7731_left.impronta") as store:
        store.put_order(Order("QX-7731", "Zwölfender Ottilie", "left", "ear", "schläft schlecht"))
    logs = tmp_path / "log"
    logs.mkdir()
    everything = " | ".join((*SECRETS, str(cases / "Xanten-1962 ear.stl"), json.dumps("Zwölfender"), unicodedata.normalize("NFD", "Zwölfender")))
    for name in ("impronta.log", "impronta.log.1"):
        (logs / name).write_text(f"2026-11-27 INFO {everything}\nplain line\n", encoding="utf-8")
    report = {
        "checks": [{"name": "disk", "verdict": "fail", "detail": everything, "remedy": quote("Zwölfender")}],
        "controller": {"port": "/dev/ttyUSB0", "transcript": [{"t_s": 0.5, "direction": "in", "line": f"[MSG:{everything}]"}]},
    }
    return SupportSources(
        examine=lambda: report,
        rig_text=f'# of {everything}\nname = "Praxis Huber"\nid = "{home}/recordings/Ottilie"\n',
        rig_source=str(home / "Xanten-1962.toml"),
        settings={
            "case_folder": str(cases),
            "last_order": "QX-7731",
            "recent_cases": [str(cases / "QX-7731_left.impronta")],
            "language": "de",
            "export_folder": str(home),
            "name_template": everything,
        },
        display={"screens": [everything]},
        logs=logs,
    )


def _collect(sources: SupportSources) -> SupportBundle:
    return collect(sources, progress=lambda _: None, cancelled=lambda: False)


def test_no_name_is_anywhere_in_the_archive(sources: SupportSources, tmp_path: Path) -> None:
    path = tmp_path / "out.zip"
    write_bundle(_collect(sources), path)
    raw = path.read_bytes()
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        texts = {name: archive.read(name).decode("utf-8") for name in archive.namelist()}
    assert set(texts) == {
        *("README.txt", "rig.toml", "transcript.txt", "doctor.json", "machine.json", "settings.json", "cases.json", "log-0.txt", "log-1.txt")
    }
    for secret in SECRETS:
        for form in ("NFC", "NFD"):
            text = unicodedata.normalize(form, secret)
            for written in {text, json.dumps(text)[1:-1], quote(text), text.replace("schläft ", "")}:
                assert [name for name, inside in texts.items() if written.lower() in (name + inside).lower()] == []
                assert written.encode() not in raw
    assert "plain line" in texts["log-0.txt"]
    assert json.loads(texts["doctor.json"])["controller"]["port"] == "/dev/ttyUSB0"
    assert json.loads(texts["settings.json"])["language"] == "de"
    assert [sorted(case) for case in json.loads(texts["cases.json"])] == [["bytes", "case", "changed"]]
    assert all(mark in texts["log-0.txt"] for mark in ("[order]", "[patient]", "[notes]", "[user]", "[host]", "[file]"))


@settings(max_examples=20)
@given(secrets=st.lists(st.text(st.characters(categories=("L", "Nd")), min_size=5, max_size=20), min_size=3, max_size=3, unique=True), data=st.data())
def test_no_planted_secret_is_found(secrets: list[str], data: st.DataObject, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Whatever an order, a patient or a file is called, wherever it stands."""
    order, patient, stem = secrets
    folder = tmp_path_factory.mktemp("planted")
    around = st.text(st.sampled_from("ab 1_-/\\\n\"'(){}[]:;,.%"), max_size=12)
    everything = "".join(data.draw(around) + secret for _ in range(2) for secret in secrets) + data.draw(around)
    (folder / "impronta.log").write_text(everything, encoding="utf-8")
    names = (*order_names(order, patient), *file_names([folder / f"{stem}.impronta"]))
    report = {"checks": [everything], "controller": {"transcript": [{"t_s": 0.0, "direction": "in", "line": everything}]}}
    made = _collect(SupportSources(examine=lambda: report, rig_text=everything, rig_source=stem + ".toml", names=names, logs=folder))
    write_bundle(made, folder / "bundle.zip")
    with zipfile.ZipFile(folder / "bundle.zip") as archive:
        texts = "".join(name + archive.read(name).decode("utf-8") for name in archive.namelist())
    for secret in secrets:
        for written in (secret, json.dumps(secret)[1:-1], quote(secret)):
            assert written.lower() not in texts.lower()


def test_its_readme_names_every_entry(sources: SupportSources) -> None:
    made = _collect(sources).without(["doctor.json"])
    text = bundles.readme(made)
    assert all(entry.name in text and entry.about in text for entry in made.entries)
    assert "doctor.json" not in text


def test_an_entry_that_is_not_there_cannot_be_left_out(sources: SupportSources) -> None:
    with pytest.raises(UsageError) as refused:
        _collect(sources).without(["doctor"])
    assert refused.value.code == "E-SUP-01"
    assert "doctor.json" in str(refused.value)


def test_a_rig_that_cannot_be_examined_is_a_finding(sources: SupportSources) -> None:
    def lost() -> dict[str, object]:
        raise DeviceError("E-MOT-08", port="/dev/ttyUSB0", details="it was gone")

    def broken() -> dict[str, object]:
        raise ZeroDivisionError("why")

    for examine, told in ((lost, "E-MOT-08"), (broken, "ZeroDivisionError")):
        entry = next(entry for entry in _collect(SupportSources(examine=examine, logs=sources.logs)).entries if entry.kind == "doctor")
        assert told in entry.text
        assert json.loads(entry.text)["checks"][0]["verdict"] == "fail"


def test_a_machine_with_nothing_gives_a_bundle_too(tmp_path: Path) -> None:
    made = _collect(SupportSources(logs=tmp_path / "none"))
    assert [entry.kind for entry in made.entries] == ["machine", "cases"]
    assert json.loads(made.entries[0].text)["versions"]["Python"]


def test_it_appears_whole_or_not_at_all_and_replaces_nothing(sources: SupportSources, tmp_path: Path) -> None:
    made, path = _collect(sources), tmp_path / "there.zip"
    path.write_text("mine")
    with pytest.raises(StorageError) as refused:
        write_bundle(made, path)
    assert refused.value.code == "E-DISK-03"
    assert path.read_text() == "mine"
    write_bundle(made, path, force=True)
    assert zipfile.is_zipfile(path)
    before = sorted(os.listdir(tmp_path))
    with pytest.raises(StorageError):
        write_bundle(made, tmp_path / "no" / "such.zip")
    assert sorted(os.listdir(tmp_path)) == before


def test_it_can_be_cancelled_and_tells_how_far_it_is(sources: SupportSources) -> None:
    told: list[Progress] = []
    with pytest.raises(Cancelled):
        collect(sources, progress=told.append, cancelled=lambda: bool(told))
    collect(sources, progress=told.append, cancelled=lambda: False)
    fractions = [at.fraction for at in told[1:]]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


def test_a_name_that_the_window_knows_is_taken_out(tmp_path: Path) -> None:
    (tmp_path / "impronta.log").write_text("typed Quirin just now\n")
    made = _collect(SupportSources(logs=tmp_path, names=(PrivateName("Quirin", Mark.PATIENT),)))
    assert made.entries[-1].text == "typed [patient] just now\n"
    assert made.replaced["[patient]"] == 1


def test_what_stands_in_the_log_is_what_was_logged(tmp_path: Path) -> None:
    from scanner_core.log_file import logging_to_file

    with logging_to_file("t", folder=tmp_path):
        logging.getLogger("impronta").warning("table stands still")
    assert "WARNING table stands still" in _collect(SupportSources(logs=tmp_path)).entries[-1].text
