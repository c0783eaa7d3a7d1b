"""Choosing files and folders without taking the window away: Qt's own dialog, never modal, so that the stop button works.

The system's dialogs run in a loop of their own where neither Esc nor the stop button reaches the laser.  What a dialog
would ask in a box of its own (replace this file? there is no such file) is said inside it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QWidget


class FileDialog(QFileDialog):
    """Calls `chosen(path)` and is gone; one at a time for a window."""

    def __init__(self, parent: QWidget, title: str, start: str, kinds: str, mode: QFileDialog.FileMode) -> None:
        super().__init__(parent.window(), title, start, kinds)
        for other in parent.window().findChildren(FileDialog):
            if other is not self:
                other.close()
        self.setOption(QFileDialog.Option.DontUseNativeDialog)
        self.setOption(QFileDialog.Option.DontConfirmOverwrite)
        self.setOption(QFileDialog.Option.ReadOnly)  # no renaming and deleting in here, and no boxes that ask about it
        self.setFileMode(mode)
        self.setWindowModality(Qt.WindowModality.NonModal)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(760, 480)
        self._to_replace: str | None = None

    def accept(self) -> None:
        """As far as the choice is one."""
        chosen = self.selectedFiles()
        path = Path(chosen[0]) if chosen else None
        if path is None:
            return
        if self.acceptMode() is QFileDialog.AcceptMode.AcceptSave:
            if path.is_file() and self._to_replace != str(path):
                self._to_replace = str(path)
                self.setLabelText(QFileDialog.DialogLabel.FileName, self.tr("This file exists:"))
                self.setLabelText(QFileDialog.DialogLabel.Accept, self.tr("Replace it"))
                return
        elif not path.exists():
            self.setLabelText(QFileDialog.DialogLabel.FileName, self.tr("There is no such file:"))
            return
        super().accept()


def choose_file(parent: QWidget, title: str, start: str, kinds: str, chosen: Callable[[Path], None]) -> None:
    """A file that exists."""
    _show(FileDialog(parent, title, start, kinds, QFileDialog.FileMode.ExistingFile), chosen)


def choose_folder(parent: QWidget, title: str, start: str, chosen: Callable[[Path], None]) -> None:
    """A folder that exists."""
    dialog = FileDialog(parent, title, start, "", QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly)
    _show(dialog, chosen)


def choose_new_file(parent: QWidget, title: str, start: str, kinds: str, suffix: str, chosen: Callable[[Path], None]) -> None:
    """Where to write; a file that is there may be replaced when it is chosen, the dialog has asked."""
    dialog = FileDialog(parent, title, str(Path(start).parent), kinds, QFileDialog.FileMode.AnyFile)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setDefaultSuffix(suffix)
    dialog.selectFile(Path(start).name)
    _show(dialog, chosen)


def _show(dialog: FileDialog, chosen: Callable[[Path], None]) -> None:
    dialog.fileSelected.connect(lambda path: chosen(Path(path)))
    dialog.show()
