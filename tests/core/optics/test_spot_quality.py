from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scanner_core.optics.spot import MissReason, Spot, SpotMiss
from scanner_core.optics.spot_detection import SpotDetector
from scanner_core.optics.spot_quality import SpotGrade, judge_spot
from tests.bench.optics.spot_images import BENCH, expose
from tests.core.optics.spots import PARAMETERS, light

GOOD = Spot(80.0, 60.0, 1.0, 0.9, 190.0, 1500.0, 20, 0.02)


@pytest.mark.parametrize(
    ("spot", "grade", "code", "words"),
    [
        (GOOD, SpotGrade.GOOD, "good", "well exposed"),
        (GOOD._replace(sigma_x_px=0.3), SpotGrade.POOR, "sharp", "0.3 px wide (sigma): its centroid locks to the pixels; defocus"),
        (GOOD._replace(sigma_y_px=0.7), SpotGrade.WEAK, "sharp", "at least 0.75 px"),
        (GOOD._replace(sigma_x_px=3.4), SpotGrade.WEAK, "blurred", "focus the lens"),
        (GOOD._replace(peak_dn=255.0), SpotGrade.WEAK, "clipped", "shorten the exposure"),
        (GOOD._replace(peak_dn=60.0), SpotGrade.WEAK, "dim", "60 of 255"),
    ],
)
def test_spot_is_judged_and_the_advice_says_what_to_do(spot: Spot, grade: SpotGrade, code: str, words: str) -> None:
    quality = judge_spot(spot, PARAMETERS)
    assert (quality.grade, quality.code) == (grade, code)
    assert words in quality.advice


@pytest.mark.parametrize("reason", MissReason)
def test_every_miss_has_its_advice(reason: MissReason) -> None:
    quality = judge_spot(SpotMiss(reason), PARAMETERS)
    assert (quality.grade, quality.code) == (SpotGrade.POOR, reason.value)
    assert quality.advice.endswith(".")


@pytest.mark.parametrize(("sigma", "code"), [(0.25, "sharp"), (0.5, "sharp"), (0.95, "good"), (1.8, "good"), (2.8, "blurred")])
@pytest.mark.parametrize("centroid", ["weighted", "gaussian", "border"])
def test_images_are_judged_by_their_size(sigma: float, code: str, centroid: str) -> None:
    rng = np.random.default_rng(4)
    parameters = replace(PARAMETERS, centroid=centroid, min_area_px=1)
    peak_dn = 200 / max(1e-9, light(80.0, 60.0, sigma, sigma, 1.0).max())
    codes = []
    for _ in range(20):
        x, y = 80 + rng.uniform(-0.4, 0.4), 60 + rng.uniform(-0.4, 0.4)
        codes.append(judge_spot(SpotDetector(parameters).detect(expose(light(x, y, sigma, sigma, peak_dn), BENCH, rng)), parameters).code)
    assert codes.count(code) >= 19
