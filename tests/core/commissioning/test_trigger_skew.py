"""The cameras' skew, without a calibration, to a few tenths of a millisecond."""

from __future__ import annotations

import numpy as np
import pytest

from scanner_core.commissioning.exposure_run import CameraRun
from scanner_core.commissioning.skew_check import check_skew
from scanner_core.commissioning.trigger_skew import measure_skew, turning_moment
from scanner_core.optics.spot import Spot
from scanner_core.virtual.bench_faults import CameraSkew
from tests.core.commissioning.conftest import Opener


@pytest.mark.parametrize("skew_ms", [0.0, 8.3])
def test_skew_of_the_virtual_cameras(bench: Opener, skew_ms: float) -> None:
    rig = bench(calibrated=False, faults=(CameraSkew(skew_ms=skew_ms, stamped=False),))
    skew = measure_skew(rig, (0.0, 0.0), lambda: False)
    assert skew is not None
    assert abs(skew.skew_ms - skew_ms) < 0.5
    assert skew.uncertainty_ms < 0.5
    assert check_skew(skew, rig.config).verdict == ("pass" if skew_ms == 0.0 else "warn")
    assert rig.motion.status().laser_power == 0


@pytest.mark.parametrize("moment", [40.0, 40.37])
def test_a_crooked_path_with_gaps_turns_when_it_turns(moment: float) -> None:
    """The beam turns at `moment` and its spot crosses a step of the surface and a gap where it is not seen."""
    rng = np.random.default_rng(8)
    run = CameraRun()
    for number in range(81):
        at = 40.0 - abs(number - moment)
        if 12.0 < at < 17.0:
            continue
        x = 3.0 * at + 0.02 * at**2 + (15.0 if at > 25.0 else 0.0) + rng.normal(0, 0.05)
        run.spots[number] = Spot(x, 90 + 0.3 * at + rng.normal(0, 0.05), 1.0, 1.0, 100.0, 500.0, 9, 0.05)
    found = turning_moment(run)
    assert found is not None
    assert abs(found.exposure - moment) < 0.02
    assert turning_moment(CameraRun()) is None
