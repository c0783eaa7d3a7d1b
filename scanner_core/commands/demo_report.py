"""The report of ``demo``: one page with what was scanned, how well, and a picture of the mesh, without a window."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from scanner_core import __version__, wall_clock
from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.geometry.point_cloud import PointCloud
from scanner_core.metrology.certificate_page import BLUE, GREY, HEIGHT_MM, MARGIN_MM, ORANGE, WIDTH_MM, Page, page_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

_AZIMUTH_DEG, _ELEVATION_DEG = 35.0, 22.0
"""Where the first picture is taken from; the second is taken from the other side."""
_LIGHT = np.array([-0.35, 0.55, 0.76])
"""Direction to the light, in the picture's frame: right, up, towards the eye."""


def write_demo_report(path: Path, values: Mapping[str, Any], cloud: PointCloud, mesh: TriangleMesh) -> None:
    """Write the report as a PDF.

    Parameters
    ----------
    values : the JSON of ``demo``
    cloud : the registered points, object frame
    mesh : the reconstructed surface
    """
    with page_style():
        demo_page(values, cloud, mesh).save(path, f"Report: {values['specimen']}")


def demo_page(values: Mapping[str, Any], cloud: PointCloud, mesh: TriangleMesh) -> Page:
    page = Page()
    calibration, registration, surface = values["calibration"], values["registration"] or {}, values["reconstruct"]
    page.heading(f"Report: {values['specimen']}", "Scanned on the virtual rig (simulated light), registered and reconstructed", None)
    page.facts(
        (
            ("Date", wall_clock.stamp().replace("T", " ")),
            ("Program", f"Impronta {__version__}"),
            ("Rig", f"preset '{values['preset']}', virtual"),
            ("Seed", str(values["seed"])),
        )
    )
    page.section("Scan")
    rejected = sum(values["rejected"].values())
    page.facts(
        (
            ("Points", f"{values['points']:,} from {values['views']} views"),
            ("Planned", f"{values['planned']:,}: {rejected:,} rejected, {values['skipped']:,} skipped"),
            ("Calibration", f"{calibration['views']} views, {calibration['reprojection_rms_px']:.3f} px reprojection"),
            ("Its residual", f"{calibration['held_out_rms_um']:.1f} µm on held-out corners"),
            ("Turntable axis", f"{calibration['axis_position_rms_um']:.1f} µm, {calibration['axis_angle_rms_deg']:.4f}° rms"),
            ("Registration", _registration(registration)),
            *_marks(values),
            *_steering(values),
        )
    )
    page.section("Surface")
    page.facts(
        (
            ("Triangles", f"{surface['triangles']:,}, {'closed' if surface['closed'] else 'open'}, genus {surface['genus']}"),
            ("Supported", f"{100 * surface['supported_area_fraction']:.1f} % of the surface by data"),
            ("Residual", f"{surface['residual_rms_um']:.1f} µm rms, points to mesh"),
            ("Expected error", f"{surface['expected_error_rms_um']:.1f} µm rms"),
            ("Duration", f"{sum(phase['seconds'] for phase in surface['phases']):.1f} s in {len(surface['phases'])} phases"),
            ("Outliers", f"{surface['outliers_rejected']:,} points left out"),
        )
    )
    error = values.get("error_vs_truth_um")
    if error is not None:
        page.section("Against the truth")
        page.facts(
            (
                ("Points", f"{error['points_rms']:.1f} µm rms"),
                ("Surface", f"{error['mesh_rms']:.1f} µm rms"),
                ("95 % below", f"{error['mesh_p95']:.1f} µm"),
                ("Worst", f"{error['mesh_max']:.1f} µm"),
            )
        )
    for warning in surface["warnings"]:
        page.paragraph(f"Note: {warning}", 7.5)
    _plots(page, values, cloud, mesh)
    page.footer(f"{values['case']}", "page 1 of 1")
    return page


