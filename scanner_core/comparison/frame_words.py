"""What is held fixed, and what another choice would have said, for a person: the same words for the command and the report."""

from __future__ import annotations

from scanner_core.comparison.arch_frame import arch_frame
from scanner_core.comparison.comparison import Comparison
from scanner_core.comparison.parameters import Frame
from scanner_core.comparison.shifted_region import shifted_region

HELD = {
    Frame.AUTO: "stable region, found automatically",
    Frame.WHOLE: "everything, best fit of the whole surfaces",
    Frame.MASK: "painted region",
    Frame.GIVEN: "as given in the files, not aligned",
}
_OTHER = {
    Frame.AUTO: "The stable region found automatically",
    Frame.WHOLE: "Whole best fit",
    Frame.MASK: "The painted region",
    Frame.GIVEN: "Taking the files as they lie",
}
_REGIONS = {"molars": "molars", "front": "front teeth"}


def shift_sentences(comparison: Comparison) -> tuple[str, ...]:
    """What the other frames would have done, for example "Whole best fit would shift the molars by 0.60 mm." """
    alignment = comparison.alignment
    if not alignment.shifts:
        return ()
    arch = arch_frame(comparison.before.mesh, comparison.before.supported)
    points = alignment.transform.apply(comparison.after.mesh.vertices)
    told = []
    for shift in alignment.shifts:
        region = None if arch is None else shifted_region(shift, points, arch)
        if region is None:
            words = f"everything by {shift.rms_um / 1000:.2f} mm rms, {shift.max_um / 1000:.2f} mm at most"
        else:
            words = f"the {_REGIONS[region[0]]} by {region[1] / 1000:.2f} mm"
        told.append(f"{_OTHER[shift.frame]} would shift {words}.")
    return tuple(told)
