"""The headless command line of the instrument: ``impronta SUBCOMMAND``.

Exit codes: 0 done, 1 it could not be done (one sentence on standard error), 2 wrong usage, 3 done with the verdict
"fail" (acceptance tests; a surface that is not ready to be delivered), 130 interrupted.
"""

from __future__ import annotations

import argparse
import importlib
import logging
import signal
import sys
import threading
from collections.abc import Sequence
from types import ModuleType

from scanner_core import __version__
from scanner_core.commands.console import Console
from scanner_core.errors import ImprontaError
from scanner_core.log_file import log_fault, log_versions, logging_to_file
from scanner_core.support.private_names import file_names

_INTERRUPTED = {
    "calibrate": "the laser is off, nothing was kept, and the previous calibration stays in use",
    "verify": "the laser is off, and nothing had been measured that could be kept",
    "scan": "the laser is off, and what was measured before is kept in the case",
    "demo": "the laser is off, and what was scanned before is kept in the case",
}
"""What is true when a command is interrupted that did not itself say how it ended."""
_log = logging.getLogger("impronta")
_LINE = 'by a laser line instead of the spot (a rig file: shape = "line" in [laser]); 8 table positions where none are asked for'
_UNTIL = "scan on where the surface is uncertain, until its standard uncertainty is below U um wherever light reaches, or the points are spent"
_SPECIMENS = "ear, ear-pair (not for demo), arch, heart, sphere, or a mesh file (STL, PLY, OBJ, VTP in millimetres, 3MF)"


def main(argv: Sequence[str] | None = None) -> int:
    """Run a subcommand and return its exit code."""
    if threading.current_thread() is threading.main_thread():
        for number in (signal.SIGINT, signal.SIGTERM):  # a shell starts its background jobs with SIGINT ignored
            signal.signal(number, _as_interrupt)
        hang_up = getattr(signal, "SIGHUP", None)  # the terminal was closed; nohup has it ignored, and Windows has none
        if hang_up is not None and signal.getsignal(hang_up) is not signal.SIG_IGN:
            signal.signal(hang_up, _as_interrupt)
    try:
        given = _parser().parse_args(argv)
        command = importlib.import_module(f"scanner_core.commands.{given.command}")
    except KeyboardInterrupt:
        Console(as_json=False).say("Interrupted; nothing was done.")
        return 130
    console = Console(given.json)
    try:
        with logging_to_file(f"impronta {given.command}", file_names(_paths(given))):
            log_versions()
            code = _run(command, given, console)
            _log.info("exit code %d", code)
            return code
    except KeyboardInterrupt:
        console.say(f"Interrupted; {_INTERRUPTED.get(given.command, 'nothing was written')}.")
        return 130


def _run(command: ModuleType, given: argparse.Namespace, console: Console) -> int:
    try:
        return int(command.run(given, console))
    except ImprontaError as error:
        log_fault(error, given.command)
        console.say(str(error))
        return 2 if error.code == "E-USE-01" else 1
    except BrokenPipeError:
        return 1
    except MemoryError as fault:
        log_fault(fault, given.command)
        console.say(str(ImprontaError("E-MEM-01", command=given.command)))
        return 1
    except Exception as fault:
        log_fault(fault, given.command)
        raise


def _paths(given: argparse.Namespace) -> list[str]:
    """What of the arguments are files: a person has chosen their names, and they may be a patient's."""
    values = [value for value in vars(given).values() if value]
    texts = [text for value in values for text in (value if isinstance(value, list) else [value]) if isinstance(text, str)]
    return [text for text in texts if any(mark in text for mark in "/\\.")]


