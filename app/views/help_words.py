"""What the help says of every page: what it is for, what to do now, what its numbers mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from app.translation import QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class PageHelp:
    """English, translated when it is shown (context ``help``)."""

    purpose: str
    now: str
    numbers: str


HELP: Final[dict[str, PageHelp]] = {
    "home": PageHelp(
        QT_TRANSLATE_NOOP("help", "Here the day begins: an order is chosen or made, and its scan is started."),
        QT_TRANSLATE_NOOP(
            "help",
            "Type the order's number or read it with the scanner, choose the side and the type, put the object on the table, and start. "
            "An interrupted scan is offered at the top and can be resumed.",
        ),
        QT_TRANSLATE_NOOP("help", "The large number says how accurate the rig measured the last time it was checked, and when that was."),
    ),
    "rig": PageHelp(
        QT_TRANSLATE_NOOP("help", "This page shows the cameras, the laser, the table and their calibration."),
        QT_TRANSLATE_NOOP(
            "help",
            "When everything is green there is nothing to do. Otherwise read the one sentence that is amber: it says what helps, with a button.",
        ),
        QT_TRANSLATE_NOOP(
            "help",
            "The error of the calibration is measured at corners of the board that were not used to calibrate. "
            "Its age counts since then: calibrate again when something was moved.",
        ),
    ),
    "aim": PageHelp(
        QT_TRANSLATE_NOOP("help", "Both cameras live, with the laser spot that is accepted and every spot that is not."),
        QT_TRANSLATE_NOOP(
            "help",
            "Let the exposure be set by itself, or choose a material. Change the limits of the size only when good spots are refused: "
            "the reason stands at each of them.",
        ),
        QT_TRANSLATE_NOOP(
            "help", "The ellipse is the spot's size, one sigma in pixels. The line is where the other camera says that the spot must be."
        ),
    ),
    "scan": PageHelp(
        QT_TRANSLATE_NOOP("help", "The object is measured: the laser visits it point by point, and the table turns it from view to view."),
        QT_TRANSLATE_NOOP(
            "help",
            "Nothing needs to be done while it runs. Pause stops at a safe place with the laser dark; Esc ends the scan and keeps what was measured.",
        ),
        QT_TRANSLATE_NOOP(
            "help",
            "The points count what is in the case already. Rejected points were seen by one camera "
            "only, or not sharply enough: a few of them are normal. "
            "The time left is computed from the views that are done.",
        ),
    ),
    "edit": PageHelp(
        QT_TRANSLATE_NOOP("help", "Points that do not belong to the object are taken out here, and distances are measured."),
        QT_TRANSLATE_NOOP(
            "help", "Cut the base off, then brush or lasso what is left over. Every step can be taken back with Ctrl+Z; no point is ever deleted."
        ),
        QT_TRANSLATE_NOOP("help", "Lengths are in millimetres between measured points, areas in square millimetres within the section."),
    ),
    "reconstruct": PageHelp(
        QT_TRANSLATE_NOOP(
            "help", "The points become a closed surface: a balloon is inflated inside them, refined where they ask for it, and smoothed."
        ),
        QT_TRANSLATE_NOOP("help", "Start it with the detail as it stands. You may stop it and keep what is there, or scan the next order meanwhile."),
        QT_TRANSLATE_NOOP(
            "help",
            "The error is the distance of the points to the surface: half of them are nearer than the first number, 95 % nearer than the second. "
            "Its width should be about the noise of a point.",
        ),
    ),
    "deliver": PageHelp(
        QT_TRANSLATE_NOOP("help", "The surface is checked and leaves the program as a file for the next machine, with a certificate beside it."),
        QT_TRANSLATE_NOOP(
            "help", "Read the checks: what is amber says in one sentence what it means. Choose the profile of the receiver and deliver."
        ),
        QT_TRANSLATE_NOOP(
            "help",
            "The coverage is the share of the surface that was measured, the rest was spanned. "
            "The uncertainty is that of a point of the surface, one standard deviation.",
        ),
    ),
    "compare": PageHelp(
        QT_TRANSLATE_NOOP("help", "Two surfaces of the same object, before and after, are laid upon each other and their difference is shown."),
        QT_TRANSLATE_NOOP("help", "Drop both files, say which part has not changed, and compare. Then go through the areas, the largest first."),
        QT_TRANSLATE_NOOP(
            "help",
            "A deviation is positive where the surface after lies outside of the one before. "
            "What is smaller than the detection level cannot be told from noise and stays grey.",
        ),
    ),
    "settings": PageHelp(
        QT_TRANSLATE_NOOP("help", "What is set once: looks, language, folders, and what a scan does by itself."),
        QT_TRANSLATE_NOOP("help", "Every change is in force at once or says when it will be, and Ctrl+Z takes it back."),
        QT_TRANSLATE_NOOP("help", "The size is that of everything in the window: 150 % makes texts and buttons half as large again."),
    ),
    "assistant": PageHelp(
        QT_TRANSLATE_NOOP("help", "A rig of your own is set up here: its board and cameras are found, checked, and written into a file."),
        QT_TRANSLATE_NOOP(
            "help", "Go from step to step. Each says what it moves before it does; keep the lid closed and the stop button within reach."
        ),
        QT_TRANSLATE_NOOP("help", "Directions and steps are measured by what the cameras see, and corrected in the file where they differ."),
    ),
    "verify": PageHelp(
        QT_TRANSLATE_NOOP("help", "A sphere of certified size is measured: it tells whether the rig still measures right."),
        QT_TRANSLATE_NOOP(
            "help",
            "Put the sphere into the middle of the table, enter the diameter from its certificate, and start. "
            "Do it once a month, and after every calibration.",
        ),
        QT_TRANSLATE_NOOP(
            "help",
            "The size deviation is the measured diameter less the certified one; U is its uncertainty, k = 2. PF is the distance between the "
            "outermost and the innermost point, D95 the width that holds 95 % of the points, σ their standard deviation.",
        ),
    ),
    "coverage": PageHelp(
        QT_TRANSLATE_NOOP("help", "Where the surface is not measured, or only thinly: a list of places, the largest first."),
        QT_TRANSLATE_NOOP(
            "help",
            "Fill now scans more where the laser reaches as the object stands. For what is hidden set the object down another way and scan that, "
            "or accept the place as it is.",
        ),
        QT_TRANSLATE_NOOP("help", "An area is that of the missing surface in square millimetres. The sign at each place says why it is missing."),
    ),
    "mounts": PageHelp(
        QT_TRANSLATE_NOOP("help", "The object is scanned again, set down another way, and both scans are brought together."),
        QT_TRANSLATE_NOOP(
            "help", "Set it down so that what was below looks up, and scan this mount. If it does not fit by itself, pick three points on both."
        ),
        QT_TRANSLATE_NOOP("help", "The distance says how well both agree where they overlap; it should be about the noise of a point."),
    ),
    "pick": PageHelp(
        QT_TRANSLATE_NOOP("help", "Three places that both mounts have in common tell the program how the object was set down."),
        QT_TRANSLATE_NOOP(
            "help",
            "Pick a place on the left, then the same place on the right, three times and far apart. "
            "Without a mouse: turn with the arrow keys, pick with space.",
        ),
        QT_TRANSLATE_NOOP("help", "The places need not be exact: a few millimetres are enough, the rest is computed from all points."),
    ),
}
"""By page id."""
