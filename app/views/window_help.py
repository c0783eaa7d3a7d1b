"""What helps in the window: the panel at the place, all keys, the tour, and what this program is."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QPushButton, QWidget

from app.background import Background
from app.views.about_dialog import AboutDialog
from app.views.help_panel import HelpPanel
from app.views.page import Page
from app.views.pages import ASIDE, FOOT, PAGES
from app.views.rail import Rail
from app.views.shortcuts_dialog import ShortcutsDialog, key_lines
from app.views.tour_card import TourCard, TourStep


class WindowHelp(QObject):
    """Lies over `content`; each part is made when it is first asked for."""

    def __init__(self, content: QWidget, stack: QWidget, rail: Rail, pages: dict[str, Page], background: Background) -> None:
        super().__init__(content)
        self._content, self._stack, self._rail, self._pages, self._background = content, stack, rail, pages, background
        self._page_id = PAGES[0].id
        self.panel: HelpPanel | None = None
        self.tour: TourCard | None = None
        self.shortcuts: ShortcutsDialog | None = None
        self.about: AboutDialog | None = None
        for part in (content, stack):
            part.installEventFilter(self)

    def show_page(self, page_id: str) -> None:
        """The window shows this page from now on."""
        self._page_id = page_id
        if self.panel is not None:
            info = next(info for info in (*PAGES, *FOOT, *ASIDE) if info.id == page_id)
            self.panel.show_page(page_id, QCoreApplication.translate("pages", info.title))
            self._place_panel()
        if self.tour is not None and not self.tour.isHidden():
            self.tour.move_to_target()

    def toggle_panel(self) -> None:
        """F1: help at the place, or away with it."""
        if self.panel is None:
            self.panel = HelpPanel(self._content)
            self.show_page(self._page_id)
        self.panel.setVisible(self.panel.isHidden())
        self._place_panel()

    def dismiss(self) -> None:
        """What lies over the window goes away."""
        if self.panel is not None:
            self.panel.hide()
        if self.tour is not None:
            self.tour.end()

    def start_tour(self) -> None:
        """From its first step."""
        if self.tour is not None:
            self.tour.end()
            self.tour.deleteLater()
        self.tour = TourCard(self._content, self._steps())

    def show_shortcuts(self) -> None:
        if self.shortcuts is None:
            self.shortcuts = ShortcutsDialog(key_lines(self._pages), self._content.window())
        _bring_up(self.shortcuts)

    def show_about(self) -> None:
        if self.about is None:
            self.about = AboutDialog(self._background, self._content.window())
        _bring_up(self.about)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self._place_panel()
        return False

    # -------------------------------------------------------------------------------- inside
    def _place_panel(self) -> None:
        """Over the 3D view at its right end, beside the page; over the right end of a page that fills the window."""
        if self.panel is None or self.panel.isHidden():
            return
        page = self._stack.mapTo(self._content, self._stack.rect().topLeft())
        fills = self._stack.width() > self._content.width() // 2
        right = self._content.width() if fills else page.x()
        self.panel.setGeometry(right - self.panel.width(), page.y(), self.panel.width(), self._stack.height())
        self.panel.raise_()

    def _steps(self) -> tuple[TourStep, ...]:
        return (
            TourStep(
                self.tr("The work goes from the top down"), self.tr("Every order passes these steps. Ctrl and a number opens each."), self._rail_head
            ),
            TourStep(
                self.tr("One button is next"),
                self.tr("The filled button is what to do now. A demo order stands here already: press it and watch."),
                self._primary,
            ),
            TourStep(
                self.tr("Stop, from everywhere"),
                self.tr("Esc does the same on every page. It is filled with red while the laser is on."),
                lambda: self._rail.stop_button,
            ),
            TourStep(
                self.tr("Scanning runs by itself"),
                self.tr("Points and surface grow before you. Pause is safe: the laser goes dark and nothing is lost."),
                lambda: self._rail.step_of("scan"),
            ),
            TourStep(
                self.tr("Checked, then delivered"),
                self.tr("At the end stands a file for the next machine, with its checks in plain words."),
                lambda: self._rail.step_of("deliver"),
            ),
            TourStep(
                self.tr("Help is at hand"),
                self.tr("F1 explains the page and the control in hand, ? lists all keys, and Ctrl+Z takes back what you did."),
                lambda: None,
            ),
        )

    def _rail_head(self) -> QWidget | None:
        return self._rail.step_of(PAGES[0].id)

    def _primary(self) -> QWidget | None:
        """The filled button of the page that is shown."""
        buttons = self._pages[self._page_id].findChildren(QPushButton)
        return next((made for made in buttons if made.property("role") == "primary" and made.isVisible()), None)


def _bring_up(dialog: AboutDialog | ShortcutsDialog) -> None:
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
