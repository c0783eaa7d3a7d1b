"""What the report says, in words and numbers: the same for the page, the browser and the spreadsheet."""

from __future__ import annotations

import platform

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from scanner_core import __version__
from scanner_core.comparison.area import Area
from scanner_core.comparison.area_bar import AreaBar
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.comparison_values import above_null, told_doubts
from scanner_core.comparison.frame_words import HELD
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.surface import ComparedSurface

TITLE = "Comparison of two surfaces"
PROGRAM = f"Impronta {__version__}"
VERSIONS = f"{PROGRAM}, Python {platform.python_version()}, numpy {np.__version__}, vtk {vtkVersion.GetVTKVersion()}"
DIRECTION = (
    "Deviations are those of AFTER against BEFORE: + where AFTER lies outside of BEFORE, − where it lies inside. "
    "± is the expanded uncertainty U (k = 2) everywhere."
)
AREA_HEADER = ("", "what was found", "max / mm", "P95 / mm", "area / mm²", "volume / mm³", "motion / mm", "rotation / °", "> null")
_CONCERN = {"Order": ("order", "side", "type"), "Date": ("date",), "Measured": ("rig", "calibration_id", "calibration_date")}
"""What of a surface's origin is told.  Never its path, which often holds a patient's name."""
_COUNTED = "of counterparts only"
_ABOVE = {None: "–", True: "yes", False: "no"}

Facts = tuple[tuple[str, str], ...]


def number(value: float, digits: int) -> str:
    """Unsigned; a value that is not known is a dash."""
    return f"{value:,.{digits}f}".replace("-", "−") if np.isfinite(value) else "–"


def signed(value: float, digits: int) -> str:
    """With its sign, the minus as long as the plus."""
    if not np.isfinite(value):
        return "–"
    text = f"{value:+,.{digits}f}"
    return text.lstrip("+-") if float(text.replace(",", "")) == 0 else text.replace("-", "−")


def count_of(number: int, thing: str) -> str:
    """One remark, 2 remarks."""
    return f"one {thing}" if number == 1 else f"{number} {thing}s"


def subject(comparison: Comparison) -> str:
    """What is compared: the order where there is one, else the files."""
    orders = [str(surface.origin.get("order") or "") for surface in (comparison.before, comparison.after)]
    if all(orders):
        order = orders[0] if orders[0] == orders[1] else f"{orders[0]} and {orders[1]}"
        return f"Order {order}: before and after"
    return f"{comparison.before.name} and {comparison.after.name}"


def verdict(comparison: Comparison) -> str:
    """One sentence: the verdict, and why when it is bad."""
    serious = _sentences(comparison, serious=True)
    if not serious:
        count = len(remarks(comparison))
        if count:
            return f"Reliable; {count_of(count, 'remark')} below."
        return "Reliable: nothing was found that speaks against this result."
    more = f" ({len(serious) - 1} more below.)" if len(serious) > 1 else ""
    return f"Not reliable: {serious[0]}{more}"


def remarks(comparison: Comparison) -> tuple[str, ...]:
    """Every doubt that the verdict does not tell, the serious ones first, each once."""
    return tuple(dict.fromkeys([*_sentences(comparison, serious=True)[1:], *_sentences(comparison, serious=False)]))


def _sentences(comparison: Comparison, *, serious: bool) -> list[str]:
    """The doubts of one weight; those of a single surface say of which."""
    return [words for doubt, words in told_doubts(comparison, "BEFORE", "AFTER") if doubt.serious is serious]


def findings(comparison: Comparison) -> str:
    """What was found, in a sentence."""
    areas = comparison.areas
    if not areas:
        bar = AreaBar.of(comparison.deviation)
        return (
            f"No area of {bar.extent_mm2:g} mm² or more differs by more than {number(bar.deviation_um / 1000, 2)} mm, "
            f"smoothed over {bar.smoothing_mm:g} mm; the map shows smaller differences."
        )
    first = areas[0]
    count = "One area differs" if len(areas) == 1 else f"{len(areas)} areas differ"
    return f"{count}; the greatest difference: {first.words} (on the map {signed(first.max_um / 1000, 2)} mm at most)."


def surface_facts(surface: ComparedSurface) -> Facts:
    """Of one of the two inputs."""
    told = []
    for label, keys in _CONCERN.items():
        values = [_short_date(str(surface.origin[key])) for key in keys if surface.origin.get(key) not in (None, "")]
        if values:
            told.append((label, ", ".join(values)))
    mesh = surface.mesh
    size = " × ".join(f"{edge:.1f}" for edge in np.ptp(mesh.vertices, axis=0)) if len(mesh.vertices) else "0"
    return (
        ("File", surface.name),
        *told,
        ("Surface", f"{len(mesh.triangles):,} triangles, {size} mm"),
        ("Unit", f"{surface.unit}: {surface.unit_reason}"),
    )


