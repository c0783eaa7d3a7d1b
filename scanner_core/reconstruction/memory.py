"""The peak memory of this process."""

from __future__ import annotations

import sys


def peak_memory_mb() -> float:
    """Largest resident size of the process so far, MB; 0 where the system does not tell."""
    if sys.platform == "win32":
        return 0.0
    import resource

    unit = 1e6 if sys.platform == "darwin" else 1e3
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit
