"""``impronta target``: the calibration board as a page to print."""

from __future__ import annotations

import argparse
from pathlib import Path

from scanner_core.commands.console import Console
from scanner_core.errors import InputFileError
from scanner_core.files import check_free, replaced_when_whole
from scanner_core.optics.board import DEFAULT_TARGET
from scanner_core.optics.printable_target import PAPERS_MM, RULER_MM, write_target


def run(given: argparse.Namespace, console: Console) -> int:
    out = Path(given.out).resolve()
    if out.suffix.lower() != ".pdf":
        raise InputFileError("E-FILE-06", suffix=out.suffix, known=".pdf")
    check_free(out, given.force)
    with replaced_when_whole(out, given.force) as partial:
        write_target(partial, DEFAULT_TARGET, given.paper)
    width, height = DEFAULT_TARGET.size_mm
    values = {
        "out": str(out),
        "paper": given.paper,
        "paper_mm": list(PAPERS_MM[given.paper]),
        "board_mm": [width, height],
        "square_mm": DEFAULT_TARGET.square_mm,
        "ruler_mm": RULER_MM,
    }
    console.result(
        values,
        [
            f"Written to {out}.",
            f"Print it at 100 % and check that the ruler measures {RULER_MM:g} mm; "
            f"measure the row of squares with a caliper (nominally {width:g} mm) for --print-width-mm.",
        ],
    )
    return 0