def _as_interrupt(_number: int, _frame: object) -> None:
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    about = "Measure anatomical parts without touching them. Without a subcommand the window opens."
    parser = argparse.ArgumentParser(prog="impronta", description=about)
    parser.add_argument("--version", action="version", version=f"impronta {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="SUBCOMMAND")

    demo = _command(commands, "demo", "the whole job on the virtual rig: calibrate, scan, register, reconstruct, export")
    demo.add_argument("--specimen", default="ear", metavar="NAME or FILE", help=_SPECIMENS)
    demo.add_argument("--treated", action="store_true", help="the arch after treatment")
    demo.add_argument("--preset", default="bench", help="bench, paper-2003 or workshop")
    demo.add_argument("--points", type=_count, default=None, metavar="N", help="wanted number of points (default 20000)")
    demo.add_argument("--views", type=_count, default=None, metavar="N", help="table positions (default 16)")
    demo.add_argument("--marks", action="store_true", help="three balls on the table's rim that watch over the rig (a rig file: table [marks])")
    demo.add_argument("--line", action="store_true", help=_LINE)
    demo.add_argument("--until-um", type=_positive, default=None, metavar="U", help=_UNTIL)
    demo.add_argument("--out", metavar="DIR", help="folder of the results (default: a new dated folder here)")
    demo.add_argument("--triangles", type=_count, default=None, metavar="N", help="at most N triangles")
    demo.add_argument("--force", action="store_true", help="overwrite results that are there")
    _virtual(demo)

    calibrate = _command(commands, "calibrate", "stereo, scale and turntable axis from ChArUco views and a known length")
    _measuring_rig(calibrate)
    calibrate.add_argument("--out", metavar="RIG.toml", help="the rig with its new calibration (default: report only)")
    calibrate.add_argument("--force", action="store_true", help="overwrite a rig file that is there")
    calibrate.add_argument("--length-mm", type=_positive, default=None, metavar="L", help="certified length of the length bar (virtual rig: 150)")
    calibrate.add_argument("--no-length", action="store_true", help="there is no length bar: the scale stays unverified")
    calibrate.add_argument(
        "--print-width-mm", type=_positive, default=None, metavar="W", help="measured width of the printed row of squares; it sets the scale"
    )
    calibrate.add_argument("--square-mm", type=_positive, default=None, metavar="S", help="nominal size of the board's squares (default 25)")
    calibrate.add_argument("--thickness-mm", type=_length, default=0.0, metavar="T", help="of the board, from the table to its printed face")
    calibrate.add_argument("--valid-days", type=_positive, default=None, metavar="N", help="how long it may be used (default: as before, else 30)")
    calibrate.add_argument("--seed", type=_seed, default=0, metavar="N", help="of the virtual rig")

    target = _command(commands, "target", "the calibration board as a page to print at true scale")
    target.add_argument("--out", required=True, metavar="BOARD.pdf")
    target.add_argument("--paper", choices=("a4", "letter", "a3"), default="a4", help="landscape (default a4)")
    target.add_argument("--force", action="store_true", help="overwrite the output")

    scan = _command(commands, "scan", "acquire into a new case, go on with an interrupted one, or add another mount")
    _measuring_rig(scan)
    scan.add_argument("--plan", metavar="PLAN.toml", help="views, points, object_radius_mm, object_height_mm, until_um")
    scan.add_argument("--line", action="store_true", help=_LINE)
    scan.add_argument("--until-um", type=_positive, default=None, metavar="U", help=_UNTIL)
    scan.add_argument("--out", required=True, metavar="CASE.impronta")
    scan.add_argument("--specimen", default="ear", metavar="NAME or FILE", help=f"virtual rig only: {_SPECIMENS}")
    scan.add_argument("--treated", action="store_true", help="virtual rig only: the arch after treatment")
    pose = "virtual rig only: how the specimen was put down, turns in degrees about the table's x, then y, then z (--pose=-90,0,20), or random:SEED"
    scan.add_argument("--pose", metavar="RX,RY,RZ", help=pose)
    scan.add_argument("--resume", action="store_true", help="go on with the interrupted scan of CASE: known points first, then what is missing")
    add_mount = "the object was turned or tilted: scan it into CASE as its next mount, and bring the mounts together"
    scan.add_argument("--add-mount", action="store_true", help=add_mount)
    scan.add_argument("--force", action="store_true", help="overwrite a case that is there")
    _virtual(scan)

    register = _command(commands, "register", "bring the mounts of a case into one frame again, or with picked points")
    register.add_argument("case", metavar="CASE")
    pairs = "at least three points of a mount, one a line: mount, x, y, z on it, and x, y, z of the same place on the first mount, mm"
    register.add_argument("--pairs", metavar="FILE", help=pairs)
    register.add_argument("--seed", type=_seed, default=0, metavar="N", help="of the search")

    split = _command(commands, "split", "the run of a pair tray, both ears on one table, to a case for each ear")
    split.add_argument("case", metavar="CASE")
    split.add_argument("--out", metavar="DIR", help="folder of the two cases (default: beside CASE)")

    reconstruct = _command(commands, "reconstruct", "points to a closed triangular mesh")
    reconstruct.add_argument("input", metavar="INPUT", help="PLY, XYZ/TXT/CSV/ASC, NPY or a case")
    reconstruct.add_argument("--out", required=True, metavar="MESH", help=".stl .ply .obj .3mf")
    reconstruct.add_argument("--triangles", type=_count, default=None, metavar="N", help="at most N triangles, at least 0.98 N of the closed surface")
    reconstruct.add_argument("--tolerance-um", type=_positive, default=None, metavar="T", help="95 of 100 facets within T um of the fitted surface")
    reconstruct.add_argument("--open-holes", action="store_true", help="leave away what no point supports, instead of capping it")
    reconstruct.add_argument("--units", choices=("mm", "m", "inch"), default="mm", help="of the input's coordinates")
    reconstruct.add_argument("--seed", type=_seed, default=0, metavar="N")
    _processing(reconstruct)
    reconstruct.add_argument("--force", action="store_true", help="overwrite the output")

    _compare(commands)

    info = _command(commands, "info", "what is in a case, mesh or point file")
    info.add_argument("file", metavar="FILE")

    measure = _command(commands, "measure", "canal length, volume, area and a section of a case's surface or of a mesh file")
    measure.add_argument("file", metavar="FILE")
    measure.add_argument("--height", type=float, metavar="MM", help="a level section at this height")

    export = _command(commands, "export", "mesh or points out of a case")
    export.add_argument("case", metavar="CASE")
    export.add_argument("--out", required=True, metavar="FILE", help=".stl .ply .obj .3mf .dcm for the mesh, .xyz for the points")
    export.add_argument("--force", action="store_true", help="overwrite the output")

    deliver = _command(commands, "deliver", "check a case's surface, and write what the laboratory wants, with a certificate")
    deliver.add_argument("case", metavar="CASE")
    profile = "of the export: its name or a beginning of it, also of your own (default: by the type of the order)"
    deliver.add_argument("--profile", metavar="NAME", help=profile)
    deliver.add_argument("--out", metavar="DIR", help="folder of the files (default: only check)")
    deliver.add_argument("--name", metavar="TEMPLATE", help="of the files, instead of the profile's: {order}_{side}_{type}_{date}-{rev}")
    deliver.add_argument("--anyway", action="store_true", help="also when it is not ready; the certificate says so")
    deliver.add_argument("--force", action="store_true", help="overwrite files that are there")

    coverage = _command(commands, "coverage", "which places of a case's surface are not as certain as wanted, and why")
    coverage.add_argument("case", metavar="CASE")
    coverage.add_argument("--until-um", type=_positive, default=40.0, metavar="U", help="wanted standard uncertainty (default 40)")

    _verify(commands)

    doctor = _command(commands, "doctor", "check the rig and the machine")
    doctor.add_argument("--rig", metavar="RIG.toml", help="a rig file, or the name of a preset (default: find devices, and check the virtual rig)")
    doctor.add_argument("--find", action="store_true", help="ask every serial port and look at every camera; --rig gives limits for --out")
    doctor.add_argument("--port", action="append", default=[], metavar="URL", help="ask this port instead of those of the system; may be repeated")
    stream = "look at this network camera (http://..., rtsp://...) instead of those of the system; repeated: the left one, then the right one"
    doctor.add_argument("--camera", action="append", default=[], metavar="URL", help=stream)
    doctor.add_argument("--out", metavar="RIG.toml", help="write a rig file for what was found, after a check of it")
    doctor.add_argument("--thumbnails", metavar="DIR", help="write what the cameras show as pictures")
    doctor.add_argument("--force", action="store_true", help="overwrite files that are there")
    doctor.add_argument("--specimen", default="sphere", metavar="NAME or FILE", help=f"on the virtual rig's table: {_SPECIMENS}")
    _virtual(doctor)

    support = _command(commands, "support", "one archive for whoever helps: log, versions, rig, transcript and doctor's report, without names")
    support.add_argument("--rig", metavar="RIG.toml", help="a rig file, or the name of a preset (default: find devices)")
    support.add_argument("--out", metavar="FILE.zip", help="where to write it; nothing is sent")
    support.add_argument("--list", action="store_true", help="only show what would go in")
    support.add_argument("--without", action="append", default=[], metavar="NAME", help="leave an entry out; may be repeated")
    support.add_argument("--force", action="store_true", help="overwrite an archive that is there")
    return parser


def _processing(parser: argparse.ArgumentParser) -> None:
    """How the points of a case are computed; the choice is kept in the case."""
    parser.add_argument("--calibration", metavar="RIG.toml", help="of a case: another calibration (a rig file, a preset, or an id of the case)")
    gates = "limits of a case's points: least_sigma_px, most_sigma_px, least_peak_dn, most_uncertainty_px (of the spots; only narrower), "
    gates += "epipolar_sigmas (3), volume_radius_mm, volume_height_mm, table_mm (0.15); may be repeated"
    parser.add_argument("--gate", action="append", default=[], metavar="NAME=VALUE", help=gates)
    parser.add_argument("--without-view", action="append", type=_seed, default=[], metavar="N", help="leave a view of a case out; may be repeated")
    parser.add_argument("--scan", action="append", type=_count, default=[], metavar="N", help="of a case: merge these scans (default: the newest)")
    parser.add_argument("--as-scanned", action="store_true", help="drop what was chosen for a case before")


def _compare(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    compare = _command(commands, "compare", "what moved between two surfaces, where, how much, and whether that can be trusted")
    compare.add_argument("before", metavar="BEFORE", help="STL, PLY, OBJ, VTP, 3MF or a case")
    compare.add_argument("after", metavar="AFTER", nargs="+", help="the same later; several in the order of time are a series")
    frames = "what is held fixed: the region that did not change (auto, the default), everything (whole), a marked part (mask); given: no alignment"
    compare.add_argument("--frame", choices=("auto", "whole", "mask", "given"), default="auto", help=frames)
    mask = "the stable part of AFTER: JSON with a list of its vertices' numbers (from 0), or a mesh cut out of AFTER, in the place where it was"
    compare.add_argument("--mask", metavar="FILE", help=mask)
    compare.add_argument("--tolerance-um", type=_positive, default=250.0, metavar="T", help="clinical threshold (default 250)")
    compare.add_argument("--jaw", choices=("upper", "lower"), help="needed for words such as 'right' and 'towards the cheek'")
    for name, of in (("--units", "all files"), ("--units-before", "BEFORE"), ("--units-after", "every AFTER")):
        help_text = f"of the numbers of {of} (default: as the file says, else guessed from the size)"
        compare.add_argument(name, choices=("mm", "cm", "m", "inch"), help=help_text)
    compare.add_argument("--out", metavar="DIR", help="folder of report.pdf, report.html, deviation.ply, table.csv (default: only tell)")
    dicom = "also write the report and the later surface as DICOM files for an archive (needs 'impronta[dicom]')"
    compare.add_argument("--dicom", action="store_true", help=dicom)
    compare.add_argument("--keep", action="store_true", help="keep the comparison in the case AFTER")
    compare.add_argument("--rig", metavar="RIG.toml", help="show the level of detection that was measured with this rig (null comparison)")
    compare.add_argument("--material", metavar="NAME", help="of the model, for the null comparison")
    null = "BEFORE and AFTER are one model of --material, measured twice with --rig: store what seems to have changed as its level of detection"
    compare.add_argument("--null", action="store_true", help=null)
    compare.add_argument("--seed", type=_seed, default=0, metavar="N", help="of every random choice")
    compare.add_argument("--force", action="store_true", help="overwrite results that are there")


def _verify(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    verify = _command(commands, "verify", "the metrological tests of a rig, with a certificate")
    tests = verify.add_subparsers(dest="test", required=True, metavar="TEST")

    static = tests.add_parser("static", help="the scatter of a spot at rest on a plate")
    static.add_argument("--repeats", type=_repeats, default=32_000, metavar="N", help="pairs of frames (default 32000)")
    static.add_argument("--places", type=_count, default=256, metavar="K", help="of the spot, among which they are spread (default 256)")

    sphere = tests.add_parser("sphere", help="size and dispersion of a calibrated sphere")
    sphere.add_argument("--acquisitions", type=_count, default=10, metavar="N", help="the sphere is put down anew for each (default 10)")
    sphere.add_argument("--points", type=_count, default=3500, metavar="N", help="of each acquisition (default 3500)")
    sphere.add_argument("--views", type=_count, default=8, metavar="N", help="table positions of each acquisition (default 8)")
    sphere.add_argument("--specimen", default="sphere", metavar="NAME or FILE", help=f"virtual rig only: {_SPECIMENS}")

    acceptance = tests.add_parser("acceptance", help="form, size and spacing with a ball bar, after VDI/VDE 2634 part 3")
    acceptance.add_argument("--positions", type=_count, default=7, metavar="N", help="of the bar; fewer than 7 prove nothing (default 7)")
    acceptance.add_argument("--points", type=_count, default=1600, metavar="N", help="of each position (default 1600)")
    acceptance.add_argument("--views", type=_count, default=6, metavar="N", help="table positions of each position of the bar (default 6)")
    acceptance.add_argument("--spacing-mm", type=_positive, default=80.0, metavar="MM", help="calibrated distance of the centres (default 80)")
    acceptance.add_argument("--spacing-uncertainty-mm", type=_positive, default=0.001, metavar="MM", help="k = 1 (default 0.001)")
    for test in (sphere, acceptance):
        test.add_argument("--reference-mm", type=_positive, default=11.133, metavar="MM", help="calibrated radius (default 11.133)")
        test.add_argument("--reference-uncertainty-mm", type=_positive, default=0.001, metavar="MM", help="of the radius, k = 1 (default 0.001)")
    for test in (static, sphere, acceptance):
        test.add_argument("--json", action="store_true", default=argparse.SUPPRESS, help="print one JSON object")
        _measuring_rig(test)
        test.add_argument("--out", metavar="DIR", help="folder of certificate.pdf and result.json (default: report only)")
        test.add_argument("--force", action="store_true", help="overwrite results that are there")
        _virtual(test)


def _command(commands: argparse._SubParsersAction[argparse.ArgumentParser], name: str, text: str) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    return parser


def _measuring_rig(parser: argparse.ArgumentParser) -> None:
    """What is measured with: devices, or what they once delivered."""
    rig = parser.add_mutually_exclusive_group(required=True)
    rig.add_argument("--rig", metavar="RIG.toml", help="a rig file, or the name of a preset")
    rig.add_argument("--replay", metavar="DIR", help="the cameras of a recording instead, with the rig that it was made with")
    parser.add_argument("--record", metavar="DIR", help="record every frame of both cameras, losslessly, into a new folder")


def _virtual(parser: argparse.ArgumentParser) -> None:
    from scanner_core.virtual.faults import FAULTS

    parser.add_argument("--speed", type=_speed, default="max", metavar="1, 5, max", help="of the virtual rig (default max)")
    parser.add_argument("--seed", type=_seed, default=0, metavar="N", help="of every random choice")
    without = "terms of the virtual rig's image model to switch off, to see what limits it: speckle, surface, shot_noise, ..."
    parser.add_argument("--without", type=lambda text: text.split(","), default=[], metavar="TERM,...", help=without)
    parser.add_argument(
        "--fault",
        action="append",
        default=[],
        metavar="NAME[@TIME]",
        help=f"let something go wrong on the virtual rig, TIME seconds after the scan began: {', '.join(FAULTS)}; may be repeated",
    )


def _speed(text: str) -> float | str:
    if text == "max":
        return text
    value = _number(text)
    if not 0.1 <= value <= 100:
        raise argparse.ArgumentTypeError("a speed is 1, 5 or max")
    return value


def _seed(text: str) -> int:
    return _whole(text, 0)


def _count(text: str) -> int:
    return _whole(text, 1)


def _repeats(text: str) -> int:
    return _whole(text, 3)  # fewer have no scatter within a stay and between stays


def _whole(text: str, least: int) -> int:
    """Argparse would name the function that raised a ValueError; the sentence is for the user."""
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number") from None
    if value < least:
        raise argparse.ArgumentTypeError(f"must be at least {least}")
    return value


def _positive(text: str) -> float:
    value = _number(text)
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError("must be a positive number")
    return value


def _length(text: str) -> float:
    value = _number(text)
    if not 0 <= value < 1e3:
        raise argparse.ArgumentTypeError("must be a length in millimetres")
    return value


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no number") from None


if __name__ == "__main__":
    sys.exit(main())
