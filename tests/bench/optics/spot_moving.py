"""What a spot that moves during the exposure, clipped or not, does to the centroids; the truth is the middle of its way.

Compared are the Gaussian fit, which censors clipped pixels, the detector's ``weighted`` (the fit where pixels clip), and the bare
centre of gravity that takes clipped pixels at their word.  The bound is that of a Gaussian of the same second moments;
the smeared spot is none, so the fit may miss it by a little.
"""

from __future__ import annotations

import argparse
import itertools
from dataclasses import replace

import numpy as np

from scanner_core.optics.spot import Spot
from scanner_core.optics.spot_detection import SpotDetector, SpotDetectorParameters
from tests.bench.optics.spot_images import BENCH, Array, SpotShape, bound, expose, framed, signals

SIZE, MARGIN, INSTANTS = (40, 40), 64, 9


def errors(way_px: float, peak_dn: float, count: int, seed: int) -> tuple[dict[str, Array], Array]:
    """rms errors of x and y by method, and the bound, px; `peak_dn` is that of the spot at rest."""
    rng = np.random.default_rng(seed)
    shape = SpotShape(1.0, 0.8, peak_dn)
    parameters = SpotDetectorParameters(read_noise_dn=BENCH.read_dn, shot_dn=BENCH.shot_dn, floor_px=0.0, max_saturated_px=60, max_censored_px=60)
    fast, precise = SpotDetector(parameters), SpotDetector(replace(parameters, centroid="gaussian"))
    places = np.array(SIZE) // 2 + rng.uniform(-0.5, 0.5, (count, 2))
    shifts = way_px * ((np.arange(INSTANTS) + 0.5) / INSTANTS - 0.5)
    light = np.mean([signals(places[:, 0] + shift, places[:, 1], shape.optical, peak_dn, SIZE) for shift in shifts], axis=0)
    found: dict[str, list[tuple[float, float]]] = {"gaussian": [], "weighted": [], "bare": []}
    for (x, y), frame in zip(places + MARGIN, framed(expose(light, BENCH, rng), BENCH, rng, MARGIN), strict=True):
        for name, detector in (("gaussian", precise), ("weighted", fast)):
            seen = detector.detect(frame)
            assert isinstance(seen, Spot)
            found[name].append((seen.x_px - x, seen.y_px - y))
        levels = fast.levels(frame)
        left, top, w, h = fast.boxes(frame, levels)[0][0]
        window = frame[top - 2 : top + h + 2, left - 2 : left + w + 2]
        moments = levels.weights.moments(window, int(window.max()))
        found["bare"].append((left - 2 + moments.x - x, top - 2 + moments.y - y))
    smeared = np.hypot(1.0, way_px / np.sqrt(12))
    equivalent = SpotShape(float(smeared), 0.8, peak_dn / float(smeared))
    return {name: np.sqrt(np.mean(np.square(each), axis=0)) for name, each in found.items()}, bound(equivalent, BENCH, SIZE)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--spots", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    print(f"sigma 1.0 x 0.8 px at rest, {given.spots} spots a row, seed {given.seed}; rms error over bound, x / y")
    for way_px, peak_dn in itertools.product((0.0, 1.0, 2.0, 4.0), (150.0, 300.0, 450.0, 600.0)):
        rms, least = errors(way_px, peak_dn, given.spots, given.seed)
        told = ", ".join(f"{name} {x:.2f} / {y:.2f}" for name, (x, y) in ((name, each / least) for name, each in rms.items()))
        print(f"  moves {way_px:.0f} px, peak {peak_dn:.0f} DN at rest: {told}; bound {1e3 * least[0]:.1f} / {1e3 * least[1]:.1f} mpx")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
