"""The report of ``demo``: one page, nothing over anything else, a picture of the mesh in it."""

from __future__ import annotations

import re
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from scanner_core.commands.demo_report import demo_page, write_demo_report
from scanner_core.geometry.icosahedron import icosahedron
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.geometry.subdivision import subdivide_uniform
from scanner_core.metrology.certificate_page import page_style

VALUES: dict[str, Any] = {
    "specimen": "sphere",
    "preset": "paper-2003",
    "seed": 7,
    "points": 20000,
    "views": 16,
    "planned": 30697,
    "measured": 20000,
    "rejected": {"ambiguous": 3, "elongated": 1, "epipolar": 6, "hidden_left": 633, "hidden_right": 827, "no_spot": 1974, "too_small": 9},
    "skipped": 7240,
    "case": "case.impronta",
    "calibration": {
        "views": 20,
        "reprojection_rms_px": 0.0187,
        "held_out_rms_um": 13.4,
        "axis_position_rms_um": 1.1,
        "axis_angle_rms_deg": 0.0009,
    },
    "registration": {"applied": False, "residual_before_um": 41.9, "residual_after_um": 41.9},
    "reconstruct": {
        "triangles": 20000,
        "closed": True,
        "genus": 0,
        "supported_area_fraction": 0.82,
        "residual_rms_um": 35.6,
        "expected_error_rms_um": 41.0,
        "outliers_rejected": 8,
        "phases": [{"name": name, "seconds": 12.7, "triangles": 20000} for name in ("inflate", "refine", "smooth")],
        "warnings": ["18 % of the closed surface was not scanned; it is capped and marked as unsupported."],
    },
    "error_vs_truth_um": {"points_rms": 40.7, "mesh_rms": 39.0, "mesh_p95": 57.5, "mesh_max": 613.4},
}


def _scanned() -> tuple[PointCloud, TriangleMesh]:
    mesh = icosahedron((0, 0, 13), 11.0)
    for _ in range(3):
        mesh = subdivide_uniform(mesh)
    up = mesh.vertices[:, 2] > 8
    told: dict[str, Any] = {"standard_uncertainty_um": np.linspace(5, 50, len(up)).astype(np.float32), "supported": up.astype(np.uint8)}
    cloud = PointCloud(mesh.vertices, views=np.arange(len(up), dtype=np.int32) % 16)
    return cloud, TriangleMesh(mesh.vertices, mesh.triangles, told)


def test_the_report_is_one_page_with_a_picture(tmp_path: Path) -> None:
    write_demo_report(tmp_path / "report.pdf", VALUES, *_scanned())
    content = (tmp_path / "report.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", content)) == 1
    assert b"/Subtype /Image" in content


STEERED = {
    "until_um": 40.0,
    "passes": [{"kind": "coarse"}, {"kind": "steered"}, {"kind": "uniform"}],
    "coverage": {"reachable_within_fraction": 0.981},
}


@pytest.mark.parametrize("more", [{}, STEERED], ids=["uniform", "error-driven"])
def test_nothing_of_the_report_lies_over_anything_else(more: dict[str, Any]) -> None:
    with page_style():
        figure = demo_page(VALUES | more, *_scanned()).figure
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        pixels = np.asarray(canvas.buffer_rgba())[:, :, :3]
        texts = [text for text in figure.findobj(Text) if isinstance(text, Text) and text.get_visible() and text.get_text().strip()]
        boxes = [(text.get_text(), text.get_window_extent(canvas.get_renderer()).shrunk(0.98, 0.8)) for text in texts]
    assert [words for words, box in boxes if box.width > 0 and (box.x0 < 0 or box.x1 > figure.bbox.width)] == []
    words = re.compile(r"[a-zA-Z]{2}")
    over = [(a, b) for (a, first), (b, second) in combinations(boxes, 2) if words.search(a) and words.search(b) and first.overlaps(second)]
    assert over == []
    height, width, _ = pixels.shape
    picture = pixels[int(0.38 * height) : int(0.7 * height), int(0.1 * width) : int(0.45 * width)].reshape(-1, 3)
    assert len(np.unique(picture, axis=0)) > 20  # shades of the body, not one flat colour
