"""All checks of a case, in the order in which they are shown."""

from __future__ import annotations

from dataclasses import dataclass, replace

from scanner_core.case.records import Order
from scanner_core.case.store import CaseStore
from scanner_core.delivery.check import Check, CheckVerdict, Readiness, readiness
from scanner_core.delivery.checks import measured_checks, person_checks
from scanner_core.delivery.facts import CaseFacts, read_facts
from scanner_core.delivery.other_ear import check_side, find_other_ear
from scanner_core.delivery.shape_checks import check_size, shape_checks
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress


@dataclass(frozen=True, slots=True, eq=False)
class Examination:
    """A case as it was found before its delivery."""

    facts: CaseFacts
    checks: tuple[Check, ...]

    @property
    def verdict(self) -> Readiness:
        return readiness(self.checks)

    def of(self, verdict: CheckVerdict) -> list[Check]:
        """The checks with a verdict."""
        return [check for check in self.checks if check.verdict is verdict]


def examine(
    store: CaseStore, order: Order | None = None, *, progress: OnProgress = lambda _: None, cancelled: IsCancelled = lambda: False
) -> Examination:
    """Check the surface that counts in a case; the case is only read.

    Parameters
    ----------
    order : instead of the one that stands in the case

    Raises
    ------
    CaseError
        E-CASE-05 when it holds no surface yet.
    Cancelled
    """

    def step(phase: str, fraction: float) -> None:
        if cancelled():
            raise Cancelled
        progress(Progress(phase, fraction))

    step("measured", 0.0)
    facts = read_facts(store)
    if order is not None:
        facts = replace(facts, order=order)
    measured = measured_checks(facts)
    step("shape", 0.1)
    shape = shape_checks(facts.mesh)
    step("side", 0.25)
    other = find_other_ear(store.path, facts.order, cancelled)

    def halfway(found: Progress) -> None:
        progress(Progress("side", 0.3 + 0.7 * found.fraction))

    side = check_side(facts.order, facts.mesh, other, progress=halfway, cancelled=cancelled)
    checks = (*measured, *shape, check_size(facts.mesh, facts.order.type), side, *person_checks(facts))
    return Examination(facts, checks)
