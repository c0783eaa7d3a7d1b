"""Pictures of every page, taken from the running program on the virtual rig, in both themes.

::

    xvfb-run -a -s "-screen 0 1600x1000x24" python -m tests.gui.screenshots docs/pictures
    QT_SCALE_FACTOR=2 xvfb-run -a -s "-screen 0 2700x1700x24" python -m tests.gui.screenshots docs/pictures
    python -m tests.gui.screenshots docs/pictures --scenes scan,deliver --language it --themes dark

The cases that the scenes begin with are scanned first, and kept with ``--prepared FOLDER`` for the next time.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
from pathlib import Path

SIZE = (1280, 800)

# nothing else at the top: a camera's reader is a process that imports this module again


def main() -> int:
    from tests.gui.tour import SCENES, THEMES

    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scenes", default="", help="their names, with commas between; all of them without")
    parser.add_argument("--themes", default=",".join(THEMES))
    parser.add_argument("--language", default="en", help="another one than English stands in the names of the pictures")
    parser.add_argument("--prepared", type=Path, help="where the scanned cases are kept")
    parser.add_argument("--list", action="store_true", help="the names of the scenes, and no picture")
    given = parser.parse_args()
    if given.list:
        print("\n".join(SCENES))
        return 0
    wanted = given.scenes.split(",") if given.scenes else list(SCENES)
    if unknown := set(wanted) - set(SCENES):
        parser.error(f"no such scene: {', '.join(sorted(unknown))}")
    if sys.platform.startswith("linux"):
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    given.folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as home:
        failed = take(given.folder, wanted, given.themes.split(","), given.language, given.prepared or Path(home) / "prepared", Path(home))
    if failed:
        print(f"not taken: {', '.join(failed)}", file=sys.stderr)
    return 1 if failed else 0


def take(folder: Path, wanted: list[str], themes: list[str], language: str, prepared: Path, home: Path) -> list[str]:
    """The scenes of one language; what could not be taken is the answer."""
    from app.main import make_application
    from app.program import Program
    from scanner_core.log_file import logging_to_file
    from tests.gui.tour import SCENES
    from tests.gui.tour.prepared import Prepared
    from tests.gui.tour.registry import names_of
    from tests.gui.tour.tour import Tour
    from tests.gui.waiting import until

    cases = home / "Documents" / "Impronta"
    made = Prepared(prepared)
    made.lay_out(cases)
    os.environ.setdefault("MPLCONFIGDIR", str(prepared / "matplotlib"))  # it looks for all fonts once
    os.environ["HOME"] = str(home)
    for name in ("STATE", "DATA"):
        os.environ[f"XDG_{name}_HOME"] = str(home / name.lower())
    made.measure_spheres()
    settings = home / "config" / "settings.json"
    settings.parent.mkdir()
    kept = {"case_folder": str(cases), "export_folder": str(cases), "specimen": "ear", "window": list(SIZE), "language": language, "theme": "dark"}
    settings.write_text(json.dumps(kept))
    with logging_to_file("the window"):
        program = Program(make_application(), started_s=time.perf_counter(), settings_file=settings)
        try:
            until(lambda: program.window.scene is not None, 120, "the 3D view")
            tour = Tour(program, made, folder, wanted, themes, "" if language == "en" else f"-{language}")
            tour.take(list(dict.fromkeys(SCENES.values())), names_of)
        finally:
            program.window.close()
    return tour.failed


if __name__ == "__main__":
    sys.exit(main())
