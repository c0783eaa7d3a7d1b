"""The ranked areas as a table for a spreadsheet (RFC 4180)."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import above_null

COLUMNS = (
    *("rank", "words", "centroid_x_mm", "centroid_y_mm", "centroid_z_mm", "area_mm2", "mean_um", "p95_um", "max_um", "volume_mm3", "parts"),
    *("motion_mm", "motion_expanded_uncertainty_k2_mm", "rotation_deg", "rotation_expanded_uncertainty_k2_deg", "above_null_level"),
)
"""Names and units of the columns; places in the frame of BEFORE, deviations of AFTER against BEFORE, + outward, uncertainties with k = 2."""


def write_table(comparison: Comparison, path: Path) -> None:
    """Write one line for each area.

    UTF-8 with a byte order mark, without which spreadsheets take it for the system's own code page; lines end in CR LF.
    What is not known is empty.
    """
    with path.open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.writer(file, lineterminator="\r\n")
        writer.writerow(COLUMNS)
        for area in comparison.areas:
            x, y, z = (f"{value:.3f}" for value in area.centroid_mm)
            figures = [f"{area.area_mm2:.3f}", f"{area.mean_um:.1f}", f"{area.p95_um:.1f}", f"{area.max_um:.1f}", f"{area.volume_mm3:.3f}"]
            motion = [""] * 4
            if area.motion is not None:
                m = area.motion
                motion = [f"{np.linalg.norm(m.displacement_mm):.4f}", f"{2e-3 * m.displacement_uncertainty_um:.4f}"]
                motion += [f"{m.angle_deg:.3f}", f"{2 * m.angle_uncertainty_deg:.3f}"]
            above = {None: "", True: "yes", False: "no"}[above_null(area, comparison)]
            writer.writerow([area.rank, harmless(area.words), x, y, z, *figures, area.parts, *motion, above])


def harmless(words: str) -> str:
    """Text that no spreadsheet takes for a formula: an apostrophe is set before what begins like one."""
    return f"'{words}" if words.startswith(("=", "+", "-", "@", "\t", "\r", "\n")) else words
