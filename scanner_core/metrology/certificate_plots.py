"""The plots of the certificates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from scanner_core.metrology.acceptance import REQUIRED_COVERAGE, AcceptanceResult
from scanner_core.metrology.certificate_page import BLUE, COLOURS, GREEN, GREY, HEIGHT_MM, INK, LINE, MARGIN_MM, WIDTH_MM, Page
from scanner_core.metrology.coverage import spherical_angles_deg
from scanner_core.metrology.decision import Verdict
from scanner_core.metrology.history import HistoryEntry
from scanner_core.metrology.reference_sphere import REQUIRED_COVERAGE_DEG, SphereResult
from scanner_core.metrology.static_statistics import StaticResult

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

ORANGE = "#c4661f"
_AXIS_COLOURS = (BLUE, ORANGE, GREEN)
_AXIS_NAMES = ("x depth", "y vertical", "z lateral")
_GAP_MM, _LEFT_MM, _ABOVE_MM, _BELOW_MM = 9.0, 11.0, 7.0, 9.5
_SHOWN = 6000
"""Points of a scatter plot at most; more only make the file larger."""


def static_plots(page: Page, result: StaticResult, history: Sequence[HistoryEntry]) -> None:
    """Scatter, histogram, drift, dependence on the place, history."""
    frames = _frames(page, (2, 2, 1), (1.0, 0.85, 0.7))
    shown = result.deviations_um[:: max(1, len(result.deviations_um) // _SHOWN)]
    scatter = page.axes(*frames[0], "Scatter about the mean of the stay", "lateral z / µm", "depth x / µm")
    reach = 5 * float(result.sd_um.max())
    scatter.plot(shown[:, 2], shown[:, 0], ".", markersize=2, color=BLUE, alpha=0.35, markeredgewidth=0, rasterized=True)
    _equal(scatter, frames[0][2:], (0.0, 0.0), (reach, reach))

    histogram = page.axes(*frames[1], "Distribution", "deviation / µm", "share per µm")
    edges = np.linspace(-reach, reach, 81)
    for i, (name, colour) in enumerate(zip(_AXIS_NAMES, _AXIS_COLOURS, strict=True)):
        histogram.stairs(np.histogram(result.deviations_um[:, i], edges, density=True)[0], edges, color=colour, linewidth=0.9, label=name)
    histogram.legend(fontsize=6.5, frameon=False, loc="upper right", handlelength=1.2)
    histogram.set(xlim=(-reach, reach), ylim=(0, None))

    drift = page.axes(*frames[2], "Means of a place over time, and the drift", "time / s", "deviation / µm")
    time_s = result.mean_time_s - result.time_s.min()
    for i, colour in enumerate(_AXIS_COLOURS):
        drift.plot(time_s, result.place_means_um[:, i], ".", markersize=2.4, color=colour, alpha=0.5, markeredgewidth=0, rasterized=True)
    along = np.array([0.0, result.duration_s])
    for i, colour in enumerate(_AXIS_COLOURS):
        drift.plot(along, result.drift_um[i] * (along / max(result.duration_s, 1e-9) - 0.5), color=colour, linewidth=1.2)
    limit = 4 * float(np.std(result.place_means_um)) + float(np.abs(result.drift_um).max()) + 1e-6
    drift.set(xlim=(0, max(result.duration_s, 1e-3)), ylim=(-limit, limit))

    places = page.axes(*frames[3], "Standard deviation by place", "share of the places", "s / µm")
    share = (np.arange(result.places) + 0.5) / result.places
    for i, colour in enumerate(_AXIS_COLOURS):
        places.plot(share, np.sort(result.place_sd_um[:, i]), color=colour, linewidth=1.1, marker="." if result.places < 40 else "", markersize=3)
        places.axhline(float(result.sd_um[i]), color=colour, linewidth=0.7, linestyle=(0, (4, 3)))
    places.set(xlim=(0, 1), ylim=(0, None))

    trend = page.axes(*frames[4], "History: standard deviation", "", "s / µm")
    for name, colour in zip(("sd_x", "sd_y", "sd_z"), _AXIS_COLOURS, strict=True):
        _trend(trend, history, name, colour, errors=False)
    _from_zero(trend)
    _dates(trend, history)


def sphere_plots(page: Page, result: SphereResult, history: Sequence[HistoryEntry]) -> None:
    """Residual and coverage map, histogram, radius by acquisition, history of size and dispersion."""
    frames = _frames(page, (2, 2, 2), (1.05, 0.85, 0.7))
    acquisitions = result.acquisitions
    residuals = np.concatenate([a.residuals_um for a in acquisitions])
    polar, azimuth = spherical_angles_deg(np.concatenate([a.directions for a in acquisitions]))
    limit = 2.5 * float(np.std(residuals)) + 1e-9

    chart = page.axes(*frames[0], "Residuals / µm (mean of 5° cells)", "azimuth / deg", "angle from the top / deg")
    _map(page, chart, azimuth, polar, residuals, limit)
    chart.axhline(REQUIRED_COVERAGE_DEG, color=INK, linewidth=0.8, linestyle=(0, (4, 3)))

    density = page.axes(*frames[1], "Coverage (points per square degree)", "azimuth / deg", "angle from the top / deg")
    _density(page, density, azimuth, polar)
    density.axhline(REQUIRED_COVERAGE_DEG, color=INK, linewidth=0.8, linestyle=(0, (4, 3)))

    spread = page.axes(*frames[2], "Residuals", "radial residual / µm", "share per µm")
    reach = 4.5 * float(np.std(residuals)) + 1e-9
    edges = np.linspace(-reach, reach, 71)
    spread.stairs(np.histogram(residuals, edges, density=True)[0], edges, fill=True, color=BLUE, alpha=0.35)
    half = 0.5 * result.dispersion_um
    for x in (-half, half):
        spread.axvline(x, color=ORANGE, linewidth=0.9, linestyle=(0, (4, 3)))
    spread.text(half, 0.97, " D95", fontsize=6.5, color=ORANGE, transform=spread.get_xaxis_transform(), va="top")
    spread.set(xlim=(-reach, reach), ylim=(0, None))

    radii = page.axes(*frames[3], "Radius error by acquisition (U, k = 2)", "acquisition", "error / µm")
    errors = [1e3 * (a.radius_mm - result.reference.value_mm) for a in acquisitions]
    bars = [2e3 * a.radius_uncertainty_mm for a in acquisitions]
    numbers = np.arange(1, len(errors) + 1)
    size = result.characteristics()[0]
    radii.errorbar(numbers, errors, bars, fmt="o", markersize=3, color=BLUE, elinewidth=0.9, capsize=1.8)
    radii.axhline(size.value_um, color=BLUE, linewidth=0.8)
    radii.axhspan(size.value_um - size.expanded_uncertainty_um, size.value_um + size.expanded_uncertainty_um, color=BLUE, alpha=0.12, linewidth=0)
    _limits(radii, size.limit_um)
    radii.set_xlim(0.4, len(errors) + 0.6)
    radii.set_xticks(numbers[:: max(1, len(numbers) // 10)])
    reach = 1.15 * max(size.limit_um, max(abs(e) + b for e, b in zip(errors, bars, strict=True)))
    radii.set_ylim(-reach, reach)

    for frame, name, title in ((frames[4], "size", "History: radius error"), (frames[5], "dispersion", "History: D95")):
        trend = page.axes(*frame, title, "", "µm")
        _trend(trend, history, name, BLUE)
        _limit_history(trend, history, name, both=name == "size")
        _dates(trend, history)


def acceptance_plots(page: Page, result: AcceptanceResult, history: Sequence[HistoryEntry]) -> None:
    """Characteristics against their limits, errors by place, coverage, places in the volume, history."""
    frames = _frames(page, (2, 2, 2), (0.9, 0.9, 0.75))
    characteristics = result.characteristics()
    bars = page.axes(*frames[0], "Share of the limit, with U", "", "|value| / limit")
    for i, c in enumerate(characteristics):
        share, spread = abs(c.value_um) / c.limit_um, c.expanded_uncertainty_um / c.limit_um
        bars.bar(i, share, 0.55, color=COLOURS[c.verdict], alpha=0.75, yerr=spread, ecolor=INK, capsize=3, error_kw={"elinewidth": 0.9})
    bars.axhline(1.0, color=COLOURS[Verdict.FAIL], linewidth=0.9)
    bars.set_xticks(range(len(characteristics)), ["form PF", "D95", "size PS", "spacing SD"])
    bars.set_ylim(0, max(1.25, 1.12 * max((abs(c.value_um) + c.expanded_uncertainty_um) / c.limit_um for c in characteristics)))

    _places(page, frames[1], result)

    sizes = page.axes(*frames[2], "Size error by place (diameter)", "position of the bar", "µm")
    numbers = np.arange(1, len(result.bars) + 1)
    errors = np.array(result.size_errors_um()).reshape(-1, 2)
    size_spread = np.array([[4e3 * s.fit.radius_uncertainty_mm for s in bar.spheres] for bar in result.bars])
    for side, colour, name in ((0, BLUE, "first sphere"), (1, ORANGE, "second sphere")):
        at = numbers + 0.24 * side - 0.12
        sizes.errorbar(at, errors[:, side], size_spread[:, side], fmt="o", markersize=3, color=colour, elinewidth=0.9, capsize=1.8, label=name)
    _limits(sizes, result.limits.size_um)
    _symmetric(sizes, errors.ravel(), size_spread.ravel(), result.limits.size_um)
    sizes.legend(fontsize=6.5, frameon=False, loc="upper left", ncols=2, handlelength=1.0, borderpad=0.1)
    sizes.set_xticks(numbers)

    spacings = page.axes(*frames[3], "Spacing error by position", "position of the bar", "µm")
    values = np.array(result.spacing_errors_um())
    spacing_spread = np.array([2e3 * np.hypot(bar.spacing_uncertainty_mm, result.spacing.uncertainty_mm) for bar in result.bars])
    spacings.errorbar(numbers, values, spacing_spread, fmt="o", markersize=3, color=BLUE, elinewidth=0.9, capsize=1.8)
    _limits(spacings, result.limits.spacing_um)
    _symmetric(spacings, values, spacing_spread, result.limits.spacing_um)
    spacings.set_xticks(numbers)

    cover = page.axes(*frames[4], "Coverage by place", "position of the bar", "% of the sphere")
    shares = 100 * np.array([[s.coverage.surface_fraction for s in bar.spheres] for bar in result.bars])
    for side, colour in ((0, BLUE), (1, ORANGE)):
        cover.bar(numbers + 0.36 * side - 0.18, shares[:, side], 0.34, color=colour, alpha=0.75)
    cover.axhline(100 * REQUIRED_COVERAGE, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
    cover.set(ylim=(0, 100))
    cover.set_xticks(numbers)

    trend = page.axes(*frames[5], "History: share of the limit", "", "|value| / limit")
    for name, colour in (("form", GREY), ("dispersion", GREEN), ("size", BLUE), ("spacing", ORANGE)):
        kept = [e for e in history if name in e.figures and e.limits.get(name)]
        shares_of_limit = [abs(e.figures[name]) / e.limits[name] for e in kept]
        trend.plot([_day(e) for e in kept], shares_of_limit, marker="o", markersize=2.5, linewidth=0.9, color=colour, label=name)
    trend.axhline(1.0, color=COLOURS[Verdict.FAIL], linewidth=0.9)
    _from_zero(trend, 1.3)
    trend.legend(fontsize=6, frameon=False, loc="upper left", ncols=4, handlelength=0.9, columnspacing=0.9, borderpad=0.1)
    _dates(trend, history)


# ------------------------------------------------------------------------------------------ inner
def _frames(page: Page, columns: Sequence[int], heights: Sequence[float]) -> list[tuple[float, float, float, float]]:
    """Frames of plots in rows below what stands on the page; each (x, y, width, height) in mm."""
    top, bottom = page.y_mm, HEIGHT_MM - 17.0
    free = bottom - top - len(columns) * (_ABOVE_MM + _BELOW_MM)
    frames, y = [], top
    for count, height in zip(columns, heights, strict=True):
        tall = free * height / sum(heights)
        width = (WIDTH_MM - 2 * MARGIN_MM - (count - 1) * _GAP_MM) / count
        frames += [(MARGIN_MM + i * (width + _GAP_MM) + _LEFT_MM, y + _ABOVE_MM, width - _LEFT_MM, tall) for i in range(count)]
        y += _ABOVE_MM + tall + _BELOW_MM
    return frames


def _map(page: Page, axes: Axes, azimuth: Array, polar: Array, residuals: Array, limit: float) -> None:
    counts, sums = _cells(azimuth, polar), _cells(azimuth, polar, residuals)
    mean = np.divide(sums, counts, out=np.full_like(sums, np.nan), where=counts > 0)
    image = axes.imshow(mean, cmap="RdBu_r", vmin=-limit, vmax=limit, extent=(0, 360, 180, 0), aspect="auto", interpolation="nearest")
    _bar(page, axes, image)
    axes.set_xticks([0, 90, 180, 270, 360])
    axes.set_yticks([0, 45, 90, 135, 180])


def _density(page: Page, axes: Axes, azimuth: Array, polar: Array) -> None:
    counts = _cells(azimuth, polar)
    middle = np.radians(2.5 + 5.0 * np.arange(36))
    per_square_degree = counts / (25 * np.sin(middle))[:, None]
    shown = np.where(counts > 0, per_square_degree, np.nan)
    brightest = float(np.nanpercentile(shown, 98))
    image = axes.imshow(shown, cmap="viridis", vmin=0, vmax=brightest, extent=(0, 360, 180, 0), aspect="auto", interpolation="nearest")
    _bar(page, axes, image)
    axes.set_xticks([0, 90, 180, 270, 360])
    axes.set_yticks([0, 45, 90, 135, 180])


def _cells(azimuth: Array, polar: Array, weights: Array | None = None) -> Array:
    """Sums over cells of 5 x 5 degrees, (36, 72)."""
    return np.asarray(np.histogram2d(polar, azimuth, bins=(36, 72), range=((0, 180), (0, 360)), weights=weights)[0], np.float64)


def _bar(page: Page, axes: Axes, image: Any) -> None:
    """A scale of the colours beside the axes, which make room for it."""
    place = axes.get_position()
    axes.set_position((place.x0, place.y0, place.width - 9.5 / WIDTH_MM, place.height))
    beside = page.figure.add_axes((place.x1 - 8.5 / WIDTH_MM, place.y0, 2.2 / WIDTH_MM, place.height))
    bar = page.figure.colorbar(image, cax=beside)
    bar.ax.tick_params(labelsize=6, length=1.5, width=0.4, pad=1.2)
    bar.outline.set_linewidth(0.4)


def _places(page: Page, frame: tuple[float, float, float, float], result: AcceptanceResult) -> None:
    """The bar's places seen from above and from the side."""
    x, y, width, height = frame
    half = 0.5 * (width - 10.0)
    above = page.axes(x, y, half, height, "Places, from above", "x / mm", "y / mm")
    beside = page.axes(x + half + 10.0, y, half, height, "From the side", "x / mm", "z / mm")
    turn = np.linspace(0, 2 * np.pi, 121)
    radius, top = result.volume.radius_mm, result.volume.height_mm
    above.plot(radius * np.cos(turn), radius * np.sin(turn), color=GREY, linewidth=0.8)
    beside.plot([-radius, -radius, radius, radius], [0, top, top, 0], color=GREY, linewidth=0.8)
    beside.axhline(0, color=INK, linewidth=0.9)
    for bar in result.bars:
        ends = np.array([sphere.fit.centre for sphere in bar.spheres])
        for axes, across, up in ((above, 0, 1), (beside, 0, 2)):
            axes.plot(ends[:, across], ends[:, up], color=LINE, linewidth=1.0, zorder=1)
            axes.plot(ends[0, across], ends[0, up], "o", markersize=4, color=BLUE)
            axes.plot(ends[1, across], ends[1, up], "o", markersize=4, color=ORANGE)
    _equal(above, (half, height), (0.0, 0.0), (1.08 * radius, 1.08 * radius))
    _equal(beside, (half, height), (0.0, 0.5 * top), (1.08 * radius, 0.6 * top))


