"""Specimens for the virtual table: shapes of our own, and mesh files."""

from __future__ import annotations

from pathlib import Path

from scanner_core.errors import UsageError
from scanner_core.virtual.specimens.arch import arch
from scanner_core.virtual.specimens.ear import ear
from scanner_core.virtual.specimens.ear_pair import ear_pair
from scanner_core.virtual.specimens.heart import heart
from scanner_core.virtual.specimens.remounting import remounted
from scanner_core.virtual.specimens.specimen import Specimen, check_fits, opening_down, stand_on_table
from scanner_core.virtual.specimens.sphere import sphere

__all__ = ["SPECIMENS", "Specimen", "check_fits", "load_specimen", "remounted"]

SPECIMENS = ("ear", "ear-pair", "arch", "heart", "sphere")
"""Names of the built-in specimens."""


def load_specimen(name_or_path: str | Path, *, treated: bool = False) -> Specimen:
    """A built-in specimen by name, or any mesh file put onto the middle of the table, an open one on its opening.

    Raises
    ------
    UsageError
        E-USE-01: `treated` was asked of something else than the arch.
    InputFileError
        The file is missing or no mesh.
    """
    name = str(name_or_path)
    if treated and name != "arch":
        raise UsageError("E-USE-01", what=f"There is no treated state of '{name}'", do="choose the specimen 'arch'")
    if name == "arch":
        return arch(treated=treated)
    if name in _MAKERS:
        return _MAKERS[name]()
    from scanner_core.mesh_io import read_mesh

    path = Path(name_or_path)
    return Specimen(path.stem, stand_on_table(opening_down(read_mesh(path))))


_MAKERS = {"ear": ear, "ear-pair": ear_pair, "heart": heart, "sphere": sphere}
