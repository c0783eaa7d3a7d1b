"""The unit that a mesh file says of itself, where it says one."""

from __future__ import annotations

import re

from scanner_core.mesh_io.threemf_package import UNITS_MM, unit_of_3mf

_WORDS = {
    **{word: "mm" for word in ("mm", "millimeter", "millimeters", "millimetre", "millimetres")},
    **{word: "cm" for word in ("cm", "centimeter", "centimeters", "centimetre", "centimetres")},
    **{word: "m" for word in ("m", "meter", "meters", "metre", "metres")},
    **{word: "inch" for word in ("in", "inch", "inches")},
}
_SAID = re.compile(rb"\bunits?[ \t]{0,8}[=:][ \t]{0,8}([A-Za-z]{1,12})", re.IGNORECASE)
_HEAD_BYTES = {".stl": 80, ".ply": 4096, ".obj": 4096}
"""Where such words stand: the header of an STL, the comments before the numbers."""
_SHORT = {"millimeter": "mm", "centimeter": "cm", "meter": "m", "inch": "inch", "micron": "um", "foot": "foot"}

MM: dict[str, float] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4, "um": 1e-3, "foot": 304.8}
"""One of each unit in millimetres."""


def stated_unit(suffix: str, content: bytes) -> str | None:
    """A key of :data:`MM`, from the bytes of a mesh file with that suffix; None when they say nothing that is understood.

    3MF always says it; of STL, PLY and OBJ some programs write ``UNITS=mm`` or ``unit: mm`` into the header.
    """
    if suffix == ".3mf":
        word = unit_of_3mf(content)
        return _SHORT[word] if word in UNITS_MM else None
    head = content[: _HEAD_BYTES.get(suffix, 0)]
    if suffix == ".ply":
        head = head.partition(b"end_header")[0]
    found = _SAID.search(head)
    return _WORDS.get(found.group(1).decode("ascii").lower()) if found else None
