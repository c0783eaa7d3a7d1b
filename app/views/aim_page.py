"""Aim: both live pictures with what is taken for the spot and what is not, and the settings that decide it."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QHideEvent, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QButtonGroup, QComboBox, QHBoxLayout, QLineEdit, QProgressBar, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from app.controllers.aim_snapshot import AimJob
from app.services import Services
from app.views import format as fmt
from app.views.aim_picture import AimPicture
from app.views.aim_words import as_filed_words, exposed_words, learned_words, pair_words, used_words
from app.views.material_words import material_reasons, material_title
from app.views.page import Page
from app.views.parts import button, column, give_role, label, make_primary, row, scrolled, seam
from app.views.size_histogram import SizeHistogram
from app.views.spot_advice import look_words

if TYPE_CHECKING:
    from scanner_core.acquisition.live_look import LiveLook

_WIDTH = 330
STEPS_DEG = (0.2, 1.0, 5.0)


class AimPage(Page):
    """Fills the window."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._aim = services.aiming
        self._look: LiveLook | None = None
        self._materials: tuple[object, ...] | None = None
        self.step_deg = STEPS_DEG[1]
        self.pictures = {"left": AimPicture(self.tr("Camera left")), "right": AimPicture(self.tr("Camera right"))}
        for side, picture in self.pictures.items():
            picture.pointed.connect(partial(self._point, side))
            picture.jogged.connect(self._jog)
        pictures = column(*self.pictures.values(), spacing=1)
        pictures.setContentsMargins(0, 0, 0, 0)
        self._side = scrolled(self._inspector())
        self._side.setFixedWidth(_WIDTH)
        beside = QVBoxLayout()
        beside.setSpacing(0)
        beside.addWidget(self._side, 1)
        beside.addWidget(seam())
        beside.addWidget(self._foot())
        box = QHBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(0)
        box.addLayout(pictures, 1)
        box.addWidget(seam(upright=True))
        box.addLayout(beside)
        self._aim.changed.connect(self._show_if_seen)
        self._show()

    # -------------------------------------------------------------------------------- parts
    def _inspector(self) -> QWidget:
        inside = QWidget()
        box = QVBoxLayout(inside)
        box.setContentsMargins(16, 13, 16, 10)
        box.setSpacing(8)
        box.addWidget(label(self.tr("Aim"), "title"))
        self.live = button(self.tr("Live: light the laser"), "primary", self._toggle)
        self.live.setToolTip(self.tr("The spot is lit while this page is shown, and goes dark on Esc or when nobody touches anything for a while"))
        self._state = label("", "muted", wrap=True)
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress of learning"))
        box.addWidget(self.live)
        box.addWidget(self._state)
        box.addWidget(self._bar)
        box.addWidget(seam())
        self.material = QComboBox()
        self.material.setAccessibleName(self.tr("Material"))
        self.material.setMinimumHeight(30)
        self.material.activated.connect(self._choose)
        self._used = label("", "muted", wrap=True)
        self._exposed = label("", "bad", wrap=True)
        self.expose = button(self.tr("Automatic exposure"), "", self._aim.expose)
        self.expose.setToolTip(self.tr("Finds exposure and gain for the object: the beam visits some places of it"))
        self.keep = button(self.tr("Keep as…"), "link", self._name_it)
        self.keep.setToolTip(self.tr("Keep what is set now as a material of your own"))
        self.name = QLineEdit()
        self.name.setPlaceholderText(self.tr("Name of the material"))
        self.name.setAccessibleName(self.tr("Name of the material"))
        self.name.setMaxLength(60)
        self.name.returnPressed.connect(self._keep)
        self.name.hide()
        box.addLayout(row(label(self.tr("Material"), "section"), 1, self.keep))
        box.addWidget(self.material)
        box.addWidget(self._used)
        box.addWidget(self.expose)
        box.addWidget(self.name)
        box.addWidget(self._exposed)
        box.addWidget(seam())
        self.learn = button(self.tr("Learn"), "", self._aim.learn)
        self.learn.setToolTip(self.tr("Two seconds of live pictures while the beam moves a little: sizes of spots that both cameras agree on"))
        box.addLayout(row(label(self.tr("Size of a spot, pixels"), "section"), 1, self.learn))
        self.histogram = SizeHistogram()
        self.histogram.limited.connect(self._aim.limit)
        self._learned = label("", "faint", wrap=True)
        box.addWidget(self.histogram)
        box.addWidget(self._learned)
        box.addWidget(seam())
        box.addLayout(self._hand())
        box.addStretch(1)
        return inside

    def _hand(self) -> QVBoxLayout:
        """By hand: beam and table, for those who would rather press buttons."""
        words = {
            ("x_deg", 1): (self.tr("Beam left"), "←"),
            ("x_deg", -1): (self.tr("Beam right"), "→"),
            ("y_deg", 1): (self.tr("Beam up"), "↑"),
            ("y_deg", -1): (self.tr("Beam down"), "↓"),
            ("table_deg", 1): (self.tr("Table counter-clockwise"), "↺"),
            ("table_deg", -1): (self.tr("Table clockwise"), "↻"),
        }
        self.arrows: dict[tuple[str, int], QPushButton] = {}
        for (axis, sign), (name, sign_text) in words.items():
            made = button(sign_text, "", partial(self._jog, axis, float(sign)))
            made.setAccessibleName(name)
            made.setToolTip(name)
            made.setMinimumWidth(30)
            made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            made.setStyleSheet("padding: 6px 0;")
            self.arrows[axis, sign] = made
        steps = []
        group = QButtonGroup(self)
        for step in STEPS_DEG:
            n = fmt.decimal(step, 0 if step >= 1 else 1)
            made = button(f"{n}°", "choice", partial(self._step, step))
            made.setCheckable(True)
            made.setChecked(step == self.step_deg)
            made.setAccessibleName(self.tr("Steps of {n} degrees").format(n=n))
            group.addButton(made)
            steps.append(made)
        head = row(label(self.tr("By hand"), "section"), 1, *steps, spacing=4)
        return column(head, row(*self.arrows.values(), spacing=4), spacing=8)

    def _foot(self) -> QWidget:
        foot = QWidget()
        self._pair = label("", wrap=True)
        self._pair.setMinimumHeight(36)
        self.next = button(self.tr("Go on to the scan"), "", lambda: self.wanted.emit("scan"))
        box = column(self._pair, self.next, spacing=8)
        box.setContentsMargins(16, 10, 16, 14)
        foot.setLayout(box)
        foot.setFixedWidth(_WIDTH)
        return foot

    # -------------------------------------------------------------------------------- for the window
    def entered(self) -> None:
        self._show()

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        super().showEvent(event)
        self._aim.show(True)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        self._aim.show(False)
        super().hideEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        self._aim.touch()
        super().keyPressEvent(event)

    def tick(self) -> None:
        """For the pump: the newest look, and the time that runs out."""
        if not self.isVisible():
            return
        self._aim.tick()
        sizes = self._aim.sizes
        self.histogram.add([sizes.popleft() for _ in range(len(sizes))])
        seen = self._aim.looks.take()
        if seen is None or not self.services.rig.snapshot.connected:
            return
        self._look = seen
        config = self.services.rig.snapshot.config
        for side, picture in self.pictures.items():
            miss, advice = look_words(seen.looks[side].seen, config) if self._aim.snapshot.live else ("", "")
            picture.show_look(side, seen, miss, advice)
        self._show_pair()

    # -------------------------------------------------------------------------------- showing
    def _show_if_seen(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        snapshot, rig = self._aim.snapshot, self.services.rig.snapshot
        recorded = rig.config is not None and "replay" in (rig.config.left.driver, rig.config.right.driver)
        for picture in self.pictures.values():
            picture.wait_for_measurement(recorded)
            if not rig.connected:
                picture.clear()
        self.live.setText(self.tr("Laser off") if snapshot.live else self.tr("Live: light the laser"))
        self.live.setEnabled(snapshot.live or self._aim.possible)
        self._show_state()
        learning = snapshot.job is AimJob.LEARN
        self._bar.setVisible(learning)
        self._bar.setValue(round(1000 * (snapshot.fraction or 0.0)))
        if learning and snapshot.fraction is None:
            self.histogram.clear()
        free = snapshot.live and snapshot.job is AimJob.NONE
        self.expose.setEnabled(free)
        self.learn.setEnabled(free)
        for made in self.arrows.values():
            made.setEnabled(self._aim.possible)
        self._show_materials()
        self._used.setText(used_words(snapshot))
        for shown, words in ((self._exposed, exposed_words(snapshot)), (self._learned, learned_words(snapshot))):
            shown.setText(words)
            shown.setVisible(bool(words))
        if snapshot.settings is not None:
            self.histogram.show_limits(snapshot.settings.spot.min_area_px, snapshot.settings.spot.max_area_px)
        self._show_pair()

    def _show_state(self) -> None:
        snapshot = self._aim.snapshot
        if snapshot.live and snapshot.left_s is not None:
            words = self.tr("Laser on. It goes dark on Esc, when this page is left, or in {seconds} s if nothing is touched.")
            self._state.setText(words.format(seconds=int(snapshot.left_s)))
        elif not self._aim.possible:
            self._state.setText(self.tr("The rig is not free; the Rig page says why."))
        else:
            self._state.setText(self.tr("The laser is off. Goggles on, nobody looks into the beam: then light it."))

    def _show_pair(self) -> None:
        role, words = pair_words(self._aim.snapshot, self._look)
        give_role(self._pair, role)
        self._pair.setText(words)
        make_primary(self.next, self._aim.snapshot.live)
        make_primary(self.live, not self._aim.snapshot.live)

    def _show_materials(self) -> None:
        snapshot = self._aim.snapshot
        if self._materials != snapshot.materials:
            self._materials = snapshot.materials
            self.material.clear()
            self.material.addItem(as_filed_words())
            for material in snapshot.materials:
                self.material.addItem(material_title(material))
                self.material.setItemData(self.material.count() - 1, material_reasons(material), Qt.ItemDataRole.ToolTipRole)
        used = snapshot.material
        self.material.setCurrentIndex(0 if used is None else 1 + snapshot.materials.index(used))
        self.material.setToolTip("" if used is None else material_reasons(used))
        for part in (self.material, self.keep):
            part.setEnabled(snapshot.settings is not None and self._aim.possible)

    # -------------------------------------------------------------------------------- what a person does
    def _toggle(self) -> None:
        if self._aim.snapshot.live:
            self._aim.end()
        else:
            self._aim.start()
            self.pictures["left"].setFocus()

    def _point(self, side: str, x_px: float, y_px: float) -> None:
        self._aim.point(side, (x_px, y_px))

    def _jog(self, axis: str, steps: float) -> None:
        self._aim.jog(**{axis: steps * self.step_deg})

    def _step(self, step_deg: float) -> None:
        self.step_deg = step_deg
        self._aim.touch()

    def _choose(self, index: int) -> None:
        self._aim.choose(None if index == 0 else self._aim.snapshot.materials[index - 1])

    def _name_it(self) -> None:
        self._aim.touch()
        self.name.show()
        self.name.setFocus()

    def _keep(self) -> None:
        if self.name.text().strip():
            self._aim.keep(self.name.text())
            self.name.clear()
            self.name.hide()
