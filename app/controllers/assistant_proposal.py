"""The rig that is made of what was chosen."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from app.controllers.assistant_choice import key_of
from app.controllers.assistant_snapshot import AssistantSnapshot

if TYPE_CHECKING:
    from scanner_core.devices.rig import RigConfig


def config_of(snapshot: AssistantSnapshot) -> RigConfig:
    """The rig of what was chosen, with the limits of the bench until they are known better."""
    from scanner_core.commissioning.proposed_rig import propose_rig
    from scanner_core.devices.rig import load_preset

    template, choice = load_preset("bench"), snapshot.choice
    if choice.virtual:
        config = template  # with its calibration: the scene is the one that it is of
    else:
        cameras = {key_of(found): found for found in snapshot.cameras}
        port = next(answer for answer in snapshot.ports if answer.port.url == choice.port)
        assert choice.left is not None
        assert choice.right is not None
        config = propose_rig(template, port, cameras[choice.left], cameras[choice.right], choice.exposure_ms)
    wanted: dict[str, Any] = {"size_px": choice.size_px, "rate_hz": choice.rate_hz, "exposure_ms": choice.exposure_ms, "trigger": choice.trigger}
    wanted = {name: value for name, value in wanted.items() if value is not None}
    return replace(config, left=replace(config.left, **wanted), right=replace(config.right, **wanted))
