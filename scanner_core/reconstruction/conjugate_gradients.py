"""Conjugate gradients for several right-hand sides at once."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating]


def conjugate_gradients(
    apply: Callable[[Array], Array], diagonal: Array, right: Array, start: Array, *, tolerance: float, most: int, check: Callable[[], None]
) -> Array:
    """Solve ``A X = right`` for a symmetric positive definite A, (v, k), preconditioned by its diagonal.

    Each column has its own step lengths; it stops when every residual is `tolerance` times its right-hand side, or after
    `most` rounds.  Hestenes and Stiefel 1952.  `check` is called every few rounds, so that a long solve can be stopped.
    The precision is that of `right`: single precision is half the work, and enough for tolerances of 1e-3.
    """
    kind = right.dtype
    x = start.astype(kind)
    residual = right - apply(x)
    scale = (1 / np.maximum(diagonal, 1e-30)).astype(kind)[:, None]
    limit = tolerance**2 * np.maximum(_column_dot(right, right * scale), 1e-30)
    z = residual * scale
    direction = z.copy()
    rho = _column_dot(residual, z)
    for tick in range(most):
        if tick % 8 == 0:
            check()
        if np.all(rho <= limit):
            break
        image = apply(direction)
        step = rho / np.maximum(_column_dot(direction, image), 1e-30)
        x += step * direction
        residual -= step * image
        z = residual * scale
        fresh = _column_dot(residual, z)
        direction = z + (fresh / np.maximum(rho, 1e-30)) * direction
        rho = fresh
    return x


def _column_dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->j", a, b))
