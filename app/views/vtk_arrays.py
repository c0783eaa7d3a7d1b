"""NumPy arrays as VTK arrays and back; VTK's own functions for it carry no types."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util import numpy_support

_to_vtk: Any = numpy_support.numpy_to_vtk
_to_ids: Any = numpy_support.numpy_to_vtkIdTypeArray
_to_numpy: Any = numpy_support.vtk_to_numpy


def shared(array: NDArray[np.generic]) -> Any:
    """A VTK array on the same memory; the NumPy array must outlive it."""
    return _to_vtk(array)


def copied(array: NDArray[np.generic]) -> Any:
    """A VTK array with its own memory."""
    return _to_vtk(np.ascontiguousarray(array), deep=True)


def copied_ids(array: NDArray[np.int64]) -> Any:
    """The same for indices."""
    return _to_ids(np.ascontiguousarray(array), deep=True)


def bytes_of(array: Any) -> NDArray[np.uint8]:
    """A view of a VTK array of bytes."""
    pixels: NDArray[np.uint8] = _to_numpy(array)
    return pixels