def _equal(axes: Axes, size_mm: tuple[float, float], middle: tuple[float, float], half: tuple[float, float]) -> None:
    """Limits that show at least `half` on both sides of the middle, with the same scale across and up."""
    width, height = size_mm
    scale = max(half[0] / width, half[1] / height)
    axes.set(xlim=(middle[0] - scale * width, middle[0] + scale * width), ylim=(middle[1] - scale * height, middle[1] + scale * height))


def _limits(axes: Axes, limit: float) -> None:
    for sign in (-1, 1):
        axes.axhline(sign * limit, color=COLOURS[Verdict.FAIL], linewidth=0.9)
    axes.axhline(0, color=GREY, linewidth=0.5)


def _symmetric(axes: Axes, values: Array, spread: Array, limit: float) -> None:
    reach = 1.3 * max(limit, float((np.abs(values) + spread).max()))
    axes.set_ylim(-reach, reach)


def _day(entry: HistoryEntry) -> float:
    """Days since 1970, as matplotlib counts dates."""
    return entry.moment.timestamp() / 86_400


def _trend(axes: Axes, history: Sequence[HistoryEntry], name: str, colour: str, errors: bool = True) -> None:
    kept = [entry for entry in history if name in entry.figures]
    days = [_day(entry) for entry in kept]
    values = [entry.figures[name] for entry in kept]
    spread = [entry.uncertainties.get(name, 0.0) for entry in kept] if errors else None
    axes.errorbar(days, values, spread, fmt="o-", markersize=2.8, linewidth=0.9, elinewidth=0.8, capsize=1.5, color=colour)