def _steering(values: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Of an error-driven scan."""
    if "passes" not in values:
        return []
    kinds = [one["kind"] for one in values["passes"]]
    steered = f"a coarse one and {kinds.count('steered')} where the surface was uncertain"
    told = [("Passes", steered if "uniform" not in kinds else f"{steered}, the rest spread evenly")]
    if values["coverage"] is not None:
        within = 100 * values["coverage"]["reachable_within_fraction"]
        told.append((f"Within {values['until_um']:g} µm", f"{within:.1f} % of what can be measured"))
    return told


def _marks(values: Mapping[str, Any]) -> list[tuple[str, str]]:
    marks = values.get("marks")
    if marks is None or marks["marks_um"] is None:
        return []
    return [("Marks on the rim", f"{marks['marks_um']:.1f} µm rms, {marks['visits']} visits, against {marks['reference']} distances")]


def _registration(registration: Mapping[str, Any]) -> str:
    if not registration:
        return "none"
    if not registration["applied"]:
        return f"table alone, {registration['residual_before_um']:.1f} µm between views"
    return f"{registration['residual_before_um']:.1f} µm before, {registration['residual_after_um']:.1f} µm after"


def _plots(page: Page, values: Mapping[str, Any], cloud: PointCloud, mesh: TriangleMesh) -> None:
    top, bottom = page.y_mm + 4, HEIGHT_MM - 18.0
    low = 38.0
    tall = bottom - top - low - 22.0
    width = 0.5 * (WIDTH_MM - 2 * MARGIN_MM - 8)
    uncertainty = np.asarray(mesh.vertex_attributes.get("standard_uncertainty_um", np.zeros(len(mesh.vertices))), np.float64)
    supported = np.asarray(mesh.vertex_attributes.get("supported", np.ones(len(mesh.vertices))), np.float64) > 0
    high = float(np.percentile(uncertainty[supported], 98)) if supported.any() else 1.0
    shaded = _picture(page, MARGIN_MM, top, width, tall, "The surface")
    draw_mesh(shaded, mesh, _AZIMUTH_DEG, np.full((len(mesh.triangles), 3), 0.86))
    told = _picture(page, MARGIN_MM + width + 8, top, width - 10, tall, "Standard uncertainty, from the other side")
    draw_mesh(told, mesh, _AZIMUTH_DEG + 180, _coloured(mesh, uncertainty, supported, high))
    _scale(page, WIDTH_MM - MARGIN_MM - 8, top + 0.2 * tall, 0.6 * tall, high)

    y = top + tall + 12
    tally = page.axes(MARGIN_MM + 24, y, width - 24, low, "Planned measurements", "count", "")
    counts = {"measured": values["measured"], **dict(sorted(values["rejected"].items(), key=lambda item: -item[1])), "skipped": values["skipped"]}
    names = [name.replace("_", " ") for name in counts]
    tally.barh(range(len(counts)), list(counts.values()), 0.7, color=[BLUE, *([ORANGE] * (len(counts) - 2)), GREY])
    tally.set_yticks(range(len(counts)), names)
    tally.invert_yaxis()
    per_view = page.axes(MARGIN_MM + width + 8 + 11, y, width - 11, low, "Points by view", "view", "points")
    views = np.zeros(len(cloud), np.int32) if cloud.views is None else cloud.views
    found = np.bincount(views, minlength=int(values["views"]))
    per_view.bar(np.arange(1, len(found) + 1), found, 0.75, color=BLUE, alpha=0.8)


def _picture(page: Page, x_mm: float, y_mm: float, width_mm: float, height_mm: float, title: str) -> Axes:
    page.text(x_mm, y_mm - 1.5, title, 8, bold=True)
    axes = page.axes(x_mm, y_mm, width_mm, height_mm, "", "", "")
    axes.set_axis_off()
    return axes


def draw_mesh(axes: Axes, mesh: TriangleMesh, azimuth_deg: float, colours: Array) -> None:
    """The mesh from a direction, in parallel projection, facets shaded and painted from back to front.

    Parameters
    ----------
    azimuth_deg : of the eye, about +z from +x
    colours : (t, 3) of the facets in full light, 0 to 1
    """
    from matplotlib.collections import PolyCollection

    a, e = np.radians(azimuth_deg), np.radians(_ELEVATION_DEG)
    eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    frame = np.stack([right, np.cross(eye, right), eye])
    corners = mesh.vertices[mesh.triangles] @ frame.T
    normals = mesh.area_vectors() @ frame.T
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-30)[:, None]
    seen = np.flatnonzero(normals[:, 2] > 0)
    seen = seen[np.argsort(corners[seen, :, 2].mean(axis=1))]
    light = 0.35 + 0.65 * np.clip(normals[seen] @ (_LIGHT / np.linalg.norm(_LIGHT)), 0, 1)
    painted = np.clip(colours[seen] * light[:, None], 0, 1)
    axes.add_collection(PolyCollection(corners[seen][:, :, :2], facecolors=painted, edgecolors=painted, linewidths=0.15, rasterized=True))
    low, high = corners[:, :, :2].min(axis=(0, 1)), corners[:, :, :2].max(axis=(0, 1))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", adjustable="box")


def _coloured(mesh: TriangleMesh, values: Array, supported: NDArray[np.bool_], high: float) -> Array:
    """Colours of the facets by the mean of their corners; grey where no data supports them."""
    from matplotlib import colormaps

    share = values[mesh.triangles].mean(axis=1) / max(high, 1e-9)
    colours = np.asarray(colormaps["viridis"](np.clip(share, 0, 1)), np.float64)[:, :3]
    colours[~supported[mesh.triangles].all(axis=1)] = 0.75
    return colours


def _scale(page: Page, x_mm: float, y_mm: float, height_mm: float, high: float) -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    axes = page.figure.add_axes((x_mm / WIDTH_MM, 1 - (y_mm + height_mm) / HEIGHT_MM, 2.6 / WIDTH_MM, height_mm / HEIGHT_MM))
    bar = page.figure.colorbar(ScalarMappable(Normalize(0, high), "viridis"), cax=axes)
    bar.ax.tick_params(labelsize=6.5, length=2, width=0.4, pad=1.5)
    bar.ax.set_title("µm", fontsize=7, pad=3)
    bar.outline.set_linewidth(0.4)
