"""What the colours of the 3D view mean, and the choice of what they are to mean."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QActionGroup, QColor, QLinearGradient, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QMenu, QStyle, QStyleOptionToolButton, QToolButton

from app.colouring import Colouring
from app.theme import is_dark, look
from app.views.colour_maps import MAPS
from app.views.point_colour import PointColour, SurfaceColour
from app.views.surface_colours import SUPPORTED, UNCERTAINTY, UNSUPPORTED

if TYPE_CHECKING:
    from app.views.scene_view import SceneView


@dataclass(frozen=True, slots=True)
class Meaning:
    """A name with its unit, and what the ends of a colour map mean: stops of a map, single colours of a cycle, or two colours."""

    name: str
    low: str
    high: str
    stops: tuple[str, ...] = ()
    cycle: bool = False


class Legend(QToolButton):
    """A colour map with the meaning of its ends, which opens the choice; hidden while nothing is coloured."""

    def __init__(self) -> None:
        super().__init__()
        self._colouring: Colouring | None = None
        self._meaning: Meaning | None = None
        self.setFixedSize(186, 42)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._menu = QMenu(self)
        self._menu.aboutToShow.connect(self._fill)
        self.hide()

    @property
    def meaning(self) -> Meaning | None:
        """What it tells now, or None while it is hidden."""
        return self._meaning

    def offer(self, colouring: Colouring) -> None:
        """Let a person choose."""
        self._colouring = colouring
        self.setMenu(self._menu)
        self.setToolTip(self.tr("What the colours mean; click to choose  (K: the next one)"))

    def show_scene(self, scene: SceneView | None, *, points: bool) -> None:
        """What the 3D view is coloured by; `points` are to be seen in it."""
        meaning = None if scene is None else self._of(scene, points)
        if meaning == self._meaning and self.isHidden() == (meaning is None):
            self.update()  # maybe in another palette
            return
        self._meaning = meaning
        self.setVisible(meaning is not None)
        if meaning is not None:
            told = self.tr("Colours: {name}, {low} to {high}")
            self.setAccessibleName(told.format(name=meaning.name, low=meaning.low, high=meaning.high))
        self.update()

    # -------------------------------------------------------------------------------- what it means
    def _of(self, scene: SceneView, points: bool) -> Meaning | None:
        if scene.aside is not None:
            return self._uncertainty(scene.aside.range_um)
        if points and len(scene.cloud):
            return self._of_points(scene)
        if scene.mesh.surface is None or scene.mesh.surface.growing:
            return None
        if scene.mesh.range_um is not None:
            return self._uncertainty(scene.mesh.range_um)
        return Meaning(self.surface_words(SurfaceColour.SUPPORT), self.tr("measured"), self.tr("filled in"), (SUPPORTED, UNSUPPORTED), cycle=True)

    def _of_points(self, scene: SceneView) -> Meaning:
        cloud = scene.cloud
        low, high = cloud.shown_range()
        stops = MAPS[cloud.by].stops(is_dark())
        name = self.point_words(cloud.by)
        if cloud.by is PointColour.VIEW:
            if not cloud.views:
                return Meaning(name, self.tr("not known"), "")
            return Meaning(name, "1", str(cloud.views), stops[: max(1, min(cloud.views, len(stops)))], cycle=True)
        if high <= low:
            return Meaning(name, self.tr("not known"), "")
        if cloud.by is PointColour.AGE:
            ago = self.tr("{n} s ago").format(n=f"{high - low:.0f}") if cloud.in_seconds else self.tr("oldest")
            return Meaning(name, ago, self.tr("newest"), stops)
        if cloud.by is PointColour.RESIDUAL:
            return Meaning(name, "0", self.tr("{n} and more").format(n=f"{high:.0f}"), stops)
        digits = 1 if cloud.by is PointColour.HEIGHT or high < 20 else 0
        return Meaning(name, f"{low:.{digits}f}", f"{high:.{digits}f}", stops)

    def _uncertainty(self, range_um: tuple[float, float] | None) -> Meaning | None:
        if range_um is None:
            return None
        low, high = range_um
        return Meaning(self.surface_words(SurfaceColour.UNCERTAINTY), f"{low:.0f}", f"{high:.0f}", UNCERTAINTY)

    def point_words(self, by: PointColour) -> str:
        """Name and unit."""
        return {
            PointColour.HEIGHT: self.tr("Height, mm"),
            PointColour.VIEW: self.tr("View"),
            PointColour.RESIDUAL: self.tr("Epipolar residual, σ"),
            PointColour.UNCERTAINTY: self.tr("Standard uncertainty, µm"),
            PointColour.DENSITY: self.tr("Density, points/mm²"),
            PointColour.AGE: self.tr("Age"),
        }[by]

    def surface_words(self, by: SurfaceColour) -> str:
        """Name and unit."""
        return {
            SurfaceColour.SUPPORT: self.tr("Support by points"),
            SurfaceColour.UNCERTAINTY: self.tr("Standard uncertainty, µm"),
        }[by]

    # -------------------------------------------------------------------------------- choosing
    def _fill(self) -> None:
        assert self._colouring is not None
        self._menu.clear()
        of_points = (self.tr("Points by"), [(by, self.point_words(by)) for by in PointColour], self._colouring.points)
        of_surface = (self.tr("Surface by"), [(by, self.surface_words(by)) for by in SurfaceColour], self._colouring.surface)
        for title, choices, chosen in (of_points, of_surface):
            self._menu.addAction(title).setEnabled(False)
            group = QActionGroup(self._menu)
            for by, words in choices:
                action = self._menu.addAction(words)
                action.setCheckable(True)
                action.setChecked(by is chosen)
                action.triggered.connect(lambda _=False, by=by: self._choose(by))
                group.addAction(action)
            self._menu.addSeparator()

    def _choose(self, by: PointColour | SurfaceColour) -> None:
        assert self._colouring is not None
        self._colouring.choose(by)

    # -------------------------------------------------------------------------------- painting
    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        with QPainter(self) as painter:
            option = QStyleOptionToolButton()
            self.initStyleOption(option)
            option.text, option.features = "", QStyleOptionToolButton.ToolButtonFeature.None_
            option.iconSize = QSize(0, 0)
            self.style().drawComplexControl(QStyle.ComplexControl.CC_ToolButton, option, painter, self)
            if self._meaning is not None:
                self._paint(painter, self._meaning)

    def _paint(self, painter: QPainter, meaning: Meaning) -> None:
        font = painter.font()
        font.setPixelSize(11)
        painter.setFont(font)
        inside = self.rect().adjusted(7, 3, -7, -3)
        chevron = 12 if self._colouring is not None else 0
        painter.setPen(QColor(look.text))
        name = painter.fontMetrics().elidedText(meaning.name, Qt.TextElideMode.ElideRight, inside.width() - chevron)
        painter.drawText(inside, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop, name)
        if chevron:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(QColor(look.muted), 1.4))
            x, y = inside.right() - 5, inside.top() + 6
            painter.drawPolyline([QPoint(x - 3, y), QPoint(x, y + 3), QPoint(x + 3, y)])
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        bar = QRect(inside.left(), inside.top() + 16, inside.width(), 6)
        _fill(painter, bar, meaning)
        painter.setPen(QColor(look.muted))
        painter.drawText(inside, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignBottom, meaning.low)
        painter.drawText(inside, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom, meaning.high)


def _fill(painter: QPainter, bar: QRect, meaning: Meaning) -> None:
    stops = meaning.stops
    if meaning.cycle:
        for i, stop in enumerate(stops):
            left, right = (bar.left() + round(bar.width() * j / len(stops)) for j in (i, i + 1))
            painter.fillRect(QRect(left, bar.top(), right - left - 1, bar.height()), QColor(stop))
    elif stops:
        fill = QLinearGradient(bar.left(), 0, bar.right(), 0)
        for i, stop in enumerate(stops):
            fill.setColorAt(i / (len(stops) - 1), QColor(stop))
        painter.fillRect(bar, fill)
