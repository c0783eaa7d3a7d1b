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


def numbers_of(array: Any) -> NDArray[np.int64]:
    """The same of an array of whole numbers."""
    numbers: NDArray[np.int64] = _to_numpy(array)
    return numbers


def places_of(array: Any) -> NDArray[np.float64]:
    """A copy of an array of coordinates."""
    return np.asarray(_to_numpy(array), np.float64)


def reals_of(array: Any) -> NDArray[np.float32]:
    """A view of a VTK array of single precision."""
    reals: NDArray[np.float32] = _to_numpy(array)
    return reals