def _limit_history(axes: Axes, history: Sequence[HistoryEntry], name: str, both: bool) -> None:
    kept = [entry for entry in history if name in entry.limits]
    if not kept:
        return
    limits = np.array([entry.limits[name] for entry in kept])
    for sign in (-1, 1) if both else (1,):
        if len(kept) > 1:
            axes.step([_day(entry) for entry in kept], sign * limits, where="mid", color=COLOURS[Verdict.FAIL], linewidth=0.9)
        else:
            axes.axhline(sign * float(limits[0]), color=COLOURS[Verdict.FAIL], linewidth=0.9)
    if both:
        axes.axhline(0, color=GREY, linewidth=0.5)
    else:
        _from_zero(axes)


def _from_zero(axes: Axes, room: float = 1.12) -> None:
    """From 0 to a little over all that is drawn."""
    axes.relim()
    axes.autoscale_view()
    axes.set_ylim(0, room * axes.get_ylim()[1])


def _dates(axes: Axes, history: Sequence[HistoryEntry]) -> None:
    """Few dates, none of them over another, also when all results are of one day or there is one alone."""
    from matplotlib.dates import AutoDateLocator, ConciseDateFormatter

    if not history:
        return
    days = [_day(entry) for entry in history]
    span = max(days) - min(days)
    margin = 0.06 * span if span > 0 else 0.5
    axes.set_xlim(min(days) - margin, max(days) + margin)
    if span == 0:
        axes.set_xticks([days[0]], [history[0].moment.strftime("%Y-%m-%d")])
        return
    locator = AutoDateLocator(minticks=2, maxticks=5)
    axes.xaxis.set_major_locator(locator)
    axes.xaxis.set_major_formatter(ConciseDateFormatter(locator, tz=history[-1].moment.tzinfo))
    axes.xaxis.get_offset_text().set_fontsize(6)
