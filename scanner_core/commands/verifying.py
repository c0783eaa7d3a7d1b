"""What the tests of ``verify`` share: where their results go, and how far they are."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from scanner_core import __version__, wall_clock
from scanner_core.commands.console import Console
from scanner_core.devices.rig import RigConfig
from scanner_core.errors import ImprontaError, StorageError
from scanner_core.files import check_free, replaced_when_whole, storage_error
from scanner_core.metrology.certificate import Occasion
from scanner_core.metrology.decision import Verdict
from scanner_core.metrology.history import HistoryEntry, append_history, history_path, read_history, rig_sha256
from scanner_core.optics.calibration import StereoCalibration

CERTIFICATE, RESULT = "certificate.pdf", "result.json"
ARTEFACT = "sphere"
"""The specimen that is the reference sphere."""

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a test gave, for every output alike.

    Attributes
    ----------
    values : its part of the JSON
    figures, uncertainties, limits : for the history, um
    parameters : of the procedure, for the certificate
    write : makes the certificate at a path
    interrupted : the test was not finished; what there is stands in `values`
    """

    values: dict[str, object]
    summary: list[str]
    figures: dict[str, float]
    uncertainties: dict[str, float]
    limits: dict[str, float]
    verdict: Verdict | None
    parameters: tuple[tuple[str, str], ...]
    write: Callable[[Occasion, Path], None]
    interrupted: bool = False


@dataclass(frozen=True, slots=True)
class Conditions:
    """What the command line changed of a test.

    Attributes
    ----------
    switched_off : terms of the image model
    faults : as they were given
    specimen : what was put down as the reference sphere; None in the other tests and on hardware
    replayed : the recording whose frames were measured again
    """

    switched_off: tuple[str, ...]
    faults: tuple[str, ...]
    specimen: str | None
    replayed: str | None = None

    def foreign(self) -> str | None:
        """Why the result says nothing about the rig as its file describes it, or None when it does."""
        reasons = []
        if self.switched_off:
            reasons.append(f"without {', '.join(self.switched_off)} it is another rig")
        if self.faults:
            reasons.append(f"it was disturbed by {', '.join(self.faults)}")
        if self.specimen not in (None, ARTEFACT):
            reasons.append(f"the specimen '{self.specimen}' is not the reference sphere")
        if self.replayed is not None:
            reasons.append(f"it was measured from the recording {self.replayed}")
        return "; ".join(reasons) or None

    def parameters(self, config: RigConfig) -> tuple[tuple[str, str], ...]:
        """The same for the certificate, with what the rig file says of the image model."""
        off = config.image_model.get("without", ())
        numbers = [f"{name} {value:g}" for name, value in config.image_model.items() if name != "without"]
        facts = (
            ("Switched off", ", ".join(off)),
            ("Image model", ", ".join(numbers)),
            ("Faults", ", ".join(self.faults)),
            ("Replayed", self.replayed or ""),
            ("Specimen", "" if self.specimen in (None, ARTEFACT) else self.specimen or ""),
        )
        return tuple((label, value) for label, value in facts if value)


class Bar:
    """The progress of a test with the time left, from the pace so far."""

    def __init__(self, console: Console, phase: str) -> None:
        self._console, self._phase = console, phase
        self._began_s = time.monotonic()
        self._done = 0

    def add(self, count: int, whole: int) -> None:
        """`count` more of `whole` are done."""
        self._done += count
        self.to(self._done / whole)

    def to(self, fraction: float) -> None:
        """This share is done."""
        spent_s = time.monotonic() - self._began_s
        left_s = spent_s * (1 - fraction) / fraction if fraction > 0.02 else None
        self._console.progress(self._phase, fraction, left_s)


def part(result: Callable[[], T], done: int = 1) -> T:
    """The result of what was measured before an interrupt; the interrupt goes on when that is nothing."""
    if not done:
        raise KeyboardInterrupt
    try:
        return result()
    except ImprontaError:
        raise KeyboardInterrupt from None


