"""All keys at a glance: made from the table of actions, the pages, and what the pages add; searched by typing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QApplication, QDialog, QHeaderView, QLineEdit, QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

from app.actions import ACTIONS
from app.translation import QT_TRANSLATE_NOOP
from app.views.pages import ASIDE, FOOT, PAGES
from app.views.parts import button, label, row

Line = tuple[str, str, str]
"""Group, what it does, keys; in the window's language."""

_OTHER = (
    (QT_TRANSLATE_NOOP("keys", "Everywhere"), QT_TRANSLATE_NOOP("keys", "Next and previous control"), "Tab, Shift+Tab"),
    (QT_TRANSLATE_NOOP("keys", "Everywhere"), QT_TRANSLATE_NOOP("keys", "Press the control in hand"), "Space"),
    (QT_TRANSLATE_NOOP("keys", "Everywhere"), QT_TRANSLATE_NOOP("keys", "Open the menus"), "Alt"),
    (QT_TRANSLATE_NOOP("keys", "Pick three points"), QT_TRANSLATE_NOOP("keys", "Turn the view"), "Left, Right, Up, Down"),
    (QT_TRANSLATE_NOOP("keys", "Pick three points"), QT_TRANSLATE_NOOP("keys", "Nearer and farther"), "+, -"),
    (QT_TRANSLATE_NOOP("keys", "Pick three points"), QT_TRANSLATE_NOOP("keys", "Pick the point in the middle"), "Space"),
    (QT_TRANSLATE_NOOP("keys", "Compare"), QT_TRANSLATE_NOOP("keys", "The other surface, for a moment"), "Space"),
)
"""What is no action and no shortcut of Qt's."""


def key_lines(pages: Mapping[str, QWidget]) -> list[Line]:
    """Every key of the window, group by group."""
    return list(dict.fromkeys((group, text, keys) for group, text, keys in _lines(pages) if text and keys))


def _lines(pages: Mapping[str, QWidget]) -> Iterator[Line]:
    translate = QCoreApplication.translate
    infos = {info.id: info for info in (*PAGES, *FOOT, *ASIDE)}
    for group, text, keys in (line for line in _OTHER if line[0] == "Everywhere"):
        yield translate("keys", group), translate("keys", text), ", ".join(_native(key) for key in keys.split(", "))
    for number, page in enumerate(PAGES, start=1):
        yield translate("keys", "Pages"), translate("pages", page.title), _native(f"Ctrl+{number}")
    for page in FOOT:
        yield translate("keys", "Pages"), translate("pages", page.title), _native("Ctrl+,")
    for info in ACTIONS:
        yield _plain(translate("actions", info.menu)), _plain(translate("actions", info.text)), _native(info.shortcut)
    for name, made in pages.items():
        title = translate("pages", infos[name].title)
        for shortcut in made.findChildren(QShortcut):
            yield title, shortcut.whatsThis(), _native(shortcut.key().toString())
    for group, text, keys in (line for line in _OTHER if line[0] != "Everywhere"):
        yield translate("pages", group), translate("keys", text), ", ".join(_native(key) for key in keys.split(", "))


def _native(keys: str) -> str:
    return QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText)


def _plain(text: str) -> str:
    return text.replace("&", "").rstrip("…")


class ShortcutsDialog(QDialog):
    """Beside the window, never modal, so that the stop button works."""

    def __init__(self, lines: Sequence[Line], parent: QWidget) -> None:
        super().__init__(parent)
        self._lines = lines
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.setWindowModality(Qt.WindowModality.NonModal)
        self.resize(620, 640)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search: a word, or a key"))
        self.search.setAccessibleName(self.tr("Search the shortcuts"))
        self.search.setClearButtonEnabled(True)
        self.search.setMinimumHeight(32)
        self.search.textChanged.connect(self.filter)
        self.tree = QTreeWidget()
        self.tree.setAccessibleName(self.tr("Keyboard shortcuts"))
        self.tree.setHeaderLabels([self.tr("What it does"), self.tr("Keys")])
        self.tree.setRootIsDecorated(False)
        self.tree.setIndentation(14)
        self.tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.tree.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        self.tree.header().setStretchLastSection(False)
        self._items: list[tuple[QTreeWidgetItem, QTreeWidgetItem]] = []
        groups: dict[str, QTreeWidgetItem] = {}
        for group, text, keys in lines:
            if group not in groups:
                groups[group] = QTreeWidgetItem(self.tree, [group, ""])
                font = groups[group].font(0)
                font.setBold(True)
                groups[group].setFont(0, font)
            self._items.append((groups[group], QTreeWidgetItem(groups[group], [text, keys])))
        self.tree.expandAll()
        self._none = label(self.tr("No shortcut fits."), "muted")
        self._none.hide()
        copy = button(self.tr("Copy as text"), "", self._copy)
        close = button(self.tr("Close"), "", self.close)
        box = QVBoxLayout(self)
        box.setContentsMargins(16, 14, 16, 14)
        box.setSpacing(10)
        box.addWidget(self.search)
        box.addWidget(self._none)
        box.addWidget(self.tree, 1)
        box.addLayout(row(1, copy, close))
        self.search.setFocus()

    def filter(self, wanted: str) -> None:
        """Only the lines that hold all words of `wanted`, in what they do, their keys, or their group."""
        words = wanted.casefold().split()
        shown = []
        for group, line in self._items:
            text = f"{group.text(0)} {line.text(0)} {line.text(1)}".casefold()
            line.setHidden(not all(word in text for word in words))
            if not line.isHidden():
                shown.append(id(group))
        for group, _ in self._items:
            group.setHidden(id(group) not in shown)
        self._none.setVisible(not shown)

    @property
    def text(self) -> str:
        """A line each, the keys below one another, at most 80 characters wide."""
        parts: list[str] = []
        for group in dict.fromkeys(line[0] for line in self._lines):
            parts += ["", group]
            parts += [f"  {text:<48.48}  {keys}" for name, text, keys in self._lines if name == group]
        return "\n".join(parts[1:]) + "\n"

    def _copy(self) -> None:
        QApplication.clipboard().setText(self.text)
