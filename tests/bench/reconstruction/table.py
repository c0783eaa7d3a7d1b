"""The table for people: one line a row, and what does not fit into it below."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

_LAYOUT = "{:<23} {:>7} {:>7} {:>8} {:<22.22} {:>7} {:>6} {:>6} {:>6} {:>6} {:>9} {:>6} {:>5} {:>5} {:>6} {:>7} {:>5} {:>6} {:>6} {:>6}"

HEADER = "\n".join(
    _LAYOUT.format(*words)
    for words in (
        ("rms, um; means of draws", "raw", "surface", "complete", "best peer", "its", "ratio", "upper", "compl.", "bias", "triangles", "closed",
         "genus", "self-", "worst", "expect-", "z sd", "over", "s", "MB"),
        ("", "points", "", "", "", "surface", "", "95 %", "/surf.", "", "", "", "", "int.", "qual.", "ed", "", "clean", "", ""),
    )
)  # fmt: skip


def lines(summary: Mapping[str, Any]) -> Iterator[str]:
    """One row, and a line for each thing that is not like the rest."""
    if "failure" in summary:
        yield f"{summary['row']:<23} {summary['nothing_um']:>7.1f} failed in {summary['failures']} of {summary['draws']} draws: {summary['failure']}"
    else:
        ratio = summary.get("surface_ratio", {})
        yield _LAYOUT.format(
            summary["row"] + ("*" if summary["held_out"] else ""), _f(summary["nothing_um"]), _f(summary["surface_rms_um"]),
            _f(summary["complete_rms_um"]), summary.get("best_peer", "-"), _f(summary.get("peer_surface_rms_um")),
            _f(ratio.get("value"), 3), _f(ratio.get("upper_95"), 3), _f(summary["complete_over_surface"], 3), f"{summary['bias_um']:+.1f}",
            f"{summary['triangles']:.0f}", "yes" if summary["closed"] else "NO", "/".join(summary["genus"]),
            f"{summary['self_intersections']:.0f}", f"{summary['quality_min']:.3f}", _f(summary["expected_rms_um"]),
            _f(summary["z_score_sd"], 2), _f(summary.get("over_clean"), 3), _f(summary["seconds"]), f"{summary['peak_memory_mb']:.0f}",
        )  # fmt: skip
    if "radius_bias_um" in summary:
        yield f"    radius from the volume: {_radius(summary['radius_bias_um'])}"
    for label, peer in summary["peers"].items():
        if "failure" in peer:
            yield f"    {label}: failed in {peer['failures']} of {summary['draws']} draws: {peer['failure']}"
            continue
        radius = f", radius {_radius(peer['radius_bias_um'])}" if "radius_bias_um" in peer else ""
        yield (
            f"    {label}: surface {peer['surface_rms_um']:.1f}, complete {peer['complete_rms_um']:.1f}, bias {peer['bias_um']:+.1f}, "
            f"{peer['triangles']:.0f} triangles, {'closed' if peer['closed'] else 'not closed'}, {peer['components']:.0f} components, "
            f"{peer['self_intersections']:.0f} self-int., worst quality {peer['quality_min']:.3f}, {peer['seconds']:.1f} s{radius}"
        )


def _radius(bias: Mapping[str, Any]) -> str:
    return f"{bias['value']:+.2f} um off, standard error {bias['standard_error']:.2f} um ({bias['draws']} draws)"


def _f(value: float | None, digits: int = 1) -> str:
    return "-" if value is None or value != value else f"{value:.{digits}f}"
