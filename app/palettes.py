"""The two palettes: three close greys, one accent, and red filled for the laser only.

Every text colour keeps a contrast of 4.5:1 or more to each ground that it stands upon (WCAG 2.2 AA); see :data:`PAIRS`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Palette:
    """Colours as "#rrggbb", each by what it is for."""

    ground: str
    """Behind everything; also what lies between the panels."""
    panel: str
    raised: str
    hovered: str
    pressed: str
    seam: str
    edge: str
    """Round an indicator that a person clicks: 3:1 or more."""
    field: str
    """What is typed stands upon it."""
    field_edge: str
    text: str
    muted: str
    faint: str
    accent: str
    accent_hovered: str
    accent_pressed: str
    on_accent: str
    accent_dim: str
    """Behind what is selected, and a primary button that has to wait."""
    on_accent_dim: str
    accent_ground: str
    """Behind a choice that is made, and a note."""
    laser: str
    on_laser: str
    laser_text: str
    laser_ground: str
    warning: str
    warning_ground: str
    good: str
    left_ear: str
    left_ground: str
    right_ear: str
    right_ground: str
    scene_low: str
    """Behind a 3D view, at its lower end and at its upper one."""
    scene_high: str


DARK: Final = Palette(
    ground="#1c1f23",
    panel="#23272c",
    raised="#2d3238",
    hovered="#373d44",
    pressed="#262b30",
    seam="#363c43",
    edge="#a3abb5",
    field="#1c1f23",
    field_edge="#707a85",
    text="#e8eaed",
    muted="#b2bac3",
    faint="#9fa8b2",
    accent="#4cc2ab",
    accent_hovered="#62d3bd",
    accent_pressed="#3fa995",
    on_accent="#0b1f1b",
    accent_dim="#2a5a52",
    on_accent_dim="#c3e4dc",
    accent_ground="#24403b",
    laser="#d63a3f",
    on_laser="#ffffff",
    laser_text="#ff8f92",
    laser_ground="#3a2529",
    warning="#e8b04a",
    warning_ground="#352f22",
    good="#62c98a",
    left_ear="#7fb2ff",
    left_ground="#23303f",
    right_ear="#ff8a8a",
    right_ground="#3a292c",
    scene_low="#1c1f23",
    scene_high="#2d3238",
)

LIGHT: Final = Palette(
    ground="#e8ebee",
    panel="#f3f5f7",
    raised="#ffffff",
    hovered="#eaf0f3",
    pressed="#dde3e7",
    seam="#cdd3d9",
    edge="#626b75",
    field="#ffffff",
    field_edge="#838c96",
    text="#1a1e23",
    muted="#48515b",
    faint="#58616b",
    accent="#096b5d",
    accent_hovered="#0d7d6d",
    accent_pressed="#07564b",
    on_accent="#ffffff",
    accent_dim="#b5dcd5",
    on_accent_dim="#26504a",
    accent_ground="#d5ebe7",
    laser="#cf2a30",
    on_laser="#ffffff",
    laser_text="#ad161c",
    laser_ground="#fbe3e4",
    warning="#7d5000",
    warning_ground="#fcefd2",
    good="#17663a",
    left_ear="#1753ad",
    left_ground="#dfeafb",
    right_ear="#a8222b",
    right_ground="#fbe3e4",
    scene_low="#dfe3e7",
    scene_high="#f6f8f9",
)

_SURFACES: Final = ("ground", "panel", "raised", "hovered", "pressed")
PAIRS: Final = (
    *((text, ground) for text in ("text", "muted", "faint", "accent", "good", "warning") for ground in _SURFACES),
    *((text, ground) for text in ("left_ear", "right_ear", "laser_text") for ground in ("ground", "panel", "raised")),
    *((text, ground) for text in ("text", "muted", "warning") for ground in ("warning_ground", "accent_ground")),
    *((text, "field") for text in ("text", "faint")),
    *(("on_accent", ground) for ground in ("accent", "accent_hovered", "accent_pressed")),
    ("text", "accent_dim"),
    ("on_accent_dim", "accent_dim"),
    ("on_laser", "laser"),
    ("laser_text", "laser_ground"),
    ("left_ear", "left_ground"),
    ("right_ear", "right_ground"),
    ("accent", "accent_ground"),
)
"""Every text colour with every ground that it is put upon."""
SIGNS: Final = (
    *((sign, ground) for sign in ("edge", "accent", "text") for ground in _SURFACES),
    *(("laser", ground) for ground in ("ground", "panel")),
    ("field_edge", "panel"),
)
"""What is not text but has to be seen: 3:1."""


def contrast(first: str, second: str) -> float:
    """Contrast ratio of two colours "#rrggbb", 1 to 21; W3C, WCAG 2.2, "relative luminance" and "contrast ratio"."""
    bright, dark = sorted((_luminance(first), _luminance(second)), reverse=True)
    return (bright + 0.05) / (dark + 0.05)


def _luminance(colour: str) -> float:
    parts = (int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5))
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
