"""What serial ports raise, by call and platform.  Standard library only: the guardian process starts with it."""

from __future__ import annotations

import errno

try:
    import termios

    TRANSPORT_FAULTS: tuple[type[BaseException], ...] = (OSError, termios.error)
except ImportError:
    TRANSPORT_FAULTS = (OSError,)
"""What an unplugged port raises (SerialException is an OSError, termios.error is not)."""

OPEN_FAULTS: tuple[type[BaseException], ...] = (*TRANSPORT_FAULTS, ValueError)
"""What opening raises: ValueError for a URL of an unknown kind."""


def fault_kind(fault: BaseException) -> str:
    """Why a port did not open: ``busy``, ``permission`` or ``missing``."""
    number = getattr(fault, "errno", None)
    text = str(fault).lower()
    if number in (errno.EBUSY, errno.EAGAIN) or "exclusively lock" in text or "access is denied" in text:
        return "busy"
    return "permission" if number in (errno.EACCES, errno.EPERM) else "missing"
