"""Numbers as a technician reads them."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from datetime import date, datetime
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QDate, QLocale

from scanner_core import wall_clock

NARROW = "\u202f"
NO_VALUE = "–"
MINUS = "\u2212"
_DECIMAL = re.compile(r"[-+]?\d+\.\d+")


def count(number: int) -> str:
    """71 204"""
    return f"{number:,}".replace(",", NARROW)


def left_time(seconds: float | None) -> str:
    """1:05, 12:40, 1:02:09; a dash while there is no estimate."""
    if seconds is None:
        return NO_VALUE
    whole = max(0, round(seconds))
    hours, rest = divmod(whole, 3600)
    minutes, left = divmod(rest, 60)
    return f"{hours}:{minutes:02d}:{left:02d}" if hours else f"{minutes}:{left:02d}"


def decimal(number: float, places: int, *, signed: bool = False) -> str:
    """2.50, −0.25 (2,50 where that is the custom); `signed` with a plus; what rounds to nothing has no sign."""
    digits = f"{abs(number):.{places}f}"
    sign = "" if not digits.strip("0.") else MINUS if number < 0 else "+" if signed else ""
    return sign + digits.replace(".", QLocale().decimalPoint())


def own_mark(fields: Mapping[str, object]) -> dict[str, object]:
    """Fields of a sentence of the core, its numbers with the person's decimal mark; what is no number stays."""
    mark = QLocale().decimalPoint()
    return {name: str(value).replace(".", mark) if _DECIMAL.fullmatch(str(value)) else value for name, value in fields.items()}


def micrometres(length_um: float | None) -> str:
    """24, 7.3; a dash when nothing is known."""
    if length_um is None:
        return NO_VALUE
    return f"{length_um:.0f}" if length_um >= 9.95 else decimal(length_um, 1)


def percent(share: float | None) -> str:
    return NO_VALUE if share is None else f"{100 * share:.0f}"


def short_path(path: str) -> str:
    """A path in the person's own folder begins with ``~``."""
    home = str(Path.home())
    return "~" + path[len(home) :] if path.startswith(home + os.sep) else path


def day(iso: str) -> str:
    """A date of a file in the person's own way; what is no date is shown as it is."""
    moment = _date(iso)
    return iso if moment is None else QLocale().toString(QDate(moment.year, moment.month, moment.day), "d MMM yyyy")


def age(iso: str, today: date | None = None) -> str:
    """today, 1 day, 12 days."""
    moment = _date(iso)
    if moment is None:
        return iso
    days = ((today or wall_clock.today()) - moment).days
    if days <= 0:
        return QCoreApplication.translate("format", "today")
    return QCoreApplication.translate("format", "1 day old") if days == 1 else QCoreApplication.translate("format", "{n} days old").format(n=days)


def ago(iso: str, now: datetime | None = None) -> str:
    """just now, 5 minutes ago, 3 hours ago, yesterday, 12 days ago, then the date."""
    try:
        moment = datetime.fromisoformat(iso).astimezone()
    except ValueError:
        return iso
    now = now or wall_clock.now()
    minutes, days = int((now - moment).total_seconds() // 60), (now.date() - moment.date()).days
    if minutes < 1:
        return QCoreApplication.translate("format", "just now")
    if minutes < 60:
        one, more = QCoreApplication.translate("format", "1 minute ago"), QCoreApplication.translate("format", "{n} minutes ago")
        return one if minutes == 1 else more.format(n=minutes)
    if days == 0:
        one, more = QCoreApplication.translate("format", "1 hour ago"), QCoreApplication.translate("format", "{n} hours ago")
        return one if minutes < 120 else more.format(n=minutes // 60)
    if days == 1:
        return QCoreApplication.translate("format", "yesterday")
    return QCoreApplication.translate("format", "{n} days ago").format(n=days) if days < 31 else day(iso)


def _date(iso: str) -> date | None:
    try:
        return datetime.fromisoformat(iso).date()
    except ValueError:
        return None