def statistics(comparison: Comparison) -> tuple[tuple[str, str, str], ...]:
    """Label, value in mm or as a share, and the direction in which it was measured."""
    s = comparison.deviation.statistics
    compared = _compared_area(comparison)

    def mm(value_um: float) -> str:
        return f"{number(value_um / 1000, 3)} mm"

    rows = [
        ("Mean, signed", f"{signed(s.mean_um / 1000, 3)} mm", "after → before"),
        ("RMS", mm(s.rms_um), "after → before"),
        ("P50 / P95 / P99", " / ".join(number(value / 1000, 3) for value in (s.p50_um, s.p95_um, s.p99_um)) + " mm", "after → before"),
        ("Greatest", mm(s.max_um), "after → before"),
        ("Hausdorff", f"{mm(s.hausdorff_after_to_before_um)}, {_COUNTED}", "after → before"),
        ("Hausdorff", f"{mm(s.hausdorff_before_to_after_um)}, {_COUNTED}", "before → after"),
    ]
    for threshold, area in sorted(s.area_above_mm2.items(), key=lambda item: float(item[0])):
        share = f", {100 * area / compared:.1f} %" if compared > 0 else ""
        rows.append((f"Area above {float(threshold) / 1000:.2f} mm", f"{number(area, 1)} mm²{share}", "after → before"))
    rows.append(("Without counterpart", f"{100 * s.no_counterpart_fraction:.1f} % of the area", "after → before"))
    return tuple(rows)


def detection(comparison: Comparison) -> Facts:
    """What can be told from noise."""
    level = comparison.null_level_um
    null = f"{number(level / 1000, 3)} mm, the same model measured twice" if level is not None else "not measured for this rig and material"
    if level is not None and comparison.null_area_mm2 is not None:
        null += f"; {number(comparison.null_area_mm2, 1)} mm² above 0.2 mm"
    return (
        ("Level of detection", f"{number(comparison.deviation.detection_level_um / 1000, 3)} mm (95 %), from noise and alignment"),
        ("Null comparison", null),
    )


def alignment_card(comparison: Comparison) -> Facts:
    """What the alignment rests on."""
    a = comparison.alignment
    correlation = f", correlated over {a.correlation_length_mm:.1f} mm" if a.correlation_length_mm >= 0.05 else ""
    return (
        ("Held fixed", HELD[a.frame]),
        ("Found by", a.method),
        ("Stable region", f"{100 * a.stable_area_fraction:.0f} % of the common area"),
        ("Overlap", f"{100 * a.overlap:.0f} % of AFTER has a counterpart"),
        ("Residual", f"{number(a.rms_um / 1000, 3)} mm rms on the stable region"),
        ("Noise", f"{number(a.noise_um / 1000, 3)} mm, both surfaces{correlation}"),
        ("Uncertainty", "not estimated" if a.frame is Frame.GIVEN else f"± {number(2e-3 * a.uncertainty_um, 4)} mm of a stable point"),
        ("Scale ratio", f"{a.scale_ratio:.5f} ± {2 * a.scale_ratio_uncertainty:.5f}; not applied"),
    )


def area_cells(area: Area, comparison: Comparison) -> tuple[str, ...]:
    """A row under `AREA_HEADER`."""
    motion = angle = "–"
    if area.motion is not None:
        m = area.motion
        length = float(np.linalg.norm(m.displacement_mm))
        motion = f"{number(length, 2)} ± {number(2e-3 * m.displacement_uncertainty_um, 2)}"
        angle = f"{number(m.angle_deg, 1)} ± {number(2 * m.angle_uncertainty_deg, 1)}"
    return (
        str(area.rank),
        area.words,
        signed(area.max_um / 1000, 2),
        number(area.p95_um / 1000, 2),
        number(area.area_mm2, 1),
        signed(area.volume_mm3, 1),
        motion,
        angle,
        _ABOVE[above_null(area, comparison)],
    )


def area_note(comparison: Comparison) -> str:
    """How to read the table."""
    null = " “> null”: P95 and area exceed those of the null comparison."
    if comparison.null_level_um is None:
        null = " “> null” stays open until a null comparison is stored with the rig."
    return (
        "max is signed, P95 is of the magnitude. Motion is that of the part's centre, fitted as a rigid body, "
        f"its ± includes the alignment; a map alone shows less than a tooth moved.{null}"
    )


def parameters(comparison: Comparison) -> Facts:
    """How it was computed."""
    p = comparison.parameters
    jaw = "not confirmed" if p.jaw is None else str(p.jaw)
    return (
        ("Frame asked for", str(p.frame)),
        ("Clinical threshold", f"{number(p.tolerance_um / 1000, 3)} mm"),
        ("No counterpart beyond", f"{number(p.no_counterpart_mm, 1)} mm"),
        ("Jaw", jaw),
        ("Seed", str(p.seed)),
        ("Versions", VERSIONS),
    )


def _compared_area(comparison: Comparison) -> float:
    """Area of the after surface whose corners all have a counterpart, mm^2."""
    known = np.isfinite(comparison.deviation.signed_um) & comparison.after.supported
    mesh = comparison.after.mesh
    share = known[mesh.triangles].mean(axis=1)
    return float((mesh.areas() * share).sum())


def _short_date(text: str) -> str:
    """ISO date and time without seconds and zone; anything else as it is."""
    return text[:16].replace("T", " ") if len(text) > 16 and text[4:5] == "-" and text[10:11] == "T" else text
