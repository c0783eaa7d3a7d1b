"""The sentences of the doubts, by their codes: what was seen, and what to do."""

from __future__ import annotations

DOUBTS: dict[str, str] = {
    # ------------------------------------------------------------------------------------------ alignment
    "everything-moved": (
        "Hardly anything ({percent} % of the surface) kept its place, so geometry does not say what is fixed: paint what you know to be stable."
    ),
    "stable-region-small": (
        "The alignment rests on {mm2} mm2, {percent} % of the surface that both files show: look whether the region drawn as stable is, or paint it."
    ),
    "overlap-low": "Only {percent} % of the after surface has a counterpart before: scan the same region both times.",
    "stable-region-loud": (
        "What is taken for unchanged differs by up to {length} (95 %): either the scans are that noisy, or it changed everywhere and nothing is "
        "fixed. Smaller changes cannot be told."
    ),
    "pose-ambiguous": "Another pose fits about as well, because the shape resembles itself: pick three points to say which one is meant.",
    "stable-region-one-lump": (
        "The stable region lies too much in one lump to hold the far end of the surface, which may be off by {length}: take in stable places that "
        "are farther apart."
    ),
    "scale-differs/larger": (
        "The after surface is {percent} % (+- {uncertainty} %) larger than the before surface where nothing should have changed, {length} at its "
        "rim: check units and the calibration of both scanners; nothing was rescaled."
    ),
    "scale-differs/smaller": (
        "The after surface is {percent} % (+- {uncertainty} %) smaller than the before surface where nothing should have changed, {length} at its "
        "rim: check units and the calibration of both scanners; nothing was rescaled."
    ),
    "whole-hides-motion": (
        "A best fit of the whole spreads what moved over everything: against the region that did not move it shifts the surface by up to {length}. "
        "Use the automatic or a painted frame."
    ),
    # ------------------------------------------------------------------------------------------ one file
    "unit-guessed": "Its numbers were taken as {unit} ({why}), so it is {mm} mm long; say the unit if that is wrong.",
    "unit-odd": "The file says {unit}, so it is {mm} mm long; by its size it would be in {guess}.",
    "points-joined": "Points with exactly the place of another one were joined: {count}.",
    "points-loose": "Points that belong to no triangle were left out: {count}.",
    "triangles-collapsed": "Triangles without an extent but a line or point were left out: {count}.",
    "winding-inconsistent": (
        "{share} of its area faces the other way than its neighbours, so + and - cannot be told apart; let the program that wrote it orient it."
    ),
    "winding-faults": "Some triangles ({share} of its area) face the other way than their neighbours; + and - are exchanged there.",
    "normals-inverted": "Its normals point inwards: + and - would be exchanged; turn them round in the program that wrote it.",
    "normals-inverted/arch": (
        "Its normals point inwards: they look to the side of the gum, not of the teeth. If it is no impression (a negative), + and - are "
        "exchanged; turn them round in the program that wrote it."
    ),
    "normals-seem-inverted": (
        "Its normals seem to point inwards: it is open, but what it encloses lies on their side. If it is no impression (a negative), + and - are "
        "exchanged; turn them round in the program that wrote it."
    ),
    "open": "It is open: its border has {mm} mm in {count} lines. What lies beyond a border has no counterpart and is left out.",
    "open/one": "It is open: its border has {mm} mm in one line. What lies beyond a border has no counterpart and is left out.",
    "several-shells": "It consists of {count} separate shells; the largest has {share} of the area. All of them are compared.",
    "non-manifold": (
        "Edges that belong to more than two triangles: {edges}; corners that join separate parts: {corners}. Inside and outside are not defined "
        "there."
    ),
    "degenerate-triangles": "{count} triangles have no area; they have no normal and are measured only by their neighbours.",
    "degenerate-triangles/one": "1 triangle has no area; it has no normal and is measured only by its neighbours.",
    "self-touching": "It touches or crosses itself: {count} triangles cut others. Distances near them may go to the wrong layer.",
    "self-touching/more": "It touches or crosses itself: more than {count} triangles cut others. Distances near them may go to the wrong layer.",
    "size-odd": "It is {mm} mm long, which neither an arch nor an ear is; check the unit of the file.",
    # ------------------------------------------------------------------------------------------ two files
    "identical-files": "{before} and {after} are identical files: nothing was measured twice; choose the other state.",
    "identical-surfaces": "{before} and {after} hold the identical surface: nothing was measured twice; choose the other state.",
    "types-differ": "By its order {before} is '{first}', but {after} '{second}'; choose two that belong together.",
    "sides-differ": "By its order {before} is of the side '{first}', but {after} '{second}'; choose two that belong together.",
    "patients-differ": "The orders of {before} and {after} name different patients; choose two of one patient.",
    "sizes-differ": "The later surface is {ratio} times as large as the earlier one; check the units, or whether the two belong together.",
    "sizes-differ/units": (
        "The later surface is {ratio} times as large as the earlier one; check the units ({units} differ by {factor}), or whether the two belong "
        "together."
    ),
    "dates-exchanged": "{before} was measured after {after} ({first} and {second}): are the two exchanged?",
    # ------------------------------------------------------------------------------------------ null comparison
    "null-other-material": ("This rig has no null comparison of '{material}'; the level shown is of another material, '{other}'. Measure one twice."),
    "null-material-unknown": "The material was not named; of the rig's null comparisons the largest level is shown ('{other}').",
    "null-older-than-calibration": "The null comparison of '{material}' ({date}) is older than the rig's calibration ({calibrated}); repeat it.",
    "null-other-rig": "The null comparison is of the rig '{rig}', but the surfaces were measured with '{others}'.",
    # ------------------------------------------------------------------------------------------ series
    "series-no-common-region": (
        "No region was stable throughout the series; each surface was aligned by a region of its own, so small motions may not add up."
    ),
    "series-does-not-close": (
        "{name} lands {closure} um beside its place when it goes over {previous} (+- {uncertainty} um, k = 2): what is taken as stable may have "
        "moved."
    ),
}
