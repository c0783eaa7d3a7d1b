"""Everything that can go wrong on the virtual rig, by name.

Each fault is one frozen value.  It happens by ``--fault NAME[@TIME]`` on the command line, by ``OpenRig.inject`` (the
window's panel) and by the same values in tests; several may happen at once.  Its time counts in seconds of the rig's
clock from the moment when it is handed over (the opening of the rig, the end of the calibration in ``impronta demo``),
the worker's from the start of the reconstruction.  The program that measures learns of none of this.

What the program does, always: the laser is off and the controller at rest (or gone) afterwards, counts balance, what was
acknowledged stands in the case, the case opens, an error is one sentence with cause and remedy, nothing is left running.

====================  ==============================================  ==================================================
name                  what happens                                    what the program does
====================  ==============================================  ==================================================
camera_unplugged      a camera's cable comes off                      ends, E-CAM-02
camera_stalled        no frame and no error comes any more            ends, E-CAM-01, after 4 s
frames_dropped        a fifth of a camera's frames is lost            goes on, ``dropped_frame``, H-CAM-01
frames_late           frames arrive 0.4 s late                        goes on, waits for each
frames_torn           a tenth is half another exposure, or garbage    goes on, ``torn``, H-CAM-03
camera_bumped         a camera is turned a little and stays so        goes on, H-EPI-01 or H-VIEW-02
camera_skew           a camera exposes 8 ms late                      goes on, H-SYN-02
trigger_lost          a camera's frames are of the next exposure      goes on, H-SYN-01
lost_steps            the table loses steps in its next move          goes on, H-TAB-01 (H-TAB-02 on a sphere)
lenses_warm           everything is measured a thousandth too large   goes on, H-MARK-03 with marks on the table's rim
mark_knocked_off      a ball on the table's rim is gone               goes on, H-MARK-05
lamp_on               a lamp shines into the cameras                  goes on, ``too_bright``, H-LGT-01; E-SCAN-06 when no
                                                                      surface was found because of it
shiny_patch           a wet place mirrors: glare and second spots     goes on, ``saturated`` and ``ambiguous``, or settled
                                                                      by the other camera
lid_opened            the lid is open for 10 s                        ends, E-MOT-16; the board darkens by itself
controller_reset      brown-out in mid-move, position lost            ends, E-MOT-09
alarm_1               an axis touches its limit switch                ends, E-MOT-05
alarm_2               a move seems to leave the travel                ends, E-MOT-05
alarm_3               the reset button is pressed in mid-move         ends, E-MOT-05
port_gone             the controller's cable comes off                ends, E-MOT-02; a sweep ends dark by itself
port_back             the same, and it is back after 3 s              ends, E-MOT-02; the next start works
serial_noise          for 10 s 1 % of the answers' bytes are wrong    asks again what can be asked again; E-MOT-01 when an
                                                                      ``ok`` was hit, E-MOT-06 or E-MOT-18 when an error or
                                                                      a power seems to be told
partial_lines         for 20 s answers come in pieces of 5 bytes      goes on
lost_ok               an ``ok`` is lost                               ends, E-MOT-01, 2 s after the board fell idle
disk_full             the case's disk is full                         ends, E-DISK-01
case_locked           another program tries for the case              goes on; at its opening, held by the other: E-CASE-02
clock_jump            the time of day jumps back by an hour           goes on, no duration is touched
worker_killed         the worker is killed in its job                 E-JOB-01; points safe, a new worker
worker_out_of_memory  for 10 s the worker gets no memory (Linux)      E-JOB-02 or E-JOB-01; points safe
program_killed        SIGKILL                                         is gone; what was acknowledged stands in the case
====================  ==============================================  ==================================================

``controller_reset`` and ``alarm_3`` wait for the next move when the controller rests at their time.  A firmware model in
its own process (a rig file with ``witness``) is told the controller's faults over its side channel.
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
