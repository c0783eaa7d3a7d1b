"""What a reconstruction can be asked for; everything else is derived from the points."""

from __future__ import annotations

from dataclasses import asdict, dataclass

from scanner_core.errors import UsageError
from scanner_core.reconstruction.error_function import Criterion
from scanner_core.reconstruction.limits import DETAIL, LEAST_TRIANGLES, PASS_BAND, SMOOTHING_ROUNDS, SUPPORT
from scanner_core.reconstruction.support import MEASURED


@dataclass(frozen=True, slots=True)
class ReconstructionParameters:
    """One default for every input.

    Attributes
    ----------
    triangles : at most so many triangles and at least 0.98 times as many, with `open_holes` before the cap is left away; None leaves it to the points
    tolerance_um : 95 of 100 facets may depart from the fitted surface by so much; ignored when `triangles` is given
    detail : how many times as many triangles as the points carry, where neither of the two above is given
    smoothing_rounds, pass_band : of Taubin's filter in phase three; spatial frequencies below the pass-band stay
    least_support : density of the points, over the one that they have among themselves, from which on the surface counts as measured
    open_holes : leave away the part of the surface that no point supports; the mesh is then not closed
    table_mm : height z of the table that the object stands on; None when nothing is known of one
    seed : of every random choice
    criterion : what phase two refines by: the ``data_error`` of the publication, the ``sag`` of the facets, or
        nothing (``uniform``, to compare with)
    """

    triangles: int | None = None
    tolerance_um: float | None = None
    detail: float = 1.0
    smoothing_rounds: int = 3
    pass_band: float = 0.1
    least_support: float = MEASURED
    open_holes: bool = False
    table_mm: float | None = None
    seed: int = 0
    criterion: Criterion = Criterion.SAG

    def __post_init__(self) -> None:
        if self.triangles is not None and self.triangles < LEAST_TRIANGLES:
            raise UsageError("E-USE-01", what=f"{self.triangles} triangles are too few for a surface", do=f"ask for at least {LEAST_TRIANGLES}")
        if self.tolerance_um is not None and not self.tolerance_um > 0:
            raise UsageError("E-USE-01", what=f"A tolerance of {self.tolerance_um} um is not possible", do="give a positive number")
        _within("A detail", self.detail, *DETAIL)
        _within("A number of smoothing rounds", self.smoothing_rounds, *SMOOTHING_ROUNDS)
        _within("A pass-band", self.pass_band, *PASS_BAND)
        _within("A support", self.least_support, *SUPPORT)

    def as_dict(self) -> dict[str, object]:
        """For the provenance of a mesh."""
        return asdict(self) | {"criterion": self.criterion.value}


def _within(what: str, value: float, least: float, most: float) -> None:
    if not least <= value <= most:
        raise UsageError("E-USE-01", what=f"{what} of {value} is not possible", do=f"give one from {least} to {most}")
