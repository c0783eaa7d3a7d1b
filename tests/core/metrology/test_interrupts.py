"""An interrupt in the middle of a test: laser off, nothing left running, what was finished is kept."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.rig import load_preset
from scanner_core.errors import AcquisitionError
from scanner_core.metrology.placing import operator_for
from scanner_core.metrology.reference_sphere import Reference, SphereTest
from scanner_core.metrology.static_spot import StaticTest


def _after(count: int) -> Callable[[float], None]:
    calls = [0]

    def told(_: float) -> None:
        calls[0] += 1
        if calls[0] == count:
            raise KeyboardInterrupt

    return told


def _dark_and_usable(rig: OpenRig) -> bool:
    rig.motion.aim(0.0, 0.0)
    return rig.motion.status().laser_power == 0


def test_a_static_test_that_is_interrupted_is_dark_and_keeps_its_pairs() -> None:
    with open_rig(load_preset("bench"), None, "max", 0) as rig:
        test = StaticTest(rig, 4000, 1)
        with pytest.raises(KeyboardInterrupt):
            test.run(_after(1))
        assert _dark_and_usable(rig)
        assert 0 < test.result().repeats < 4000


def test_a_sphere_test_that_is_interrupted_is_dark_and_keeps_whole_acquisitions() -> None:
    with open_rig(load_preset("bench"), None, "max", 0) as rig:
        test = SphereTest(rig, Reference(11.133, 0.001), points=5000, views=4)
        with pytest.raises(KeyboardInterrupt):
            test.run(2, _after(2))
        assert _dark_and_usable(rig)
        assert test.done == []


def test_without_a_bench_somebody_has_to_place_the_artefacts() -> None:
    with open_rig(load_preset("bench"), None, "max", 0) as rig:
        rig.bench = None
        with pytest.raises(AcquisitionError) as error:
            operator_for(rig, None)
    assert error.value.code == "E-MET-01"
