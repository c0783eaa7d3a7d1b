"""What a reconstruction remarks on its points and on its surface: nothing that ends it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class RemarkKind(Enum):
    """What can be remarked; the value is the sentence with its fields, by which a window translates it."""

    COPIES = "{share} of the points repeat others exactly; each place was counted once."
    STRAYS = "{count} points ({share}) lie more than {link_mm} mm from the object; they were left out as strays."
    LARGE = (
        "The object is {extent_mm} mm large, more than any anatomical part: if the coordinates are micrometres, divide them by 1000; "
        "if they are millimetres, use --units mm."
    )
    SMALL = "The object is only {extent_mm} mm large, less than an anatomical part: if the coordinates are {unit}, use --units {option}."
    FAR = "The object lies {away_mm} mm from the origin; it was computed about its centre, so that no precision was lost."
    ROUNDED = (
        "The coordinates are rounded to steps of {step_mm} mm, single precision far from the origin; "
        "export the points in double precision, or nearer to the origin."
    )
    CAPPED = "{share} % of the closed surface was not scanned; it is capped and marked as unsupported."
    OPEN = "{share} % of the closed surface was not scanned; it is left open."
    REJECTED = "{share} % of the points do not belong to the surface and were rejected."
    NOT_STANDING = "The body that stands on the table could not be filled; the base was closed by what the points alone enclose."


@dataclass(frozen=True, slots=True)
class Remark:
    """One of them, with the figures as they are written."""

    kind: RemarkKind
    fields: dict[str, str]

    def words(self) -> str:
        """The sentence."""
        return self.kind.value.format(**self.fields)

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return {"kind": self.kind.name, "fields": dict(self.fields)}
