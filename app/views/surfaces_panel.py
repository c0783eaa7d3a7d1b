"""The two surfaces as they were read."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtWidgets import QWidget

from app.controllers.surface_reading import Role, cleared, loaded_of
from app.services import Services
from app.views.parts import button, column, label, seam
from app.views.surface_card import SurfaceCard


class SurfacesPanel(QWidget):
    """One of the three panels beside the picture; calls `choose(role)` for another file."""

    def __init__(self, services: Services, choose: Callable[[Role], None]) -> None:
        super().__init__()
        self._comparing = services.comparing
        titles: dict[Role, str] = {"before": self.tr("Before"), "after": self.tr("After")}
        self.cards = {
            role: SurfaceCard(
                title,
                replace=partial(choose, role),
                remove=partial(self._remove, role),
                unit=partial(self._comparing.reading.overrule_unit, role),
            )
            for role, title in titles.items()
        }
        self._swap = button(self.tr("Swap before and after"), "link", self._exchange)
        self._hint = label(self.tr("Nothing of a file is repaired: what is noticed about it is said here."), "faint", wrap=True)
        box = column(self.cards["before"], seam(), self.cards["after"], seam(), self._swap, self._hint, 1, spacing=10)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_choice()

    def show_choice(self) -> None:
        choice, reading = self._comparing.draft.choice, self._comparing.reading.reading
        for role, card in self.cards.items():
            card.show_surface(loaded_of(choice, role), reading.get(role))
        self._swap.setVisible(choice.before is not None or choice.after is not None)

    def _remove(self, role: Role) -> None:
        draft = self._comparing.draft
        draft.edit("remove", **(cleared(draft.choice, role) | {role: None}))

    def _exchange(self) -> None:
        draft = self._comparing.draft
        gone = cleared(draft.choice, "before") | cleared(draft.choice, "after")
        draft.edit("swap", **(gone | {"before": draft.choice.after, "after": draft.choice.before}))
