"""Faults that nobody caught, of any thread, end as one sentence in the banner, with the traceback behind "Details"."""

from __future__ import annotations

import logging
import sys
import threading
import traceback
from collections.abc import Callable, Mapping
from types import TracebackType

from PySide6.QtCore import QCoreApplication

from app.draft import SIDES
from app.views.format import own_mark
from scanner_core.acquisition.finding import Finding
from scanner_core.errors import ImprontaError
from scanner_core.remedies import REMEDIES
from scanner_core.sentences import SENTENCES

_log = logging.getLogger("impronta")

Tell = Callable[[BaseException], None]


def install_hooks(tell: Tell) -> None:
    """Both exception hooks call `tell`, which may be called from any thread."""

    def main_hook(kind: type[BaseException], fault: BaseException, trace: TracebackType | None) -> None:
        if issubclass(kind, KeyboardInterrupt):
            sys.__excepthook__(kind, fault, trace)
            return
        _log.error("unexpected fault", exc_info=(kind, fault, trace))
        tell(fault)

    def thread_hook(hook: threading.ExceptHookArgs) -> None:
        if hook.exc_value is None:
            return
        _log.error("unexpected fault in thread %s", hook.thread.name if hook.thread else "?", exc_info=hook.exc_value)
        tell(hook.exc_value)

    sys.excepthook = main_hook
    threading.excepthook = thread_hook


def remove_hooks() -> None:
    """Back to Python's own."""
    sys.excepthook = sys.__excepthook__
    threading.excepthook = threading.__excepthook__


def sentence_of(fault: BaseException) -> tuple[str, str]:
    """What happened and what to do, in the window's language."""
    if isinstance(fault, ImprontaError):
        sentence = SENTENCES[fault.code]
        translate, fields = QCoreApplication.translate, _spoken(fault.fields)
        return translate("sentences", sentence.what).format(**fields), translate("sentences", sentence.do).format(**fields)
    return (
        QCoreApplication.translate("faults", "Something unexpected happened ({kind}).").format(kind=type(fault).__name__),
        QCoreApplication.translate("faults", "What was measured is kept; the details help us to mend it."),
    )


def unmeasured_words(fault: BaseException) -> str:
    """What happened and what to do while devices are looked for or checked, in the window's language."""
    what, do = sentence_of(fault)
    if isinstance(fault, ImprontaError) and fault.code in REMEDIES:
        do = QCoreApplication.translate("remedies", REMEDIES[fault.code]).format(**_spoken(fault.fields))
    return f"{what} {do}"


def finding_words(finding: Finding) -> str:
    """What a scan noticed and what to do, in the window's language."""
    sentence = SENTENCES[finding.code]
    translate = QCoreApplication.translate
    return f"{translate('sentences', sentence.what)} {translate('sentences', sentence.do)}".format(**_spoken(finding.fields))


def _spoken(fields: Mapping[str, object]) -> dict[str, object]:
    """The fields of a sentence; which camera or ear it is in the window's language, numbers with its decimal mark."""
    translate = QCoreApplication.translate
    cameras: dict[object, str] = {"left": translate("faults", "left"), "right": translate("faults", "right")}
    ears: dict[object, str] = {side: translate("draft", SIDES[side]).lower() for side in ("left", "right")}
    words = {"camera": cameras, "other": cameras, "late": cameras, "side": ears}
    return {name: words[name].get(value, value) if name in words else value for name, value in own_mark(fields).items()}


def details_of(fault: BaseException) -> str:
    """For whoever mends it: code, details, traceback."""
    parts = []
    if isinstance(fault, ImprontaError):
        parts.append(f"{fault.code}  {type(fault).__name__}")
        if fault.details:
            parts.append(fault.details)
    trace = "".join(traceback.format_exception(fault)).strip()
    if fault.__traceback__ is not None or not parts:
        parts.append(trace)
    return "\n\n".join(parts)
