"""What is known of the aiming, as one frozen value."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from scanner_core.acquisition.learning import LearnedSizes
    from scanner_core.devices.aim_settings import AimSettings
    from scanner_core.devices.material import Material


class AimJob(Enum):
    """What the rig does because a person asked for it on the Aim page."""

    NONE = "none"
    FIND = "find"
    MOVE = "move"
    POINT = "point"
    EXPOSE = "expose"
    LEARN = "learn"


@dataclass(frozen=True, slots=True, eq=False)
class AimSnapshot:
    """What is known of the aiming.

    Attributes
    ----------
    live : a person wants the spot lit
    left_s : seconds until it goes dark if nobody does anything; None while it is dark
    job, fraction : what the rig does just now, and how much of it is done where that is known
    settings : exposure and detector as they are used; None while no rig is known
    learned : what the last learning has found
    exposed : by camera, the code of the verdict of the last automatic exposure
    materials : those that can be chosen
    """

    live: bool = False
    left_s: float | None = None
    job: AimJob = AimJob.NONE
    fraction: float | None = None
    settings: AimSettings | None = None
    learned: LearnedSizes | None = None
    exposed: tuple[str, str] | None = None
    materials: tuple[Material, ...] = ()

    @property
    def material(self) -> Material | None:
        """The one that is used."""
        chosen = "" if self.settings is None else self.settings.material
        return next((material for material in self.materials if material.id == chosen), None)
