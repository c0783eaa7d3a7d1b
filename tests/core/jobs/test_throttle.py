"""What a job tells is thinned before it enters the pipe."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.jobs.progress import Progress
from scanner_core.jobs.serving import Throttle

MESH = TriangleMesh(np.eye(3), np.array([[0, 1, 2]]))


@settings(max_examples=50, deadline=None)
@given(steps=st.lists(st.floats(0, 0.3), max_size=60))
def test_previews_are_rare_and_phases_are_never_lost(steps: list[float]) -> None:
    now, told = [0.0], []
    throttle = Throttle(lambda progress: told.append((now[0], progress)), lambda: now[0])
    for number, step in enumerate(steps):
        now[0] += step
        throttle(Progress(f"phase {number // 10}", 0.5, None, MESH))
    throttle(Progress("end", 1.0))
    previews = [at for at, progress in told if progress.preview is not None]
    assert all(b - a >= 0.2 - 1e-9 for a, b in pairwise(previews))
    assert {progress.phase for _, progress in told} == {f"phase {n // 10}" for n in range(len(steps))} | {"end"}
    assert told[-1][1].fraction == 1.0
