"""What is known of how one mount lies on another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.sentences import SENTENCES


class Verdict(StrEnum):
    """Whether a pose may be used."""

    ACCEPTED = "accepted"
    AMBIGUOUS = "ambiguous"
    NO_FIT = "no_fit"


@dataclass(frozen=True, slots=True, eq=False)
class Rival:
    """The best pose that is another one.

    Attributes
    ----------
    transform : moving to fixed
    score, misfit : as those of the best pose
    significance : how many standard uncertainties its misfit is larger than that of the best pose
    """

    transform: RigidTransform
    score: float
    misfit: float
    significance: float


@dataclass(frozen=True, slots=True, eq=False)
class MountStart:
    """How a mount lies on another one, or on several that were joined before.

    Attributes
    ----------
    transform : the moving mount's object frame to the fixed one's; only to be used when it was accepted
    verdict : whether it may be
    code, fields : of the sentence that says why it was not; empty when it was accepted
    overlap_fixed, overlap_moving : share of each cloud's points that lie over the other's surface
    agree : share of these that agree within the noise
    misfit : mean squared distance there over the expected one, each counted up to 16; about 1 when right
    residual_um : robust standard deviation of the distances there
    score : share of the better covered cloud that agrees less what does not, 0 to 1
    in_the_light : share of a cloud that stands where light to the other one passed
    rival : the best different pose, or None when none was seen
    undetermined : (6, k) the directions of motion that the common surface leaves open: turn about `centre` times `radius_mm`
        (three rows), shift (three rows), mm
    centre : (3,) mm, fixed frame
    uncertainties_um : (6 - k,) standard uncertainty along the other directions, of independent points
    uncertainty_um : of where the pose lays the moving cloud's points, rms over them, by the same
    """

    transform: RigidTransform
    verdict: Verdict
    overlap_fixed: float = 0.0
    overlap_moving: float = 0.0
    agree: float = 0.0
    misfit: float = float("inf")
    residual_um: float = float("inf")
    score: float = 0.0
    in_the_light: float = 0.0
    rival: Rival | None = None
    undetermined: NDArray[np.float64] = field(default_factory=lambda: np.eye(6))
    centre: NDArray[np.float64] = field(default_factory=lambda: np.zeros(3))
    radius_mm: float = 1.0
    uncertainties_um: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    uncertainty_um: float = float("inf")
    code: str = ""
    fields: Mapping[str, object] = field(default_factory=dict)

    @property
    def accepted(self) -> bool:
        return self.verdict is Verdict.ACCEPTED

    @property
    def margin(self) -> float:
        """The score less that of the rival."""
        return self.score - (0.0 if self.rival is None else self.rival.score)

    @property
    def reason(self) -> str:
        """Why it was not accepted and what to do, for a person; empty when it was."""
        if not self.code:
            return ""
        sentence = SENTENCES[self.code]
        return f"{sentence.what.format(**self.fields)} {sentence.do.format(**self.fields)}"

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        rival = self.rival
        return {
            "verdict": str(self.verdict),
            "code": self.code,
            "reason": self.reason,
            "overlap_fixed": round(self.overlap_fixed, 3),
            "overlap_moving": round(self.overlap_moving, 3),
            "agree": round(self.agree, 4),
            "misfit": _finite(self.misfit, 3),
            "residual_um": _finite(self.residual_um, 2),
            "score": round(self.score, 4),
            "in_the_light": round(self.in_the_light, 4),
            "margin": round(self.margin, 4),
            "rival": None
            if rival is None
            else {
                "score": round(rival.score, 4),
                "misfit": _finite(rival.misfit, 3),
                "significance": _finite(rival.significance, 1),
                "angle_deg": round((rival.transform @ self.transform.inverse()).angle_deg(), 1),
            },
            "undetermined": self.undetermined.T.round(4).tolist(),
            "uncertainty_um": _finite(self.uncertainty_um, 2),
            "uncertainties_um": self.uncertainties_um.round(2).tolist(),
        }


def _finite(value: float, digits: int) -> float | None:
    return round(value, digits) if np.isfinite(value) else None
