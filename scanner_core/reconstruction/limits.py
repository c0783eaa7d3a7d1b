"""What a reconstruction may be asked for at least and at most."""

from __future__ import annotations

LEAST_TRIANGLES = 200
DETAIL = (1 / 16, 4.0)
SMOOTHING_ROUNDS = (0, 50)
"""More of them inflate a sphere by tens of micrometres."""
PASS_BAND = (0.02, 0.5)
"""Within it Taubin's own condition holds for the filter's lambda."""
SUPPORT = (0.2, 0.9)
"""Above the density that the fit goes on to, and below that of an evenly scanned surface with its chance."""
