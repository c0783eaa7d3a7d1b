"""What the cameras showed, as picture files."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from scanner_core.files import replaced_when_whole, storage_error


def picture_name(*words: str) -> str:
    """A file name of these words, for any system."""
    return re.sub(r"[^A-Za-z0-9._-]+", "-", "-".join(words)).strip("-.")[:120] + ".png"


def write_picture(path: Path, image: NDArray[np.uint8], *, force: bool = False) -> None:
    """An image (h, w) uint8 as PNG; its folder is made.

    Raises
    ------
    StorageError
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        raise storage_error(path.parent, fault) from fault
    _, content = cv2.imencode(".png", image)
    with replaced_when_whole(path, force) as partial:
        partial.write_bytes(content.tobytes())
