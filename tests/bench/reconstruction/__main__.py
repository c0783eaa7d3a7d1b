"""Errors, topology and uncertainties of the reconstruction on surfaces whose truth is known, with the peers on the same draws.

Each draw has points and noise of its own; the seeds begin at an offset that is stated, and with which a run can be repeated.
The peers run at settings that were chosen with the truth in view, ours at its defaults.  Rows with a * are shapes on which
nothing was ever tuned.  "surface" is area-uniform points of the mesh to the truth, "complete" the way back, "upper 95 %" the
one-sided limit of the mean of the draws' ratios, "expected" what ours states of its own error, "z sd" the spread of the
vertices' errors over their stated standard uncertainties, "over clean" the error over that of the row with a clean cloud.
With more than one job at a time the seconds are not to be trusted.
"""

from __future__ import annotations

import argparse
import json
import platform
import secrets
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from tests.bench.reconstruction.bench import Result, compare_to_clean, run_draw, sum_up
from tests.bench.reconstruction.rows import ROWS, selected
from tests.bench.reconstruction.table import HEADER, lines
from tests.bench.reconstruction.truth import DEFAULT_CACHE, truth_mesh


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", default=["*"], metavar="NAME", help="globs on the names of the rows")
    parser.add_argument("--list", action="store_true", help="only print the names of the rows")
    parser.add_argument("--draws", type=int, default=6, help="per row; rows that need more take more, unless this is given")
    parser.add_argument("--seed", type=int, help="number of the first draw; a random one unless given")
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--jobs", type=int, default=1, help="draws at the same time")
    parser.add_argument("--cache", type=Path, default=DEFAULT_CACHE, help="folder for the truth meshes")
    parser.add_argument("--json", type=Path, help="write every figure of every draw to this file")
    given = parser.parse_args()
    if given.list:
        print("\n".join(row.name for row in ROWS))
        return 0
    rows = selected(given.rows)
    first = secrets.randbelow(1_000_000) + 1 if given.seed is None else given.seed
    asked = any(argument.startswith("--draws") for argument in sys.argv[1:])
    print(f"Draws from {first} on (repeat with --seed {first}), {platform.machine()}, Python {platform.python_version()}")
    print(HEADER, flush=True)
    summaries: dict[str, Result] = {}
    everything: list[Result] = []
    with ProcessPoolExecutor(given.jobs) as pool:
        for row in rows:
            truth_mesh(row.scan.surface, given.cache)  # once, before several processes want it
            count = given.draws if asked else max(given.draws, row.draws)
            tasks = [pool.submit(run_draw, row, draw, given.cache, not given.no_peers) for draw in range(first, first + count)]
            draws = [task.result() for task in tasks]
            summaries[row.name] = sum_up(row, draws)
            compare_to_clean(summaries, [row])
            print("\n".join(lines(summaries[row.name])), flush=True)
            everything.append({"summary": summaries[row.name], "draws": draws})
            if given.json:
                given.json.write_text(json.dumps({"first_draw": first, "rows": everything}, indent=1))
    return 1 if any("failure" in summary for summary in summaries.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