@dataclass(frozen=True, slots=True, eq=False)
class Session:
    """One run of a test: on what, and where its results go."""

    console: Console
    config: RigConfig
    rig: str
    calibration: StereoCalibration
    test: str
    seed: int
    folder: Path | None
    force: bool
    conditions: Conditions
    warnings: list[str]
    began_s: float

    @classmethod
    def prepare(
        cls,
        console: Console,
        config: RigConfig,
        rig: str,
        calibration: StereoCalibration,
        test: str,
        seed: int,
        out: str | None,
        force: bool,
        *,
        conditions: Conditions,
        warnings: list[str],
    ) -> Session:
        """Make the folder, and refuse before the measurement what would be refused after it.

        Raises
        ------
        StorageError
        """
        folder = None
        if out is not None:
            folder = Path(out).resolve()
            try:
                folder.mkdir(parents=True, exist_ok=True)
            except FileExistsError as fault:
                raise StorageError("E-DISK-02", path=folder, reason="it is a file") from fault
            except OSError as fault:
                raise storage_error(folder, fault) from fault
            for name in (CERTIFICATE, RESULT):
                check_free(folder / name, force)
        return cls(console, config, rig, calibration, test, seed, folder, force, conditions, warnings, time.monotonic())

    def finish(self, outcome: Outcome) -> None:
        """History, certificate, JSON and summary of a whole test."""
        date = _now()
        entry = HistoryEntry(
            date=date,
            test=self.test,
            figures=outcome.figures,
            uncertainties=outcome.uncertainties,
            limits=outcome.limits,
            verdict="" if outcome.verdict is None else outcome.verdict.value,
            calibration_id=self.calibration.identity(),
            calibration_date=self.calibration.date,
            rig_sha256=rig_sha256(self.config),
            seed=self.seed,
        )
        history, kept_in, left_out = self._remember(entry)
        values = self._values(date, outcome, "completed") | {"history": kept_in, "history_left_out": left_out}
        summary = list(outcome.summary)
        if left_out is not None:
            summary.append(f"Not added to the rig's history: {left_out}.")
        if self.folder is not None:
            source = self.rig if self.config.name == self.rig else Path(self.rig).name
            parameters = (*outcome.parameters, *self.conditions.parameters(self.config))
            occasion = Occasion(self.config, source, self.calibration, date, self.seed, parameters, tuple(history))
            with replaced_when_whole(self.folder / CERTIFICATE, self.force) as partial_file:
                outcome.write(occasion, partial_file)
            self._write_json(values)
            summary.append(f"Written to {self.folder}: {CERTIFICATE}, {RESULT}.")
        self.console.result(values, summary)

    def keep_part(self, outcome: Outcome) -> None:
        """Of an interrupted test: the JSON of what was measured; neither history nor certificate."""
        values = self._values(_now(), outcome, "cancelled")
        summary = ["Interrupted; what was measured before:", *outcome.summary]
        if self.folder is not None:
            self._write_json(values)
            summary.append(f"Kept in {self.folder / RESULT}; no certificate is made of an unfinished test.")
        self.console.result(values, summary)

    def _values(self, date: str, outcome: Outcome, finish_reason: str) -> dict[str, object]:
        about: dict[str, object] = {
            "test": self.test,
            "finish_reason": finish_reason,
            "rig": self.config.name,
            "rig_file": self.rig,
            "rig_sha256": rig_sha256(self.config),
            "virtual": self.config.virtual,
            "image_model": dict(self.config.image_model),
            "faults": list(self.conditions.faults),
            "specimen": self.conditions.specimen,
            "replayed": self.conditions.replayed,
            "warnings": self.warnings,
            "calibration": {"id": self.calibration.identity(), "date": self.calibration.date},
            "date": date,
            "seed": self.seed,
            "program": __version__,
        }
        return about | outcome.values | {"seconds": round(time.monotonic() - self.began_s, 2)}

    def _remember(self, entry: HistoryEntry) -> tuple[list[HistoryEntry], str | None, str | None]:
        """Append to the rig's history; where that is not possible or not right, go on with this result alone.

        Returns
        -------
        The results to show, the file that they are kept in, and why this one is not kept.
        """
        if (foreign := self.conditions.foreign()) is not None:
            return [entry], None, foreign
        path = history_path(self.rig)
        try:
            append_history(path, entry)
            return read_history(path, self.test), str(path), None
        except StorageError as error:
            self.console.say(f"The history was not kept: {error}")
            return [entry], None, error.message.rstrip(".")

    def _write_json(self, values: dict[str, object]) -> None:
        if self.folder is not None:
            with replaced_when_whole(self.folder / RESULT, self.force) as partial_file:
                partial_file.write_text(json.dumps(values, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def _now() -> str:
    return wall_clock.stamp()
