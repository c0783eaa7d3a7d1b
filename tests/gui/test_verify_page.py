"""The reference sphere in the window: measured on the virtual rig, and the page's states by made-up results."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.controllers.readiness import Readiness, ReadySnapshot, Remedy
from app.controllers.verification import VIRTUAL_SPHERE, VerificationController, VerificationSnapshot
from app.program import Program
from app.views.ready_line import ReadyLine
from app.views.verify_page import VerifyPage
from scanner_core.commissioning.readiness import Obstacle, ReadyFinding
from scanner_core.devices.rig import AcceptanceLimits, load_preset
from scanner_core.errors import AcquisitionError
from scanner_core.metrology.certificate import Occasion
from scanner_core.metrology.coverage import Coverage
from scanner_core.metrology.history import HistoryEntry, read_history
from scanner_core.metrology.reference_sphere import Acquisition, Reference, SphereResult
from scanner_core.metrology.sphere_check import SphereCheck
from tests.gui.waiting import until

LIMITS = AcceptanceLimits()


@pytest.fixture
def page(shared_program: Program) -> Iterator[VerifyPage]:
    services, window = shared_program.services, shared_program.window
    until(lambda: services.rig.snapshot.at_rest, 120, "the rig")
    window.show_page("verify")
    found = window.pages["verify"]
    assert isinstance(found, VerifyPage)
    yield found
    _show(services.verification, VerificationSnapshot())
    window.show_page("home")


def _show(verification: VerificationController, snapshot: VerificationSnapshot) -> None:
    verification.snapshot = snapshot
    verification.changed.emit()


def made_check(size_um: float, *, reach_deg: float = 104.0, kept: bool = True) -> SphereCheck:
    """A made-up result: this deviation of the radius, a micrometre of scatter."""
    rng = np.random.default_rng(3)
    away = rng.normal(size=(2000, 3))
    directions = away / np.linalg.norm(away, axis=1)[:, None]
    residuals = rng.normal(scale=1.0, size=2000)
    one = Acquisition(2000, 3, 0, 11.133 + 1e-3 * size_um, 5e-4, np.zeros(3), 1.0, 4.0, Coverage(reach_deg, 0.74), 1.0, 0.0, residuals, directions)
    result = SphereResult((one,), Reference(11.133, 0.001), LIMITS)
    rig = load_preset("bench")
    assert rig.calibration is not None
    entry = HistoryEntry("2026-11-27T10:00:00+00:00", "sphere", {}, {}, {}, result.verdict.value, "c", "", "")
    return SphereCheck(result, entry, Occasion(rig, "bench", rig.calibration, entry.date, 0, (), (entry,)), kept)


@pytest.mark.parametrize(
    ("check", "word", "says"),
    [
        (made_check(3.0), "Passed", "within"),
        (made_check(0.5 * LIMITS.size_um + 40.0), "Failed", "Calibrate"),
        (made_check(0.5 * LIMITS.size_um), "Undecided", "near its limit"),
        (made_check(3.0, reach_deg=70.0), "Undecided", "equator"),
    ],
)
def test_the_verdict_stands_with_its_figures_in_words(page: VerifyPage, shared_program: Program, check: SphereCheck, word: str, says: str) -> None:
    _show(shared_program.services.verification, VerificationSnapshot("bench", check=check))
    assert page.result.isVisible()
    verdict, why = page.result.texts
    assert verdict == word
    assert says in why
    facts = page.result.facts.texts
    assert all(part in facts["Size deviation"] for part in ("U = ", "limit "))
    assert {"Dispersion D95", "Form PF, all points", "Form PF without the worst 0.3 %", "Coverage"} < facts.keys()
    assert page.result.calibrate.isVisible() == (word == "Failed")
    primary = [made for made in (page.start, page.result.save, page.result.calibrate) if made.isVisible() and made.property("role") == "primary"]
    assert len(primary) == 1


def test_the_diameter_is_told_not_the_radius(page: VerifyPage, shared_program: Program) -> None:
    _show(shared_program.services.verification, VerificationSnapshot("bench", check=made_check(3.0)))
    assert page.result.deviation.text == "+6.0"
    assert page.result.facts.texts["Measured diameter"] == "22.2720 mm"


def test_a_result_that_was_not_kept_is_said_to_be_none_of_the_rig(page: VerifyPage, shared_program: Program) -> None:
    _show(shared_program.services.verification, VerificationSnapshot("bench", check=made_check(3.0, kept=False), rehearsed=True))
    assert any("rehearsed" in made.text() for made in page.result.findChildren(type(page.notice)))


def test_a_result_is_gone_with_another_calibration_and_stays_with_the_same(page: VerifyPage, shared_program: Program) -> None:
    services = shared_program.services
    verification, rig = services.verification, services.rig
    before, calibration = rig.snapshot, rig.snapshot.calibration
    assert before.config is not None
    assert calibration is not None
    found = made_check(3.0)
    check = replace(found, entry=replace(found.entry, calibration_id=calibration.identity()))
    _show(verification, VerificationSnapshot("bench", check=check))
    rig.changed.emit()
    assert verification.snapshot.check is check
    try:
        turntable = replace(calibration.turntable, origin=calibration.turntable.origin + 0.1)
        rig.snapshot = replace(before, config=before.config.with_calibration(replace(calibration, turntable=turntable)))
        rig.changed.emit()
        assert verification.snapshot.check is None
    finally:
        rig.snapshot = before
        rig.changed.emit()


def test_a_fault_ends_in_a_sentence_on_the_page(page: VerifyPage, shared_program: Program) -> None:
    fault = AcquisitionError("E-MET-05", points=12, least=50)
    _show(shared_program.services.verification, VerificationSnapshot("bench", refused=fault))
    assert page.notice.isVisible()
    assert "12" in page.notice.text()
    assert page.start.isEnabled()


def test_a_real_rig_asks_for_the_certificate(page: VerifyPage, shared_program: Program) -> None:
    rig, settings = shared_program.services.rig, shared_program.services.settings
    before = rig.snapshot
    config = before.config
    assert config is not None
    real = replace(config, left=replace(config.left, driver="opencv"), right=replace(config.right, driver="opencv"))
    try:
        rig.snapshot = replace(before, preset="/somewhere/own.toml", config=real)
        rig.changed.emit()
        assert page.diameter.isVisible()
        assert not page.start.isEnabled()
        assert "certificate" in page.notice.text()
        page.diameter.setValue(20.0)
        assert page.start.isEnabled()
        assert settings.sphere_diameter_mm == 20.0
    finally:
        rig.snapshot = before
        page.diameter.setValue(0.0)
        rig.changed.emit()


def test_the_readiness_line_leads_to_the_page_or_is_put_off(page: VerifyPage, shared_program: Program) -> None:
    readiness = shared_program.services.readiness
    went: list[str] = []
    before = readiness.snapshot
    line = ReadyLine(readiness, went.append)
    try:
        readiness.snapshot = ReadySnapshot(Readiness.OBSTACLE, False, ReadyFinding(Obstacle.NEVER_VERIFIED), 0, None, Remedy.VERIFY)
        line.show_ready()
        line.remedy.click()
        assert went == ["verify"]
        assert not line.later.isHidden()
        line.later.click()
        until(lambda: readiness.snapshot.readiness is Readiness.READY, 60, "nothing said of the sphere any more")
    finally:
        readiness.snapshot = before
        line.deleteLater()


def test_the_sphere_is_measured_and_the_card_follows(page: VerifyPage, shared_program: Program, tmp_path: Path) -> None:
    """With few points from few views; the specimen of before stands on the table again."""
    services = shared_program.services
    verification, rig = services.verification, services.rig
    verification.plan = (120, 3)
    history = rig.files.history("bench")
    before, loaded = len(read_history(history, "sphere")), rig._devices.rig
    assert loaded is not None
    assert loaded.bench is not None
    specimen = loaded.bench.specimen
    try:
        page.start.click()
        assert verification.running
        assert rig.snapshot.busy
        assert not page.start.isEnabled()
        rig.choose(specimen="heart")  # would close the rig under the measurement
        assert rig.snapshot.connected
        assert rig.snapshot.specimen != "heart"
        until(lambda: not verification.running, 120, "the end of the measurement")
        until(lambda: rig.snapshot.at_rest, 20, "the rig given back")
        check = verification.snapshot.check
        assert check is not None, verification.snapshot.refused
        assert check.kept
        assert abs(check.result.mean_radius_mm - 0.5 * VIRTUAL_SPHERE.diameter_mm) < 0.05
        assert loaded.bench.specimen is specimen
        assert len(read_history(history, "sphere")) == before + 1
        assert rig.snapshot.sphere is not None
        assert rig.snapshot.sphere.last == check.entry
        verification.save(tmp_path / "sphere.pdf", replace_it=False)
        until(lambda: verification.snapshot.saved is not None, 60, "the certificate")
        assert (tmp_path / "sphere.pdf").read_bytes().startswith(b"%PDF")
    finally:
        verification.plan = None


def test_esc_ends_it_dark_and_nothing_is_kept(page: VerifyPage, shared_program: Program) -> None:
    services = shared_program.services
    verification, rig = services.verification, services.rig
    history = rig.files.history("bench")
    before = len(read_history(history, "sphere"))
    page.start.click()
    until(lambda: verification.snapshot.fraction > 0.0, 60, "the begin")
    shared_program.window.laser_off()
    assert verification.snapshot.cancelling
    until(lambda: not verification.running, 60, "its end")
    assert verification.snapshot.cancelled
    assert "nothing was kept" in page.notice.text()
    until(lambda: rig.snapshot.at_rest and page.start.isEnabled(), 20, "the rig given back")
    loaded = rig._devices.rig
    assert loaded is not None
    assert loaded.motion.status().laser_power == 0.0
    assert len(read_history(history, "sphere")) == before
