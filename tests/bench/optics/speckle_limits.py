"""What aperture and motion during the exposure do to the speckle: the scatter of a sphere's points on one rig.

::

    python -m tests.bench.optics.speckle_limits --seed 1 [--preset workshop] [--points 3500]

Rows are f-numbers, columns exposures; a spot stays as large and as bright.  The beam sweeps at the speed that the number
of points gives, so a longer exposure is a longer path.
"""

from __future__ import annotations

import argparse

from tests.bench.optics.point_uncertainty import z_scores

F_NUMBERS = (1.4, 2.0, 2.8, 4.0)
EXPOSURES_MS = (1.0, 6.0, 12.0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--points", type=int, default=3500)
    parser.add_argument("--preset", default="workshop")
    given = parser.parse_args()
    print("        " + "".join(f"{exposure:8.0f} ms" for exposure in EXPOSURES_MS))
    for f_number in F_NUMBERS:
        row = []
        for exposure_ms in EXPOSURES_MS:
            _, error, _ = z_scores(given.preset, {"f_number": f_number, "exposure_ms": exposure_ms}, "sphere", given.points, 8, given.seed)
            row.append(f"{error.std():8.1f} um")
        print(f"f/{f_number:<6}" + "".join(row), flush=True)


if __name__ == "__main__":
    main()
