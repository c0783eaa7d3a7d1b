"""Measurements in words: for the list, for the picture, and to be copied."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication

from app.views import format as fmt

Array = NDArray[np.float64]


def title(item: Mapping[str, Any]) -> str:
    """What was measured."""
    return {
        "distance": QCoreApplication.translate("measure", "Distance"),
        "section": QCoreApplication.translate("measure", "Section"),
        "canal": QCoreApplication.translate("measure", "Canal length"),
        "volume": QCoreApplication.translate("measure", "Volume"),
    }.get(str(item["kind"]), str(item["kind"]))


def value(item: Mapping[str, Any]) -> str:
    """The number that counts."""
    kind = item["kind"]
    if kind in ("distance", "canal"):
        return QCoreApplication.translate("measure", "{mm} mm").format(mm=fmt.decimal(float(item["length_mm"]), 2))
    if kind == "section":
        area = item["area_mm2"]
        return fmt.NO_VALUE if area is None else QCoreApplication.translate("measure", "{mm2} mm²").format(mm2=fmt.decimal(float(area), 1))
    return QCoreApplication.translate("measure", "{mm3} mm³").format(mm3=f"{float(item['volume_mm3']):.0f}")


def rest(item: Mapping[str, Any]) -> str:
    """What else is known of it."""
    kind = item["kind"]
    if kind == "distance":
        return _uncertain(item["uncertainty_mm"])
    if kind == "section":
        told = QCoreApplication.translate("measure", "perimeter {mm} mm").format(mm=fmt.decimal(float(item["perimeter_mm"]), 2))
        return (
            told
            if item["area_mm2"] is not None
            else QCoreApplication.translate("measure", "perimeter {mm} mm; the section is open").format(
                mm=fmt.decimal(float(item["perimeter_mm"]), 2)
            )
        )
    if kind == "canal":
        return (
            QCoreApplication.translate("measure", "from the tip to where it opens")
            if item["opens"]
            else QCoreApplication.translate("measure", "from end to end")
        )
    surface = f"{float(item['area_mm2']):.0f}"
    off = item["uncertainty_mm3"]
    if off is None:
        return QCoreApplication.translate("measure", "surface {mm2} mm²").format(mm2=surface)
    return QCoreApplication.translate("measure", "at most ±{mm3} mm³; surface {mm2} mm²").format(mm3=f"{float(off):.0f}", mm2=surface)


def line_words(item: Mapping[str, Any]) -> str:
    """All of it in a line."""
    return "\t".join(part for part in (title(item), value(item), rest(item)) if part)


def lines_of(item: Mapping[str, Any]) -> list[Array]:
    """(k, 3) mm each, what is drawn of it."""
    found = {"distance": [item.get("points", [])], "section": item.get("contours", []), "canal": [item.get("line", [])]}.get(str(item["kind"]), [])
    return [np.array(line, np.float64).reshape(-1, 3) for line in found]


def _uncertain(off_mm: float | None) -> str:
    if off_mm is None:
        return QCoreApplication.translate("measure", "its uncertainty is not known")
    return QCoreApplication.translate("measure", "± {um} µm, standard uncertainty of both places").format(um=f"{1000 * off_mm:.0f}")
