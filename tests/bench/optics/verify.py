"""The figures of ``impronta verify`` beside those of the published system, and how they depend on what was chosen.

``python -m tests.bench.optics.verify [PRESET ...] [--seed N] [--acquisitions N]`` prints, for every preset: the static spot
over all places and its quartiles by place, the reference sphere, and the acceptance test.  Half an hour for all three.
"""

from __future__ import annotations

import argparse
import time

from scanner_core.acquisition.rig_session import open_rig
from scanner_core.devices.rig import PRESETS, load_preset
from scanner_core.metrology.acceptance import AcceptanceTest
from scanner_core.metrology.reference_sphere import Reference, SphereTest
from scanner_core.metrology.static_spot import StaticTest

PUBLISHED = (
    "published: static 13.9 / 11.5 / 10.6 um, resolution 9.33 um, repeatability about 50 um; "
    "sphere residual 171 um, mean radius 11.147 +- 0.016 mm against 11.133 +- 0.016 mm"
)
RADIUS, SPACING = Reference(11.133, 0.001), Reference(80.0, 0.001)


def static(preset: str, seed: int) -> None:
    with open_rig(load_preset(preset), None, "max", seed) as rig:
        result = StaticTest(rig).run(lambda count: None)
    told = result.as_dict()
    print(f"  static: sd {told['sd_um']}, U {told['sd_uncertainty_um']} (k = 1), resolution {result.resolution_um:.2f} um, ", end="")
    print(f"repeatability {result.repeatability_um:.1f} um, drift {result.drift_length_um:.2f} um")
    print(f"  quartiles of the standard deviation by place: {told['place_sd_quartiles_um']}")


def sphere(preset: str, seed: int, acquisitions: int, views: int) -> None:
    with open_rig(load_preset(preset), None, "max", seed) as rig:
        result = SphereTest(rig, RADIUS, views=views).run(acquisitions, lambda share: None)
    size, dispersion = result.characteristics()
    print(f"  sphere, {acquisitions} x {views} views: residual {result.residual_rms_um:.1f} um, D95 {dispersion.value_um:.1f} um, ", end="")
    print(f"radius {size.value_um:+.1f} um (U {size.expanded_uncertainty_um:.1f}), {result.verdict.value}")


def acceptance(preset: str, seed: int) -> None:
    with open_rig(load_preset(preset), None, "max", seed) as rig:
        result = AcceptanceTest(rig, RADIUS, SPACING).run(7, lambda share: None)
    for c in result.characteristics():
        print(f"  {c.words}: {c.value_um:.1f} um (U {c.expanded_uncertainty_um:.1f}, limit {c.limit_um:g}), {c.verdict.value}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("presets", nargs="*", default=list(PRESETS))
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--acquisitions", type=int, default=10)
    parser.add_argument("--views", type=int, default=8)
    given = parser.parse_args()
    print(PUBLISHED)
    for preset in given.presets:
        print(f"{preset}, seed {given.seed}")
        began = time.process_time()
        static(preset, given.seed)
        sphere(preset, given.seed, given.acquisitions, given.views)
        acceptance(preset, given.seed)
        print(f"  {time.process_time() - began:.0f} s of processor time", flush=True)


if __name__ == "__main__":
    main()
