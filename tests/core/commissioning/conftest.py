"""The virtual rig before it is commissioned: what its rig file says of the axes may be wrong."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace

import pytest

from scanner_core.acquisition.rig_session import OpenRig, open_rig
from scanner_core.devices.rig import load_preset
from scanner_core.optics.calibration import StereoCalibration
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.specimens import load_specimen

Opener = Callable[..., OpenRig]


@pytest.fixture
def bench() -> Iterator[Opener]:
    """Opens it: `units` as the rig file has them, where (1, 1, 1) is right."""
    with ExitStack() as stack:

        def opened(
            specimen: str | None = "sphere",
            *,
            units: tuple[float, float, float] = (1.0, 1.0, 1.0),
            calibrated: bool = True,
            faults: tuple[Fault, ...] = (),
            seed: int = 3,
        ) -> OpenRig:
            config = load_preset("bench")
            config = replace(config, controller=replace(config.controller, units_per_deg=units))
            if not calibrated:
                config = config.with_calibration(None)
            return stack.enter_context(open_rig(config, None if specimen is None else load_specimen(specimen), seed=seed, faults=faults))

        yield opened


@pytest.fixture
def bench_calibration(bench: Opener) -> StereoCalibration:
    """The true one."""
    rig = bench(None)
    assert rig.bench is not None
    return rig.bench.truth_calibration()
