"""``python -m tests.bench.controllers lines --port URL --lines 10000`` and ``... events --port URL --times 20``; JSON on standard output.

Without ``--port`` our firmware model is taken, in a process of its own.  Laser mode ($32=1) must be set on the board; it moves the beam by
up to 8 degrees, lit in sweeps, and the table not at all.  A reset in the middle of everything is among the events.
"""

from __future__ import annotations

import argparse
import json
import sys
from contextlib import ExitStack
from dataclasses import asdict

from scanner_core.clock import ScaledClock
from scanner_core.devices.controller_config import ControllerConfig
from scanner_core.devices.grbl import open_controller
from tests.bench.controllers.events import let_happen
from tests.bench.controllers.lines import send_lines
from tests.core.devices.boards import remote_board


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["lines", "events"])
    parser.add_argument("--port", help="serial device or URL; our firmware model if left out")
    parser.add_argument("--table-axis", default="Z")
    parser.add_argument("--lines", type=int, default=10_000)
    parser.add_argument("--times", type=int, default=10)
    given = parser.parse_args()
    with ExitStack() as stack:
        port = given.port or stack.enter_context(remote_board()).url
        config = ControllerConfig("grbl", port, table_axis=given.table_axis)
        if given.what == "events":
            results = let_happen(config, given.times)
            print(json.dumps([asdict(result) for result in results], indent=1))
            return 0 if all(result.as_expected for result in results) else 1
        with open_controller(config, ScaledClock()) as controller:
            result = send_lines(controller, given.lines)
        print(json.dumps(asdict(result), indent=1))
        return 0 if result.lost_replies == 0 and result.at_goal else 1


if __name__ == "__main__":
    sys.exit(main())
