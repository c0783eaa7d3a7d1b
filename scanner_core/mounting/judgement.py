"""Whether a pose may be used: it must fit, fit better than every other, and be determined in all six directions.

Everything is judged on the mounts' own data: by the scatter of each cloud about its own surface is known how far two
measurements of one surface lie apart, and the surface that both show must lie so at the right pose.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from scanner_core.geometry.rigid import RigidTransform
from scanner_core.mounting.agreement import Agreement
from scanner_core.mounting.mount_start import MountStart, Rival, Verdict
from scanner_core.mounting.surface_fit import SurfaceFit

Array = NDArray[np.float64]

LEAST_POINTS = 300
_LEAST_OVERLAP = 0.08
"""Share of the better covered cloud that must lie over the other."""
_LEAST_AGREE, _MOST_MISFIT = 0.9, 3.0
"""Measured: right poses 0.99 and 1.0, wrong ones 0.2-0.4 and more than 8."""
_MOST_IN_LIGHT = 0.08
_RIVAL_MISFIT, _RIVAL_SIGNIFICANCE = 1.0, 6.0
"""A rival is out when its misfit is larger than the best one's by so much, and by so many standard uncertainties."""
_RIVAL_OVERLAP = 0.3
"""A rival with less of the best one's overlap is no explanation of what was measured."""


@dataclass(frozen=True, slots=True, eq=False)
class TriedPose:
    """A pose that was improved to the end, and what the mounts say of each other there."""

    fit: SurfaceFit
    agreement: Agreement


def too_few(points: int) -> MountStart:
    """For clouds that cannot be judged."""
    return MountStart(RigidTransform.identity(), Verdict.NO_FIT, code="E-MNT-06", fields={"points": points, "least": LEAST_POINTS})


def judged(best: TriedPose | None, others: list[TriedPose], moving: Array, *, picked: bool = False) -> MountStart:
    """The verdict on the best pose, given the best different ones; None when there was none at all.  `moving` are that mount's points (n, 3) mm.

    Directions that stay open are no reason to refuse what a person `picked`: along them the picked points count.
    """
    if best is None:
        return MountStart(RigidTransform.identity(), Verdict.NO_FIT, code="E-MNT-01", fields={"agree": 0})
    found, knowledge = best.agreement, best.fit.knowledge
    rival = _rival(found, others)
    start = MountStart(
        transform=best.fit.transform,
        verdict=Verdict.ACCEPTED,
        overlap_fixed=found.overlap_fixed,
        overlap_moving=found.overlap_moving,
        agree=found.agree,
        misfit=found.misfit,
        residual_um=found.residual_um,
        score=found.score,
        in_the_light=found.in_the_light,
        rival=rival,
    )
    overlap = max(found.overlap_fixed, found.overlap_moving)
    if knowledge is None or overlap < _LEAST_OVERLAP:
        return refused(start, Verdict.NO_FIT, "E-MNT-02", overlap=round(100 * overlap), least=round(100 * _LEAST_OVERLAP))
    start = replace(
        start,
        undetermined=knowledge.undetermined,
        centre=knowledge.centre,
        radius_mm=knowledge.radius_mm,
        uncertainties_um=1e3 * knowledge.uncertainties_mm[knowledge.known],
        uncertainty_um=1e3 * knowledge.uncertainty_mm(start.transform.apply(moving)),
    )
    if found.agree < _LEAST_AGREE or found.misfit > _MOST_MISFIT:
        return refused(start, Verdict.NO_FIT, "E-MNT-01", agree=round(100 * found.agree))
    if found.in_the_light > _MOST_IN_LIGHT:
        return refused(start, Verdict.NO_FIT, "E-MNT-05", share=round(100 * found.in_the_light))
    if not knowledge.known.all() and not picked:
        return refused(start, Verdict.AMBIGUOUS, "E-MNT-04", directions=int(np.sum(~knowledge.known)))
    if rival is not None and rival.significance < _RIVAL_SIGNIFICANCE:
        angle = (rival.transform @ start.transform.inverse()).angle_deg()
        return refused(start, Verdict.AMBIGUOUS, "E-MNT-03", angle=round(angle))
    return start


def _rival(best: Agreement, others: list[TriedPose]) -> Rival | None:
    """Of the different poses the one that the data speak least against; its significance is infinite where they rule it out
    by how little of the mounts it lays onto each other, or by where it puts one before the other's light."""
    rivals = []
    overlap = best.overlap_fixed + best.overlap_moving
    for other in others:
        seen = other.agreement
        larger = seen.misfit - best.misfit
        significance = larger / max(np.hypot(seen.misfit_uncertainty, best.misfit_uncertainty), 1e-9)
        if seen.overlap_fixed + seen.overlap_moving < _RIVAL_OVERLAP * overlap or seen.in_the_light > best.in_the_light + _MOST_IN_LIGHT:
            significance = np.inf
        elif larger < _RIVAL_MISFIT:
            significance = min(significance, 0.0)
        rivals.append(Rival(other.fit.transform, seen.score, seen.misfit, float(significance)))
    return min(rivals, key=lambda rival: (rival.significance, -rival.score), default=None)


def refused(start: MountStart, verdict: Verdict, code: str, **fields: object) -> MountStart:
    """The same, not accepted for what a sentence says."""
    return replace(start, verdict=verdict, code=code, fields=fields)
