"""One row at a time: draw the clouds, let ours and the peers work on the same ones, measure, and sum up over the draws."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from tests.bench.reconstruction import work
from tests.bench.reconstruction.bodies import SPHERE_RADIUS_MM
from tests.bench.reconstruction.clouds import scan
from tests.bench.reconstruction.measure import errors, nothing_um, soundness, z_score_sd
from tests.bench.reconstruction.peers import Peer
from tests.bench.reconstruction.rows import Row
from tests.bench.reconstruction.statistics import mean, ratio
from tests.bench.reconstruction.truth import SURFACES, truth

Result = dict[str, Any]


def run_draw(row: Row, draw: int, cache: Path, with_peers: bool) -> Result:
    """All meshes of one cloud: ``ours`` and, by their labels, the ``peers``."""
    true, to_truth = truth(row.scan.surface, cache)
    how = row.scan.drawn(draw)
    points = scan(SURFACES[how.surface], true, how)

    def measured(made: work.Made) -> Result:
        told: Result = {"seconds": made.seconds, "process_seconds": made.process_seconds, "peak_memory_mb": made.peak_memory_mb}
        if made.mesh is None:
            return {"failure": made.failure, **told}
        told |= errors(true, to_truth, made.mesh, how.scanned) | soundness(made.mesh)
        if row.scan.surface == "sphere":
            told["radius_bias_um"] = 1e3 * (np.cbrt(3 * abs(told["volume_mm3"]) / (4 * np.pi)) - SPHERE_RADIUS_MM)
        if made.report:
            told |= {"z_score_sd": z_score_sd(to_truth, made.mesh, how.scanned), "report": made.report}
            told["expected_rms_um"] = made.report["expected_error_rms_um"]
        return told

    return {
        "draw": draw,
        "seed": how.seed,
        "points": len(points),
        "nothing_um": nothing_um(to_truth, points),
        "ours": measured(work.ours(points, row.triangles)),
        "peers": {peer.label: measured(work.theirs(peer, points)) for peer in row.peers} if with_peers else {},
    }


def sum_up(row: Row, draws: list[Result]) -> Result:
    """The row of the table: means over the draws, and the best peer, which is the one with the lowest mean surface error."""
    ours = [draw["ours"] for draw in draws]
    failures = [str(told["failure"]) for told in ours if "failure" in told]
    summary: Result = {"row": row.name, "held_out": row.held_out, "draws": len(draws), "nothing_um": _mean(draws, "nothing_um")}
    summary["peers"] = {peer.label: _peer(peer, draws) for peer in row.peers} if draws[0]["peers"] else {}
    if failures:
        return summary | {"failure": failures[0], "failures": len(failures)}
    means = ("surface_rms_um", "surface_p95_um", "vertex_rms_um", "complete_rms_um", "bias_um", "expected_rms_um", "z_score_sd", "triangles")
    summary |= {key: _mean(ours, key) for key in (*means, "seconds", "process_seconds")}
    summary |= {
        "surface_standard_error_um": mean(_values(ours, "surface_rms_um")).standard_error,
        "complete_over_surface": ratio(_values(ours, "complete_rms_um"), _values(ours, "surface_rms_um")).value,
        "expected_over_true": ratio(_values(ours, "expected_rms_um"), _values(ours, "surface_rms_um")).value,
        "closed": all(told["closed"] for told in ours),
        "genus": sorted({str(told["genus"]) for told in ours}),
        "self_intersections": max(_values(ours, "self_intersections")),
        "quality_min": min(_values(ours, "quality_min")),
        "peak_memory_mb": max(_values(ours, "peak_memory_mb")),
    }
    if row.scan.surface == "sphere":
        summary["radius_bias_um"] = asdict(mean(_values(ours, "radius_bias_um")))
    peers = summary["peers"]
    finished = {label: told for label, told in peers.items() if "failure" not in told}
    if finished:
        best = min(finished, key=lambda label: finished[label]["surface_rms_um"])
        theirs = [draw["peers"][best] for draw in draws]
        for key in ("surface", "complete"):
            summary[f"{key}_ratio"] = asdict(ratio(_values(ours, f"{key}_rms_um"), _values(theirs, f"{key}_rms_um")))
        summary |= {"best_peer": best, "peer_surface_rms_um": finished[best]["surface_rms_um"]}
    return summary


def compare_to_clean(summaries: dict[str, Result], rows: Iterable[Row]) -> None:
    """Put the error over that of the clean cloud into the summaries of rows that have a reference."""
    for row in rows:
        told, clean = summaries.get(row.name), summaries.get(row.reference or "")
        if told and clean and "failure" not in told and "failure" not in clean:
            told["over_clean"] = told["surface_rms_um"] / clean["surface_rms_um"]


def _peer(peer: Peer, draws: list[Result]) -> Result:
    told = [draw["peers"][peer.label] for draw in draws]
    failures = [one["failure"] for one in told if "failure" in one]
    if failures:
        return {"failure": failures[0], "failures": len(failures)}
    summary: Result = {
        key: _mean(told, key) for key in ("surface_rms_um", "vertex_rms_um", "complete_rms_um", "bias_um", "triangles", "seconds", "process_seconds")
    }
    summary["self_intersections"] = max(_values(told, "self_intersections"))
    summary["closed"] = all(one["closed"] for one in told)
    summary["components"] = max(_values(told, "components"))
    summary["quality_min"] = min(_values(told, "quality_min"))
    if "radius_bias_um" in told[0]:
        summary["radius_bias_um"] = asdict(mean(_values(told, "radius_bias_um")))
    return summary


def _values(told: list[Result], key: str) -> list[float]:
    return [float(one[key]) for one in told]


def _mean(told: list[Result], key: str) -> float:
    return float(np.mean(_values(told, key)))
