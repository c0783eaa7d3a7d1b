"""One acquisition of the sphere that stands there: what becomes of the table, of a cancel, and of a history that cannot be written."""

from __future__ import annotations

from pathlib import Path

import pytest

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.devices.rig import load_preset
from scanner_core.jobs.progress import Cancelled
from scanner_core.metrology import sphere_check
from scanner_core.metrology.history import read_history
from scanner_core.metrology.reference_sphere import Reference, SphereResult
from scanner_core.metrology.sphere_check import keep_sphere, measure_sphere
from scanner_core.virtual.specimens import load_specimen
from tests.core.metrology.artefacts import sphere_result

REFERENCE = Reference(11.133, 0.001)


def _result() -> SphereResult:
    return sphere_result(load_preset("bench"), acquisitions=1)


def test_a_cancel_leaves_the_specimen_of_before() -> None:
    specimen = load_specimen("ear")
    with open_rig(load_preset("bench"), specimen) as rig:
        asked: list[float] = []
        with pytest.raises(Cancelled):
            measure_sphere(rig, REFERENCE, progress=lambda told: asked.append(told.fraction), cancelled=lambda: len(asked) > 1)
        assert rig.bench is not None
        assert rig.bench.specimen is specimen
        assert rig.motion.status().laser_power == 0.0


def test_a_result_outlives_a_history_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    with open_rig(load_preset("bench")) as rig:
        refused = keep_sphere(_result(), rig, "bench", tmp_path / "file" / "bench.history.jsonl")
        kept = keep_sphere(_result(), rig, "bench", tmp_path / "bench.history.jsonl")
        foreign = keep_sphere(_result(), rig, "bench", tmp_path / "bench.history.jsonl", keep=False)
    assert not refused.kept
    assert refused.fault is not None
    assert kept.kept
    assert not foreign.kept
    assert read_history(tmp_path / "bench.history.jsonl") == [kept.entry]
    assert sphere_check.tests_before(tmp_path / "bench.history.jsonl") == 1


def test_the_form_is_the_range_of_the_radial_deviations() -> None:
    result = _result()
    residuals = result.acquisitions[0].residuals_um
    assert result.form_um == pytest.approx(residuals.max() - residuals.min())
    assert result.dispersion_um < result.usual_form_um < result.form_um
