"""Export profiles: what a laboratory, a printer or an archive wants, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from enum import Enum

FORMATS = (".stl", ".ply", ".obj", ".3mf")
"""Suffixes of the meshes."""
UNITS = ("mm", "cm", "m", "inch")
LONGEST_NAME = 60


class Pose(Enum):
    """How the surface lies in the delivered file."""

    SCANNED = "scanned"
    CANAL_UP = "canal_up"
    OCCLUSAL = "occlusal"


@dataclass(frozen=True, slots=True)
class Profile:
    """One profile.

    Attributes
    ----------
    name : of the profile
    format : suffix of the mesh's file, one of FORMATS
    unit : of its numbers; 3MF says its unit, the others are believed to be millimetres by most programs
    template : of the files' names; empty for the one of the settings
    folder : where they go; empty for the one that was chosen last
    pose : how the surface lies in the file
    open_base : without what the object stood on
    certificate : a PDF and a JSON beside it
    points : the measured points beside it, as XYZ
    """

    name: str
    format: str = ".stl"
    unit: str = "mm"
    template: str = ""
    folder: str = ""
    pose: Pose = Pose.SCANNED
    open_base: bool = False
    certificate: bool = True
    points: bool = False

    def __post_init__(self) -> None:
        if not self.name.strip() or len(self.name) > LONGEST_NAME or self.format not in FORMATS or self.unit not in UNITS:
            raise ValueError(f"no profile: {self}")

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Of all files that it makes, the mesh first."""
        return (self.format, *((".xyz",) if self.points else ()), *((".json", ".pdf") if self.certificate else ()))

    def as_dict(self) -> dict[str, object]:
        """For JSON."""
        return asdict(self) | {"pose": self.pose.value}

    @classmethod
    def from_dict(cls, values: object) -> Profile:
        """The reverse of :meth:`as_dict`; what is missing is the default, ValueError or TypeError for anything else."""
        if not isinstance(values, Mapping):
            raise TypeError("no profile")
        known = {field.name: values[field.name] for field in fields(cls) if field.name in values}
        if any(not isinstance(known.get(name, ""), str) for name in ("name", "format", "unit", "template", "folder", "pose")):
            raise TypeError("no profile")
        if any(not isinstance(known.get(name, False), bool) for name in ("open_base", "certificate", "points")):
            raise TypeError("no profile")
        if "pose" in known:
            known["pose"] = Pose(known["pose"])
        return cls(**known)


BUILT_IN: tuple[Profile, ...] = (
    Profile("Ear shell laboratory (STL)", pose=Pose.CANAL_UP),
    Profile("Dental model (STL, occlusal plane XY)", pose=Pose.OCCLUSAL),
    Profile("Printing (3MF)", ".3mf", certificate=False),
    Profile("Archive (PLY with uncertainty, and points)", ".ply", points=True),
    Profile("Modelling (OBJ)", ".obj", certificate=False),
)
"""What is there from the start; they cannot be changed, only copied."""
_BY_TYPE = {"ear": BUILT_IN[0], "arch": BUILT_IN[1]}


def default_profile(kind: str) -> Profile:
    """By the type of the order: ear, arch, arch-before, other, ..."""
    return _BY_TYPE.get(kind.partition("-")[0], BUILT_IN[3])


def find_profile(name: str, own: tuple[Profile, ...] = ()) -> Profile | None:
    """By its name, or by a beginning of it that only one has; letters' case does not count.  None when there is none."""
    every = (*own, *BUILT_IN)
    wanted = name.strip().casefold()
    exact = [profile for profile in every if profile.name.casefold() == wanted]
    begins = [profile for profile in every if wanted and profile.name.casefold().startswith(wanted)]
    return exact[0] if exact else begins[0] if len(begins) == 1 else None


def free_name(name: str, taken: set[str]) -> str:
    """The name, with a number behind it where it is taken."""
    found, number = name[:LONGEST_NAME], 1
    while found in taken:
        number += 1
        found = f"{name[: LONGEST_NAME - 6]} ({number})"
    return found


def renamed(profile: Profile, name: str) -> Profile:
    return replace(profile, name=name)
