"""The reference sphere measured once, as it stands: the quick check between two whole tests, kept in the rig's history like them.

It is one acquisition of :class:`~scanner_core.metrology.reference_sphere.SphereTest`, by its default plan.  What a single one
cannot tell, the scatter between placements, the size's uncertainty holds from the fit alone.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

from scanner_core import wall_clock
from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.errors import CalibrationError, StorageError
from scanner_core.files import replaced_when_whole
from scanner_core.jobs.progress import Cancelled, IsCancelled, OnProgress, Progress, never
from scanner_core.metrology.certificate import Occasion, sphere_certificate
from scanner_core.metrology.history import HistoryEntry, append_history, read_history, rig_sha256
from scanner_core.metrology.placing import BenchArtefacts, StandingArtefacts
from scanner_core.metrology.reference_sphere import Reference, SphereResult, SphereTest

POINTS, VIEWS = 3500, 8
"""Of the one acquisition, as in the whole test."""


@dataclass(frozen=True, slots=True, eq=False)
class SphereCheck:
    """A finished check, with all that its certificate says.

    Attributes
    ----------
    entry : as it stands in the history, or would
    kept : it does
    fault : why it could not be kept although it should
    """

    result: SphereResult
    entry: HistoryEntry
    occasion: Occasion
    kept: bool
    fault: StorageError | None = None

    def write_certificate(self, path: Path, *, replace: bool = False) -> None:
        """One page of PDF; an existing file only with `replace`.

        Raises
        ------
        StorageError
        """
        with replaced_when_whole(path, force=replace) as partial_file:
            sphere_certificate(self.result, self.occasion, partial_file)


def measure_sphere(
    rig: OpenRig,
    reference: Reference,
    *,
    points: int = POINTS,
    views: int = VIEWS,
    seed: int = 0,
    progress: OnProgress = lambda _: None,
    cancelled: IsCancelled = never,
) -> SphereResult:
    """Measure the sphere in the middle of the table once; the laser is dark and the rig at rest afterwards, however it ends.

    The virtual bench puts the sphere there by itself, and what stood there before back afterwards.

    Parameters
    ----------
    reference : the sphere's calibrated radius
    seed : of where exactly the virtual bench puts it down

    Raises
    ------
    CalibrationError
        E-CAL-02: the rig has none.
    AcquisitionError
        E-SCAN-01 nothing on the table; E-MET-03 no sphere, E-MET-04 two of them, E-MET-05 too few points.
    DeviceError
        MotionStoppedError among them, when somebody stopped the controller.
    Cancelled
    """
    began_s, most = time.monotonic(), 0.0

    def told(share: float) -> None:
        nonlocal most
        if cancelled():
            raise Cancelled
        most = max(most, share)  # a scan that comes to its end has no estimate any more
        spent_s = time.monotonic() - began_s
        progress(Progress("sphere", most, spent_s * (1 - most) / most if most > 0.05 else None))

    told(0.0)
    bench = rig.bench
    former = None if bench is None else bench.specimen
    operator = StandingArtefacts() if bench is None else BenchArtefacts(bench, None, seed)
    try:
        return SphereTest(rig, reference, points, views, operator).run(1, told)
    finally:
        if bench is not None:
            bench.change_specimen(former)


def tests_before(history: Path) -> int:
    """How often the sphere was measured with this rig; no time when that cannot be read."""
    try:
        return len(read_history(history, "sphere"))
    except StorageError:
        return 0


def keep_sphere(result: SphereResult, rig: OpenRig, source: str, history: Path, *, keep: bool = True) -> SphereCheck:
    """Add a result to a rig's history, unless it says nothing about that rig (`keep`).

    Parameters
    ----------
    source : the rig file's name or the preset's, for the certificate
    history : where that stands; what cannot be written there is returned all the same

    Raises
    ------
    CalibrationError
        E-CAL-02.
    """
    config, calibration = rig.config, rig.calibration
    if calibration is None:
        raise CalibrationError("E-CAL-02")
    seed = 0 if rig.bench is None else rig.bench.seed
    date, tested = wall_clock.stamp(), result.characteristics()
    entry = HistoryEntry(
        date=date,
        test="sphere",
        figures={c.name: c.value_um for c in tested},
        uncertainties={c.name: c.expanded_uncertainty_um for c in tested},
        limits={c.name: c.limit_um for c in tested},
        verdict=result.verdict.value,
        calibration_id=calibration.identity(),
        calibration_date=calibration.date,
        rig_sha256=rig_sha256(config),
        seed=seed,
    )
    shown, fault = [entry], None
    if keep:
        try:
            append_history(history, entry)
            shown = read_history(history, "sphere")
        except StorageError as refused:
            fault = refused
    occasion = Occasion(config, source, calibration, date, seed, (("Views", f"{VIEWS}"),), tuple(shown))
    return SphereCheck(result, entry, occasion, keep and fault is None, fault)
