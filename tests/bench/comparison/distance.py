"""The signed distance against libigl in double precision."""

from __future__ import annotations

import time
from collections.abc import Iterable

import numpy as np

from scanner_core.comparison.signed_distance import SignedDistance
from tests.bench.comparison.clean_pair import CleanPair
from tests.bench.comparison.scan_pair import Disturbance, scan


def report(pairs: Iterable[tuple[int, CleanPair]]) -> None:
    """Both ways, at the true alignment; and at points up to 3 mm away."""
    import igl

    for seed, clean in pairs:
        pair = scan(clean, Disturbance(), seed)
        before, after = pair.before.mesh, pair.after.mesh
        there = pair.transform.apply(after.vertices)
        rng = np.random.default_rng(seed)
        for name, points in (("near", there), ("to 3 mm", there + rng.uniform(-1.7, 1.7, there.shape))):
            begun_s = time.perf_counter()
            ours = SignedDistance(before).feet(points)
            seconds = time.perf_counter() - begun_s
            begun_s = time.perf_counter()
            theirs = np.asarray(igl.signed_distance(points, before.vertices, before.triangles, igl.SIGNED_DISTANCE_TYPE_PSEUDONORMAL)[0])
            igl_seconds = time.perf_counter() - begun_s
            off_um = 1e3 * np.abs(np.abs(ours.signed_mm) - np.abs(theirs))
            agree = (np.sign(ours.signed_mm) == np.sign(theirs))[np.abs(theirs) > 1e-9]
            found = f"largest difference {off_um.max():.2e} um, signs agree {agree.mean():.5%}"
            print(f"distance {name}: seed {seed}: {found}; {seconds:.2f} s, libigl {igl_seconds:.2f} s", flush=True)
