"""The rig that the contracts are held against with ``-m hardware``."""

from __future__ import annotations

from pathlib import Path

import pytest

from scanner_core.devices.rig import RigConfig, load_rig_or_preset


@pytest.fixture(scope="session")
def hardware_rig(request: pytest.FixtureRequest) -> RigConfig:
    """Of ``--rig RIG.toml``."""
    name = request.config.getoption("--rig")
    if name is None:
        pytest.fail("name the rig file whose devices are to be tested: pytest -m hardware --rig RIG.toml")
    return load_rig_or_preset(str(name) if str(name) == Path(str(name)).stem else str(Path(str(name)).resolve()))
