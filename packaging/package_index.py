"""Why an installation failed, in one sentence with the remedy."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from progress import last_lines

_DISK_FULL = ("No space left on device", "Errno 28", "not enough space on the disk", "Disk quota exceeded")
_CERTIFICATE = ("CERTIFICATE_VERIFY_FAILED", "SSLError", "SSLCertVerificationError", "invalid path: ")
_UNREACHABLE = (
    "NewConnectionError",
    "Failed to establish a new connection",
    "Temporary failure in name resolution",
    "Name or service not known",
    "getaddrinfo failed",
    "nodename nor servname",
    "Network is unreachable",
    "ConnectTimeoutError",
    "ReadTimeoutError",
    "Read timed out",
    "ProxyError",
    "Cannot connect to proxy",
    "Connection refused",
    "RemoteDisconnected",
    "ConnectionResetError",
    "Connection aborted",
)


def explain(lines: Sequence[str], folder: Path, log: Path) -> str:
    """The sentence for a failed ``pip install``.

    Parameters
    ----------
    lines
        Everything it said.
    folder
        The environment that was to be filled.
    log
        Where its output is kept.
    """
    text = "\n".join(lines)
    if any(sign in text for sign in _DISK_FULL):
        return f"The disk is full: {folder} or the folder for temporary files has no room left. Make room, then run this command again."
    if any(sign in text for sign in _CERTIFICATE):
        return (
            "The package index showed a certificate that this machine does not trust. "
            "Behind a company's proxy, point PIP_CERT to its certificate file, then run this command again."
        )
    if any(sign in text for sign in _UNREACHABLE):
        return (
            "The package index cannot be reached. Check the network (behind a proxy set HTTPS_PROXY, "
            "with a mirror set PIP_INDEX_URL), then run this command again."
        )
    if "No matching distribution found" in text:
        return (
            "The package index has no ready-made package for this Python and this machine. "
            f"Use a 64-bit Python 3.11 to 3.13, then run this command again:\n{last_lines(lines, 3)}"
        )
    return f"The packages could not be installed; run this command again. If it fails again, the reason stands in {log}:\n{last_lines(lines)}"
