"""What stands in a picture: counts that a blank or noisy picture does not pass."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget


def pixels_of(widget: QWidget) -> NDArray[np.uint8]:
    """The widget as (H, W, 3) bytes, drawn by Qt (a 3D view is not in it)."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    width, height = image.width(), image.height()
    return np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())[:, : 3 * width].reshape(height, width, 3).copy()


def coloured(picture: NDArray[np.uint8], spread: int = 40) -> NDArray[np.bool_]:
    """(H, W): where the picture is neither grey nor dark, as the theme's background is."""
    values = picture.astype(np.int16)
    return values.max(axis=2) - values.min(axis=2) > spread


def near(picture: NDArray[np.uint8], colour: str, tolerance: int = 24) -> NDArray[np.bool_]:
    """(H, W): where the picture has a colour of the theme."""
    wanted = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    return (np.abs(picture.astype(np.int16) - wanted) <= tolerance).all(axis=2)
