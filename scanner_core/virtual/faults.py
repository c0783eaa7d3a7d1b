"""Everything that can go wrong on the virtual rig, by name.

Each fault is one frozen value.  It happens by ``--fault NAME[@TIME]`` on the command line, by ``OpenRig.inject`` (the
window's panel) and by the same values in tests; several may happen at once.  Its time counts in seconds of the rig's
clock from the moment when it is handed over (the opening of the rig, the end of the calibration in ``impronta demo``),
the worker's from the start of the reconstruction.  The program that measures learns of none of this.

"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import isfinite

from scanner_core.errors import UsageError
from scanner_core.virtual.bench_faults import BENCH_FAULTS
from scanner_core.virtual.controller_faults import CONTROLLER_FAULTS
from scanner_core.virtual.fault import Fault
from scanner_core.virtual.host_faults import HOST_FAULTS

FAULTS: Mapping[str, Fault] = BENCH_FAULTS | CONTROLLER_FAULTS | HOST_FAULTS
"""By the name that the command line knows: cameras, light and object, then controller and cable, then the computer."""


def parse_fault(text: str) -> Fault:
    """``NAME`` or ``NAME@TIME``, the time in seconds.

    Raises
    ------
    UsageError
        E-USE-01 when there is no such fault, not on this system, or the time is no number.
    """
    name, at, time_text = text.partition("@")
    if name not in FAULTS:
        raise UsageError("E-USE-01", what=f"There is no fault '{name}'", do=f"choose one of {', '.join(FAULTS)}")
    try:
        at_s = float(time_text) if at else 0.0
    except ValueError:
        at_s = float("nan")
    if not (isfinite(at_s) and at_s >= 0):
        raise UsageError("E-USE-01", what=f"'{time_text}' is no time of a fault", do=f"give seconds, as in {name}@12.5")
    fault = replace(FAULTS[name], at_s=at_s)
    fault.check()
    return fault
