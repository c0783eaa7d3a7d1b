"""The table of actions: a new entry is a new line.  Menus, tool bars and shortcuts are made from it."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication, QObject, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMenuBar

from app.theme import icon
from app.translation import QT_TRANSLATE_NOOP


@dataclass(frozen=True, slots=True)
class ActionInfo:
    """One action.

    Attributes
    ----------
    id : stable name
    menu : in which menu it stands; an empty text keeps it out of the menus
    text : English, translated when the action is made
    shortcut : portable text, or empty
    icon : a drawing of ``resources/icons``, or empty
    slot : name of the method of the window that it calls
    checkable : it is switched on and off
    """

    id: str
    menu: str
    text: str
    shortcut: str
    icon: str
    slot: str
    checkable: bool = False


CASE = QT_TRANSLATE_NOOP("actions", "&Case")
EDIT = QT_TRANSLATE_NOOP("actions", "&Edit")
SCAN = QT_TRANSLATE_NOOP("actions", "&Scan")
VIEW = QT_TRANSLATE_NOOP("actions", "&View")
HELP = QT_TRANSLATE_NOOP("actions", "&Help")

ACTIONS: tuple[ActionInfo, ...] = (
    ActionInfo("new_case", CASE, QT_TRANSLATE_NOOP("actions", "&New case"), "Ctrl+N", "home", "new_case"),
    ActionInfo("open_case", CASE, QT_TRANSLATE_NOOP("actions", "&Open case…"), "Ctrl+O", "folder", "choose_case"),
    ActionInfo("deliver", CASE, QT_TRANSLATE_NOOP("actions", "&Deliver…"), "Ctrl+E", "export", "show_deliver"),
    ActionInfo("quit", CASE, QT_TRANSLATE_NOOP("actions", "&Quit"), "Ctrl+Q", "", "close"),
    ActionInfo("undo", EDIT, QT_TRANSLATE_NOOP("actions", "&Undo"), "Ctrl+Z", "undo", "undo"),
    ActionInfo("redo", EDIT, QT_TRANSLATE_NOOP("actions", "&Redo"), "Ctrl+Shift+Z", "redo", "redo"),
    ActionInfo("start_scan", SCAN, QT_TRANSLATE_NOOP("actions", "&Start scan"), "F5", "play", "start_scan"),
    ActionInfo("pause_scan", SCAN, QT_TRANSLATE_NOOP("actions", "&Pause or resume"), "F6", "pause", "pause_scan"),
    ActionInfo("laser_off", SCAN, QT_TRANSLATE_NOOP("actions", "Stop and &laser off"), "Esc", "laser", "laser_off"),
    ActionInfo("coverage", SCAN, QT_TRANSLATE_NOOP("actions", "&Complete"), "F8", "", "show_coverage"),
    ActionInfo("fill", SCAN, QT_TRANSLATE_NOOP("actions", "&Fill now"), "Shift+F5", "", "fill"),
    ActionInfo("another_mount", SCAN, QT_TRANSLATE_NOOP("actions", "Another &mount"), "F9", "", "show_mounts"),
    ActionInfo("scan_mount", SCAN, QT_TRANSLATE_NOOP("actions", "Scan &this mount"), "Shift+F9", "", "scan_mount"),
    ActionInfo("set_up_rig", SCAN, QT_TRANSLATE_NOOP("actions", "Set up a ri&g…"), "", "rig", "set_up_rig"),
    ActionInfo("reconstruct", SCAN, QT_TRANSLATE_NOOP("actions", "&Reconstruct"), "F7", "reconstruct", "start_reconstruction"),
    ActionInfo("fit", VIEW, QT_TRANSLATE_NOOP("actions", "&Fit"), "F", "fit", "view_fit"),
    ActionInfo("front", VIEW, QT_TRANSLATE_NOOP("actions", "F&ront"), "1", "front", "view_front"),
    ActionInfo("top", VIEW, QT_TRANSLATE_NOOP("actions", "&Top"), "7", "top", "view_top"),
    ActionInfo("show_points", VIEW, QT_TRANSLATE_NOOP("actions", "&Points"), "P", "points", "show_points", checkable=True),
    ActionInfo("show_surface", VIEW, QT_TRANSLATE_NOOP("actions", "&Surface"), "L", "surface", "show_surface", checkable=True),
    ActionInfo("show_edges", VIEW, QT_TRANSLATE_NOOP("actions", "&Edges"), "E", "edges", "show_edges", checkable=True),
    ActionInfo("show_uncertainty", VIEW, QT_TRANSLATE_NOOP("actions", "&Uncertainty"), "U", "uncertainty", "show_uncertainty", checkable=True),
    ActionInfo("help", HELP, QT_TRANSLATE_NOOP("actions", "&Help on this page"), "F1", "", "show_help"),
    ActionInfo("shortcuts", HELP, QT_TRANSLATE_NOOP("actions", "&Keyboard shortcuts"), "?", "", "show_shortcuts"),
    ActionInfo("tour", HELP, QT_TRANSLATE_NOOP("actions", "&Tour"), "", "", "show_tour"),
    ActionInfo("next_colour", VIEW, QT_TRANSLATE_NOOP("actions", "&Colours: the next"), "K", "", "next_colour"),
    ActionInfo("support", HELP, QT_TRANSLATE_NOOP("actions", "&Support bundle…"), "", "", "show_support"),
    ActionInfo("about", HELP, QT_TRANSLATE_NOOP("actions", "&About Impronta"), "", "mark", "show_about"),
)


def make_actions(window: QObject) -> dict[str, QAction]:
    """An action for every line, connected to the window's method."""
    made: dict[str, QAction] = {}
    for info in ACTIONS:
        action = QAction(QCoreApplication.translate("actions", info.text), window)
        if info.icon:
            action.setIcon(icon(info.icon))
        if info.shortcut:
            action.setShortcut(QKeySequence(info.shortcut))
            plain = action.text().replace("&", "").rstrip("…")
            action.setToolTip(f"{plain}  ({QKeySequence(info.shortcut).toString(QKeySequence.SequenceFormat.NativeText)})")
        action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        action.setCheckable(info.checkable)
        slot = getattr(window, info.slot)
        (action.toggled if info.checkable else action.triggered).connect(slot)
        made[info.id] = action
    return made


def fill_menus(bar: QMenuBar, actions: dict[str, QAction]) -> None:
    """The menus in the order in which the table names them first."""
    for name in dict.fromkeys(info.menu for info in ACTIONS if info.menu):
        menu = bar.addMenu(QCoreApplication.translate("actions", name))
        menu.addActions([actions[info.id] for info in ACTIONS if info.menu == name])
