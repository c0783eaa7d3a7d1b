"""What is said of what the watches of a scan notice: findings, which end nothing; see :mod:`scanner_core.sentences`."""

from __future__ import annotations

from scanner_core.sentence import Sentence

FINDING_SENTENCES: dict[str, Sentence] = {
    "H-EPI-01": Sentence(
        "A camera was moved across the epipolar lines by about {shift_px} px ({where}; noticed after {points} points).",
        "Points from there on may be off; see that both cameras are fixed, and calibrate before the next scan.",
    ),
    "H-EPI-02": Sentence(
        "The two images of the spot disagree by {sd_px} px, where {expected_px} px are expected ({where}).",
        "The points are noisier than they claim; look for vibration, moving reflections or a dirty lens.",
    ),
    "H-VIEW-01": Sentence(
        "A camera moved or the object moved: the view at {table_deg} deg lies {shift_um} um beside the earlier ones ({direction}).",
        "Its points are kept; fix cameras and object, then scan again.",
    ),
    "H-VIEW-02": Sentence(
        "A camera moved: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones ({direction}, always as seen by the cameras).",
        "Their points are kept; fix the cameras, calibrate, and scan again.",
    ),
    "H-VIEW-03": Sentence(
        "The object moved on the table: the views from {table_deg} deg on lie {shift_um} um beside the earlier ones.",
        "Their points are kept; fix the object to the table and scan again.",
    ),
    "H-VIEW-04": Sentence(
        "The turn does not close: the first view measured again lies {shift_um} um beside its first measurement.",
        "A camera or the object moved on the way; fix both, and scan again.",
    ),
    "H-TAB-01": Sentence(
        "The table lost steps: it stands {turn_deg} deg beside its reading{where}.",
        "The views from there on are turned; see that the table moves freely, and scan again.",
    ),
    "H-TAB-02": Sentence(
        "Whether the table lost steps cannot be judged on this object: {reason}.",
        "Its points may be right; a shape without rotational symmetry would tell.",
    ),
    "H-MARK-01": Sentence(
        "The table lost steps: by the marks on its rim it stands {turn_deg} deg beside its reading, since the view at {table_deg} deg.",
        "The views from there on are turned; see that the table moves freely, and scan again.",
    ),
    "H-MARK-02": Sentence(
        "A camera moved by about {shift_px} px: since the view at {table_deg} deg the marks on the table's rim are seen {shift_um} um beside.",
        "The points from there on are off; fix the cameras, calibrate, and scan again.",
    ),
    "H-MARK-03": Sentence(
        "The scale changed by {percent} %: since the view at {table_deg} deg the marks on the table's rim have other distances.",
        "Lengths from there on are off by as much; let the cameras warm up, calibrate, and scan again.",
    ),
    "H-MARK-04": Sentence(
        "The table or a camera moved: since the view at {table_deg} deg the marks on the table's rim are seen up to {shift_um} um beside.",
        "Which of them it was is not decided; the points from there on are off: fix cameras and table, calibrate, and scan again.",
    ),
    "H-MARK-05": Sentence(
        "Mark {number} on the table's rim was not found at {table_deg} deg, where nothing should hide it.",
        "The points are kept and the other marks go on watching; see whether it is covered or was knocked off.",
    ),
    "H-MARK-06": Sentence(
        "The scale is off by {percent} % against the calibrated distances of the marks on the table's rim.",
        "All lengths are off by as much; calibrate, or check 'distances_mm' in the table [marks] of the rig file.",
    ),
    "H-MARK-07": Sentence(
        "Mark {number} on the table's rim was moved by {shift_um} um before the view at {table_deg} deg.",
        "The points are kept and the other marks go on watching; fix it, and see that nothing touches it.",
    ),
    "H-CAM-01": Sentence(
        "Camera {camera} did not deliver {count} of {exposures} frames ({share} % of the last ones).",
        "Those measurements are missing; check its cable and port, and close other programs.",
    ),
    "H-CAM-02": Sentence(
        "Camera {camera} is blind: {frames} spots in a row were seen by camera {other} alone.",
        "Nothing is measured meanwhile; see to its lens cap, aperture and view.",
    ),
    "H-CAM-03": Sentence(
        "Camera {camera} delivered {count} torn frames of {exposures}: part of each is another exposure's, or no picture.",
        "Those measurements are missing; check its cable and port, and close other programs.",
    ),
    "H-LGT-01": Sentence(
        "Room light drowns the laser spot: {frames} frames in a row of camera {camera} are too bright.",
        "Nothing is measured meanwhile; switch the lamp off.",
    ),
    "H-LGT-02": Sentence(
        "The laser spot is saturated in {frames} frames in a row of camera {camera}.",
        "Nothing is measured meanwhile; shorten the exposure or lower the laser's power.",
    ),
    "H-LSR-01": Sentence(
        "Neither camera has seen the laser spot for {frames} exposures ({seconds} s), where the object was before.",
        "Nothing is measured meanwhile; see whether the beam is blocked, the laser is off, or the object fell over.",
    ),
    "H-SYN-01": Sentence(
        "The cameras are out of step by {count} frame: camera {late} lost a trigger, and every pair since then mixes two instants.",
        "The points since then are wrong; check the trigger cable and scan again.",
    ),
    "H-SYN-02": Sentence(
        "The cameras do not expose together: camera {late} is {skew_ms} ms late.",
        "The points are shifted along the sweep; trigger both cameras from one source.",
    ),
}
