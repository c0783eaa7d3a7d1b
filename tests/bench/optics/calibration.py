"""How good a calibration is, and whether it knows: whole calibrations from rendered boards against the rig's truth.

``python -m tests.bench.optics.calibration --seeds 8 --presets bench paper-2003 workshop``

Every seed is another board (bent to one side or the other by 0.3 mm, printed 0.2 % too large or too small), other poses and
other noise, and another length bar, which is as wrong as its certificate allows.  Columns, lengths in um:

- cube: rms error over the cube of +-50 mm on the table after rigid alignment; large: the same over the largest cube that
  both cameras see;
- ppm: error of the scale over the cube;
- axis: angle in degrees, and distance of the axis where it meets the table;
- z: rms, over the cube, of the error in the table frame (x, y, z) over its standard uncertainty as the calibration predicts it;
  the height of the table, a datum, is taken out of z.  One seed's points share their error: only the pooled figure tells.
"""

from __future__ import annotations

import argparse
import time

import cv2
import numpy as np

from scanner_core.clock import SteppedClock
from scanner_core.errors import CalibrationError
from scanner_core.optics.board import DEFAULT_BAR, DEFAULT_TARGET, LengthBar
from scanner_core.optics.calibration_session import CalibrationSettings, run_calibration
from scanner_core.virtual.bench import VirtualBench
from scanner_core.virtual.presets import PRESETS
from scanner_core.virtual.print_errors import BoardFaults
from tests.core.optics.boards import axis_error, calibration_z, largest_cube_mm, scale_error_ppm, volume_error_um
from tests.core.optics.tables import Table


def measure(preset: str, seed: int) -> dict[str, float]:
    """One calibration, compared with the truth."""
    rng = np.random.default_rng([seed, 0xCA11B])
    bow, twist, grown = rng.choice([-1, 1], 3)
    faults = BoardFaults(bow_mm=0.3 * bow, twist_mm=0.12 * twist, scale=1 + 0.002 * grown, seed=seed)
    certified = LengthBar(length_mm=DEFAULT_BAR.length_mm + DEFAULT_BAR.uncertainty_mm * float(np.clip(rng.standard_normal(), -2, 2)))
    table = Table()
    bench = VirtualBench(PRESETS[preset], None, SteppedClock(), table, seed, faults=faults)
    began_s = time.process_time()
    result = run_calibration(
        bench.camera("left"),
        bench.camera("right"),
        table,
        bench.board_operator(),
        DEFAULT_TARGET,
        CalibrationSettings(bar=certified),
        date="2026-01-01",
    )
    spent_s = time.process_time() - began_s
    found, truth = result.calibration, bench.truth_calibration()
    z = calibration_z(found, truth)
    angle_deg, off_um = axis_error(found, truth)
    return {
        "cube": volume_error_um(found, truth)[0],
        "large": volume_error_um(found, truth, largest_cube_mm(truth))[0],
        "ppm": scale_error_ppm(found, truth),
        "axis_deg": angle_deg,
        "axis_um": off_um,
        "zx": float(np.sqrt((z[:, 0] ** 2).mean())),
        "zy": float(np.sqrt((z[:, 1] ** 2).mean())),
        "zz": float(np.sqrt((z[:, 2] ** 2).mean())),
        "held_um": found.held_out_rms_um,
        "k3": float(result.stereo.with_k3),
        "cpu_s": spent_s,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seeds", type=int, default=8, help="seeds 0 to N - 1")
    parser.add_argument("--presets", nargs="+", default=list(PRESETS))
    given = parser.parse_args()
    cv2.setNumThreads(1)
    for preset in given.presets:
        rows = []
        print(f"{preset}: largest cube +-{_cube(preset):.0f} mm")
        for seed in range(given.seeds):
            try:
                row = measure(preset, seed)
            except CalibrationError as fault:
                print(f"{seed:4d}  {fault}")
                continue
            if not rows:
                print("seed " + " ".join(f"{name:>8s}" for name in row))
            rows.append(row)
            print(f"{seed:4d} " + " ".join(f"{value:8.4f}" if name == "axis_deg" else f"{value:8.2f}" for name, value in row.items()), flush=True)
        if rows:
            columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
            print("rms  " + " ".join(f"{np.sqrt((column**2).mean()):8.4f}" for column in columns.values()))
            print("max  " + " ".join(f"{np.abs(column).max():8.4f}" for column in columns.values()), flush=True)


def _cube(preset: str) -> float:
    bench = VirtualBench(PRESETS[preset], None, SteppedClock(), Table(), 0)
    return largest_cube_mm(bench.truth_calibration())


if __name__ == "__main__":
    main()
