"""``impronta verify`` on the virtual rig, short runs: JSON, certificate, history, exit codes."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from scanner_core.__main__ import main
from scanner_core.acquisition.rig_session import open_rig
from scanner_core.commands import verifying
from scanner_core.devices.rig import dump_rig, load_preset
from scanner_core.errors import AcquisitionError
from scanner_core.metrology.certificate import Occasion
from scanner_core.metrology.history import history_path, read_history
from scanner_core.metrology.static_spot import StaticTest
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.specimens import load_specimen


@pytest.fixture
def rig(tmp_path: Path) -> Path:
    """A rig file of its own, so that every test has its own history."""
    path = tmp_path / "mine.toml"
    path.write_text(dump_rig(load_preset("bench")), encoding="utf-8")
    return path


def _never(*_: object) -> None:
    raise AssertionError("the rig was opened")


def _json(capsys: pytest.CaptureFixture[str]) -> dict[str, Any]:
    values: dict[str, Any] = json.loads(capsys.readouterr().out)
    return values


def _verify(*words: object) -> int:
    return main(["verify", *map(str, words)])


def test_static_gives_the_promised_keys_a_certificate_and_a_history(rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    asked = ("static", "--rig", rig, "--repeats", 400, "--places", 8, "--seed", 5, "--json")
    assert _verify(*asked, "--out", out) == 0
    values = _json(capsys)
    assert values["repeats"] == 400
    assert values["sd_um"].keys() == {"x", "y", "z"}
    assert values["repeatability_um"] == pytest.approx(4 * sum(values["sd_um"].values()) / 3, abs=0.01)
    assert 0 < values["resolution_um"] < 50
    assert isinstance(values["drift_um"], float)
    assert values["finish_reason"] == "completed"
    certificate = (out / verifying.CERTIFICATE).read_bytes()
    assert certificate.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", certificate)) == 1
    assert json.loads((out / verifying.RESULT).read_text(encoding="utf-8")) == values

    assert _verify(*asked, "--out", out) == 1  # nothing is overwritten, and nothing measured for it
    assert "E-DISK-03" in capsys.readouterr().err
    assert _verify(*asked) == 0
    again = _json(capsys)
    assert again["sd_um"] == values["sd_um"]  # the same seed
    entries = read_history(history_path(str(rig)), "static")
    assert [round(entry.figures["sd_x"], 3) for entry in entries] == [values["sd_um"]["x"]] * 2


def test_a_sphere_s_size_is_judged(rig: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = ("sphere", "--rig", rig, "--acquisitions", 1, "--points", 400, "--views", 4, "--json")
    assert _verify(*asked) == 0
    values = _json(capsys)
    assert {"mean_radius_mm", "radius_sd_mm", "residual_rms_um", "reference_radius_mm", "verdict"} <= values.keys()
    (one,) = values["acquisitions"]
    assert {"points", "radius_mm", "residual_rms_um", "coverage_deg"} <= one.keys()
    assert one["points"] + one["rejected"] + one["foreign"] == 400
    assert abs(values["mean_radius_mm"] - 11.133) < 0.05
    assert _verify(*asked, "--reference-mm", 11.5) == 3
    assert _json(capsys)["verdict"] == "fail"
    assert [entry.verdict for entry in read_history(history_path(str(rig)), "sphere")] == [values["verdict"], "fail"]


@pytest.mark.parametrize(
    ("test", "changed", "trace"),
    [
        ("static", ("--without", "speckle"), "without speckle it is another rig"),
        ("static", ("--fault", "camera_bumped@900"), "it was disturbed by camera_bumped@900"),
        ("sphere", ("--specimen", "mine.stl"), "the specimen 'mine.stl' is not the reference sphere"),
    ],
)
def test_what_the_command_line_changed_is_told_and_not_the_history_s(
    test: str, changed: tuple[str, str], trace: str, rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    facts: list[tuple[str, str]] = []

    def kept(result: object, on: Occasion, path: Path) -> None:
        facts.extend(on.parameters)
        path.write_bytes(b"%PDF")

    for name in ("static_certificate", "sphere_certificate"):
        monkeypatch.setattr(f"scanner_core.commands.verify.{name}", kept)
    monkeypatch.setattr("scanner_core.commands.scanning.load_specimen", lambda *_, **__: load_specimen("sphere"))
    few = ("--repeats", 60, "--places", 4) if test == "static" else ("--acquisitions", 1, "--points", 400, "--views", 4)
    rig.write_text(rig.read_text(encoding="utf-8") + "\n[image_model]\nelectrons_per_dn = 60.0\n", encoding="utf-8")
    assert _verify(test, "--rig", rig, *few, *changed, "--out", tmp_path / "out", "--json") == 0
    values = _json(capsys)
    assert json.loads((tmp_path / "out" / verifying.RESULT).read_text(encoding="utf-8")) == values
    assert (values["history"], values["history_left_out"]) == (None, trace)
    assert not history_path(str(rig)).exists()
    option, value = changed
    assert values["image_model"] == {"electrons_per_dn": 60.0} | ({"without": [value]} if option == "--without" else {})
    assert values["faults"] == ([value] if option == "--fault" else [])
    assert values["specimen"] == {"static": None, "sphere": value}[test]
    assert ("Image model", "electrons_per_dn 60") in facts
    assert value in dict(facts).values()


def test_a_rig_with_an_image_model_of_its_own_has_its_history_and_an_expired_calibration_is_told(
    rig: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    config = load_preset("bench")
    assert config.calibration is not None
    old = replace(config.calibration, date="2020-01-01T00:00:00+00:00", valid_days=30.0)
    rig.write_text(dump_rig(replace(config, calibration=old, image_model={"f_number": 2.8, "without": ["surface"]})), encoding="utf-8")
    assert _verify("static", "--rig", rig, "--repeats", 60, "--places", 4, "--json") == 0
    told = capsys.readouterr()
    values = json.loads(told.out)
    assert (values["history"], values["history_left_out"]) == (str(history_path(str(rig))), None)
    assert len(read_history(history_path(str(rig)), "static")) == 1
    (warning,) = values["warnings"]
    assert "expired" in warning
    assert told.err.count(warning) == 1


def test_one_position_of_the_bar_proves_nothing(rig: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert _verify("acceptance", "--rig", rig, "--positions", 1, "--points", 500, "--views", 3, "--json") == 0
    values = _json(capsys)
    assert values["verdict"] == "undecided"
    (position,) = values["positions"]
    assert abs(position["spacing_error_um"]) < 150
    assert len(position["spheres"]) == 2
    assert {c["name"] for c in values["characteristics"]} == {"form", "dispersion", "size", "spacing"}


def test_what_is_no_sphere_of_that_radius_is_said(rig: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert _verify("sphere", "--rig", rig, "--acquisitions", 1, "--points", 100, "--views", 2, "--reference-mm", 20) == 1
    assert "E-MET-03" in capsys.readouterr().err


def test_a_rig_without_calibration_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bare = tmp_path / "bare.toml"
    bare.write_text(dump_rig(load_preset("bench").with_calibration(None)), encoding="utf-8")
    assert _verify("static", "--rig", bare) == 1
    assert "E-CAL-02" in capsys.readouterr().err
    assert not history_path(str(bare)).exists()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("static --fault camera_kicked", "no fault 'camera_kicked'"),
        ("static --without fog", "no term 'fog'"),
        ("static --without speckle,distortion", 'without = ["distortion"] into the table [image_model] of a rig file, calibrate'),
        ("sphere --reference-mm 1 --reference-uncertainty-mm 2", "no calibrated artefact"),
        ("sphere --views 1000", "make no plan"),
        ("acceptance --positions 8", "has 7 positions"),
        ("acceptance --spacing-mm 5000", "E-USE-01"),
    ],
)
def test_wrong_usage_is_found_before_anything_is_made(
    words: str, told: str, rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("scanner_core.commands.verify.open_rig", _never)
    assert _verify(*words.split(), "--rig", rig, "--out", tmp_path / "out") == 2
    assert told in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_specimen_that_is_none_is_found_before_anything_is_made(rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert _verify("sphere", "--rig", rig, "--specimen", "nothing.stl", "--out", tmp_path / "out") == 1
    assert "E-FILE-01" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("asked", [("--fault", "lamp_on"), ("--without", "speckle")])
def test_hardware_has_neither_faults_nor_terms(asked: tuple[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "real.toml"
    bench = load_preset("bench")
    left, right = (replace(camera, driver="opencv", id=f"http://127.0.0.1/{camera.name}") for camera in (bench.left, bench.right))
    path.write_text(dump_rig(replace(bench, virtual=None, left=left, right=right)), encoding="utf-8")
    for command in (("verify", "static"), ("scan",)):
        assert main([*command, "--rig", str(path), "--out", str(tmp_path / "out"), *asked]) == 2
        assert "virtual rig" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_spot_that_is_not_seen_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(VirtualBench, "change_specimen", lambda self, specimen: None)  # nobody puts the plate there
    with open_rig(load_preset("bench"), None, "max", 0) as opened:
        test = StaticTest(opened, 60, 4)
        with pytest.raises(AcquisitionError) as error:
            test.run(lambda count: None)
        assert opened.motion.status().laser_power == 0
    assert error.value.code == "E-MET-02"


def test_an_interrupt_keeps_what_was_measured_but_makes_no_history(
    rig: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    class Impatient(verifying.Bar):
        def add(self, count: int, whole: int) -> None:
            super().add(count, whole)
            if self._done >= 100:
                raise KeyboardInterrupt

    monkeypatch.setattr("scanner_core.commands.verify.Bar", Impatient)
    out = tmp_path / "out"
    assert _verify("static", "--rig", rig, "--repeats", 400, "--places", 8, "--json", "--out", out) == 130
    values = _json(capsys)
    assert values["finish_reason"] == "cancelled"
    assert 90 <= values["repeats"] < 400
    assert (out / verifying.RESULT).exists()
    assert not (out / verifying.CERTIFICATE).exists()
    assert not history_path(str(rig)).exists()


def test_a_history_that_cannot_be_kept_costs_only_the_history(rig: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    (rig.parent / "file").write_text("", encoding="utf-8")
    monkeypatch.setattr(verifying, "history_path", lambda _: rig.parent / "file" / "x.jsonl")
    assert _verify("static", "--rig", rig, "--repeats", 60, "--places", 4, "--json") == 0
    told = capsys.readouterr()
    assert "history was not kept" in told.err
    assert json.loads(told.out)["history"] is None
