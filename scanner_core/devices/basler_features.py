"""The features of a Basler camera by name, read rather than assumed: families of cameras differ in what they have and call it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from scanner_core.devices.basler_sdk import BaslerSdk


class BaslerFeatures:
    """Nodes of an open camera; the first of several names that it has is taken.

    The SDK's exceptions pass through; :func:`~scanner_core.devices.basler_sdk.as_device_error` is for the caller.
    """

    def __init__(self, sdk: BaslerSdk, device: Any) -> None:
        self._genicam, self._nodes = sdk.genicam, device.GetNodeMap()

    def number(self, *names: str) -> float | None:
        """Its value, None where it has none of them."""
        node = self._first(self._genicam.IsReadable, names)
        return None if node is None else float(node.GetValue())

    def text(self, *names: str) -> str | None:
        """The value of a string or a choice."""
        node = self._first(self._genicam.IsReadable, names)
        return None if node is None else str(node.GetValue())

    def unit(self, *names: str) -> str | None:
        """The unit of a number."""
        node = self._first(self._genicam.IsReadable, names)
        return None if node is None else str(node.GetUnit())

    def choices(self, name: str) -> tuple[str, ...]:
        """What a choice can be set to now."""
        node = self._first(self._genicam.IsReadable, (name,))
        return () if node is None else tuple(node.GetSettableValues())

    def has(self, *names: str) -> bool:
        """Whether one of them can be set or executed now."""
        return self._first(self._genicam.IsWritable, names) is not None

    def maximum(self, *names: str) -> float | None:
        """The largest value that a number takes now."""
        node = self._first(self._genicam.IsReadable, names)
        return None if node is None else float(node.GetMax())

    def put(self, value: object, *names: str) -> bool:
        """Set it as it is; False where it has none of them or the value is none of its choices."""
        node = self._first(self._genicam.IsWritable, names)
        if node is None:
            return False
        try:
            node.SetValue(value)
        except (self._genicam.InvalidArgumentException, self._genicam.OutOfRangeException, self._genicam.AccessException):
            return False
        return True

    def put_nearest(self, value: float, *names: str) -> float | None:
        """Set a number to the nearest that it takes, whole steps below; returns what it reads then, None where it cannot be set."""
        node = self._first(self._genicam.IsWritable, names)
        if node is None:
            return None
        low, high = node.GetMin(), node.GetMax()
        value = min(max(value, low), high)
        if isinstance(low, int):
            value = low + math.floor((value - low) / node.GetInc()) * node.GetInc()
        node.SetValue(value)
        return float(node.GetValue())

    def execute(self, *names: str) -> bool:
        """Execute a command; False where it has none of them."""
        node = self._first(self._genicam.IsWritable, names)
        if node is None:
            return False
        node.Execute()
        return True

    def _first(self, usable: Callable[[Any], bool], names: tuple[str, ...]) -> Any:
        for name in names:
            node = self._nodes.GetNode(name)
            if node is not None and usable(node):
                return node
        return None
