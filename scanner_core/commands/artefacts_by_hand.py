"""A person at a terminal puts the artefacts of ``impronta verify`` onto the table."""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

from scanner_core.acquisition.rig_session import OpenRig
from scanner_core.commands.console import Console
from scanner_core.metrology.placing import ArtefactOperator


class PersonArtefacts:
    """Says what is wanted and waits for Enter; the laser is dark meanwhile.  See :class:`~scanner_core.metrology.placing.ArtefactOperator`."""

    def __init__(self, console: Console) -> None:
        self._console = console

    def put_plate(self, centre: NDArray[np.float64], normal: NDArray[np.float64]) -> None:
        self._ask(f"Stand the matt white plate upright, facing midway between the cameras, its middle about {_place(centre)}")

    def put_sphere(self, index: int) -> None:
        again = "Take the reference sphere away and put it down anew" if index else "Put the reference sphere"
        self._ask(f"{again} onto the middle of the table")

    def put_bar(self, centres: NDArray[np.float64], radius_mm: float) -> None:
        self._ask(f"Put the ball bar down with the centres of its spheres about {_place(centres[0])} and {_place(centres[1])}")

    def _ask(self, wanted: str) -> None:
        self._console.say(f"{wanted}; then press Enter (Ctrl-C ends the test).")
        if not sys.stdin.readline():
            raise KeyboardInterrupt  # nobody is there any more


def _place(point: NDArray[np.float64]) -> str:
    x, y, z = np.round(point).astype(int).tolist()
    return f"x {x}, y {y} mm from the table's middle, {z} mm above it"


def operator_at_terminal(rig: OpenRig, console: Console) -> ArtefactOperator | None:
    """The person, where things really stand on a table and somebody sits at the terminal."""
    return None if rig.bench is not None or rig.replayed or not sys.stdin.isatty() else PersonArtefacts(console)
