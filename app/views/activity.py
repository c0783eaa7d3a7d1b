"""What the program is doing, in a word or two."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from app.services import Services


def activity_words(services: Services) -> str:
    """What a person waits for; empty when that is nothing."""
    translate = QCoreApplication.translate
    if services.acquisition.paused:
        return translate("activity", "Scan paused")
    if services.acquisition.running:
        return translate("activity", "Scanning")
    if services.verification.running:
        return translate("activity", "Measuring the reference sphere")
    if services.coverage.running:
        return translate("activity", "Looking for what is missing")
    if services.mounts.running:
        return translate("activity", "Bringing the mounts together")
    if services.comparing.answers.running:
        return translate("activity", "Comparing")
    if services.rig.snapshot.calibrating is not None:
        return translate("activity", "Calibrating")
    if services.assistant.holds_devices:
        return translate("activity", "Setting up a rig")
    if services.case.computing:
        return translate("activity", "Computing the points anew…")
    if services.case.opening:
        return translate("activity", "Opening the case…")
    return ""


def is_busy(services: Services) -> bool:
    """Something goes on that would end with the window."""
    lit = services.aiming.snapshot.live or services.rig.snapshot.aiming
    writing = services.delivery.writing or services.pair_tray.splitting or services.recovery.busy
    return bool(activity_words(services)) or services.reconstruction.running or writing or lit
