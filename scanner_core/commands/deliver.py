"""``impronta deliver``: checks of a case's surface, and its files for the laboratory with a certificate."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core import wall_clock
from scanner_core.case.processing import case_cloud
from scanner_core.case.store import CaseStore
from scanner_core.commands.console import Console
from scanner_core.delivery.check import Check, CheckVerdict, Readiness
from scanner_core.delivery.delivering import deliver, keep_delivery
from scanner_core.delivery.examining import examine
from scanner_core.delivery.file_name import DEFAULT_TEMPLATE, free_stem
from scanner_core.delivery.own_profiles import own_profiles, wanted_profile
from scanner_core.delivery.profile import default_profile

NOT_READY = 3
"""Exit code: it was checked, and is not ready to be delivered."""
_SIGNS = {CheckVerdict.PASS: "ok", CheckVerdict.WARN: "remark", CheckVerdict.FAIL: "FAIL", CheckVerdict.OPEN: "-"}


def run(given: argparse.Namespace, console: Console) -> int:
    """The JSON object holds ``verdict``, ``checks``, and ``delivery`` (null when nothing was written)."""
    own = own_profiles()
    asked = None if given.profile is None else wanted_profile(given.profile, own)
    with CaseStore.open(Path(given.case), read_only=given.out is None) as store:
        found = examine(store, progress=lambda step: console.progress("checking", step.fraction))
        lines = [_line(check) for check in found.checks]
        told: dict[str, object] = {"verdict": found.verdict.value, "checks": [check.as_dict() for check in found.checks], "delivery": None}
        lines.append(f"Verdict: {found.verdict.value}.")
        ready = found.verdict is not Readiness.NOT_READY
        if given.out is None or not (ready or given.anyway):
            lines += [] if given.out is None else ["Nothing was written; --anyway delivers it, and the certificate says so."]
            console.result(told, lines)
            return 0 if ready else NOT_READY
        profile = asked or default_profile(found.facts.order.type)
        template = given.name or profile.template or DEFAULT_TEMPLATE
        folder = Path(given.out).resolve()
        stem = free_stem(folder, template, found.facts.order, profile.suffixes, wall_clock.today())
        cloud = case_cloud(store) if profile.points else None
        made = wall_clock.stamp()
        delivery = deliver(found, profile, folder, stem, made=made, cloud=cloud, replace=given.force, anyway=given.anyway)
        keep_delivery(store, delivery)
    lines += [f"Written: {folder / name}" for name in delivery.files]
    console.result(told | {"delivery": delivery.as_dict()}, lines)
    return 0


def _line(check: Check) -> str:
    return f"{_SIGNS[check.verdict]:>6}  {check.name:<24} {check.sentence}"
