"""The whole job in real time on devices that are not the program's own: a board behind a socket, two network cameras.

`doctor` finds and checks them and writes a rig file, `calibrate` asks for board and bar (a scripted hand shows them), `scan` measures
the sphere, recorded; then once more, interrupted and resumed; then the recording is replayed.  Every command is the program itself,
a process of its own.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import numpy as np

from scanner_core.case.store import CaseStore
from scanner_core.devices.rig import load_rig
from scanner_core.geometry.fitting import fit_sphere
from scanner_core.virtual.specimens import load_specimen
from tests.core.devices.live_bench import LiveBench, live_bench
from tests.system.impronta import command, environment, impronta

BAR_MM = 150.0
_ASKED = re.compile(r"(Hold the board into|Hold the length bar into|Lay the board flat|Take the board away)(?:.*\((\d+) of (\d+)\))?")
_INTERRUPTED_AT = 0.5
"""Of the time that the whole scan took, its start included."""


class ScriptedHand:
    """Shows what a command asks for, as soon as it asks."""

    def __init__(self, live: LiveBench) -> None:
        self._operator = live.bench.board_operator()

    def obey(self, line: str) -> None:
        """One line of what the command says."""
        asked = _ASKED.search(line)
        if asked is None:
            return
        what, index, count = asked.groups()
        if what == "Hold the board into":
            self._operator.show(int(index) - 1, int(count))
        elif what == "Hold the length bar into":
            self._operator.show_bar(int(index) - 1, int(count))
        elif what == "Lay the board flat":
            self._operator.lay_on_table()
        else:
            self._operator.remove()


def calibrate(live: LiveBench, rig: Path, out: Path) -> dict[str, object]:
    """Run ``impronta calibrate`` to its end; its JSON."""
    hand, said, began_s = ScriptedHand(live), [], time.monotonic()
    words = command("calibrate", "--rig", rig, "--out", out, "--length-mm", BAR_MM, "--json")
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment()) as process:
        assert process.stderr is not None
        assert process.stdout is not None
        for line in process.stderr:
            said.append(line)
            print(f"{time.monotonic() - began_s:6.1f} s  {line.rstrip()}", file=sys.stderr, flush=True)
            hand.obey(line)
        told = process.stdout.read()
    if process.returncode:
        raise RuntimeError("".join(said[-5:]))
    return dict(json.loads(told))


def write_plan(path: Path, views: int, points: int) -> Path:
    """For the sphere."""
    sphere = load_specimen("sphere")
    path.write_text(
        f"views = {views}\npoints = {points}\nobject_radius_mm = {sphere.radius_mm}\nobject_height_mm = {sphere.height_mm}\n", encoding="utf-8"
    )
    return path


def sphere_of(case: Path, folder: Path) -> dict[str, object]:
    """Radius and scatter of a case's points."""
    path = folder / f"{case.stem}.xyz"
    outcome = impronta("export", case, "--out", path, "--force")
    if outcome.code:
        raise RuntimeError(outcome.err)
    fit = fit_sphere(np.loadtxt(path)[:, :3])
    return {"radius_mm": round(fit.radius_mm, 4), "rms_um": round(1e3 * float(np.sqrt((fit.residuals_mm**2).mean())), 1)}


def interrupt(words: list[str], after_s: float) -> int:
    """Start a scan and press Ctrl-C; its exit code."""
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment()) as process:
        time.sleep(after_s)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
    return process.returncode


def _observations(case: Path) -> int:
    with CaseStore.open(case, read_only=True) as store:
        return sum(len(store.observations(scan.id)) for scan in store.scans() if scan.kind == "scan")


def run(folder: Path, *, views: int, points: int, rate_hz: float, seed: int) -> Iterator[dict[str, object]]:
    """Everything, a result a step."""
    plan = write_plan(folder / "plan.toml", views, points)
    with live_bench(rate_hz=rate_hz, seed=seed) as live:
        yield from _commission(live, folder)
        rig = folder / "calibrated.toml"
        began_s = time.monotonic()
        result = calibrate(live, folder / "rig.toml", rig)
        yield {"calibrate": {key: result[key] for key in sorted(result) if not isinstance(result[key], list | dict)}, **_took(began_s)}
        yield _checked("doctor_calibrated", "--rig", rig)
        yield from scans(rig, plan, folder)


def scans(rig: Path, plan: Path, folder: Path) -> Iterator[dict[str, object]]:
    """A whole scan, recorded and replayed, and one that is interrupted and resumed."""
    began_s = time.monotonic()
    yield _scan("scan", folder, "--rig", rig, "--plan", plan, "--record", folder / "recording", case=folder / "live.impronta")
    took_s = time.monotonic() - began_s
    yield _scan("replayed", folder, "--replay", folder / "recording", case=folder / "replayed.impronta")
    yield {"replay_equals": _tables_equal(folder / "live.impronta", folder / "replayed.impronta")}
    case = folder / "interrupted.impronta"
    code = interrupt(command("scan", "--rig", rig, "--plan", plan, "--out", case), _INTERRUPTED_AT * took_s)
    yield {"interrupted": code, "points": _observations(case)}
    yield _scan("resumed", folder, "--rig", rig, "--resume", case=case)


def _commission(live: LiveBench, folder: Path) -> Iterator[dict[str, object]]:
    where = [word for url in live.urls for word in ("--camera", url)]
    yield _checked("doctor_find", "--port", live.board.url, *where, "--out", folder / "rig.toml")
    found = load_rig(folder / "rig.toml")
    yield {"units_per_deg": found.controller.units_per_deg, "cameras": [found.left.id, found.right.id]}


def _checked(name: str, *words: object) -> dict[str, object]:
    began_s = time.monotonic()
    outcome = impronta("doctor", *words, "--json")
    if not outcome.out:
        return {name: outcome.code, "said": outcome.err}
    checks = outcome.json()["checks"]
    assert isinstance(checks, list)
    lines = [f"{check['verdict']} {check['name']}: {check['detail']} {check['remedy']}" for check in checks if check["verdict"] != "pass"]
    return {name: outcome.code, "checks": len(checks), "not_passed": lines, **_took(began_s)}


def _scan(name: str, folder: Path, *words: object, case: Path) -> dict[str, object]:
    began_s = time.monotonic()
    outcome = impronta("scan", *words, "--out", case, "--json", timeout_s=1800)
    if outcome.code or not outcome.out:
        return {name: outcome.code, "said": outcome.err[-2000:], **_took(began_s)}
    told = outcome.json()
    kept = ("planned", "measured", "rejected", "skipped", "rate_hz", "warnings")
    return {name: outcome.code, **{key: told[key] for key in kept}, **sphere_of(case, folder), **_took(began_s)}


def _tables_equal(one: Path, other: Path) -> bool:
    tables = []
    for case in (one, other):
        with CaseStore.open(case, read_only=True) as store:
            tables.append(store.observations([scan for scan in store.scans() if scan.kind == "scan"][-1].id))
    return all(np.array_equal(getattr(tables[0], column.name), getattr(tables[1], column.name)) for column in fields(tables[0]))


def _took(began_s: float) -> dict[str, object]:
    return {"wall_s": round(time.monotonic() - began_s, 1), "load": round(os.getloadavg()[0], 1)}
