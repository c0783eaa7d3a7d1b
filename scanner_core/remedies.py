"""What to do about a device while nothing is being measured: devices are looked for, or a rig is checked, maybe without a rig file.

The second half of an error's sentence (:mod:`scanner_core.sentences`) speaks of a scan that is kept and resumed, and of the rig
file to correct; these stand in its place, by code and with the same fields.  A code without an entry keeps its own.
"""

from __future__ import annotations

from scanner_core.errors import ImprontaError

REMEDIES: dict[str, str] = {
    "E-CAM-01": "The laser is off; check its cable, then try again.",
    "E-CAM-02": "The laser is off; plug it in, then try again.",
    "E-CAM-04": "The laser is off; close other programs, then try again.",
    "E-CAM-07": "Nothing was moved; plug it in, then try again.",
    "E-CAM-08": "Nothing was measured; choose another size or pixel format, or another camera.",
    "E-CAM-09": "Nothing was measured; take the lens cap off, open the shutter, or lengthen its exposure.",
    "E-CAM-13": "The laser is off; check the trigger cable, or let the cameras run freely.",
    "E-CAM-30": "The laser is off; unplug the camera, plug it in again, then try again.",
    "E-MOT-01": "A reset was sent to switch the laser off; see that it is dark, check cable and power, then try again.",
    "E-MOT-02": "A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then try again.",
    "E-MOT-05": "The laser is off; {remedy}.",
    "E-MOT-07": "Nothing was moved; if it should be the controller, it has to be given GRBL first.",
    "E-MOT-08": "Nothing was moved; plug the controller in again, then try again.",
    "E-MOT-09": "The laser is off; its position is lost: home it, then try again.",
    "E-MOT-14": "Nothing was moved; such a rig needs a rig file that names one of these as 'table_axis'.",
    "E-MOT-15": "The laser is off; try again when the rig is free.",
    "E-MOT-16": "The laser is off; close the door, then try again.",
    "E-MOT-19": "The laser was switched off; free the machine of other work, then try again.",
    "E-MOT-20": "A reset was sent; check the cable (length, shield, plugs), then try again.",
    "E-MOT-24": "Nothing was moved; if it should be the controller, see that it has power and that the cable carries data, then try again.",
}


def remedy_of(error: ImprontaError) -> str:
    """What is safe and what to do."""
    remedy = REMEDIES.get(error.code)
    return error.hint if remedy is None else remedy.format(**error.fields)
