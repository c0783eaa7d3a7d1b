"""The two surfaces as they were read."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtWidgets import QWidget

from app.controllers.surface_reading import Role, cleared, loaded_of
from app.services import Services
from app.views import format as fmt
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
                stop=partial(self._comparing.reading.cancel, role),
            )
            for role, title in titles.items()
        }
        self._swap = button(self.tr("Swap before and after"), "link", self._exchange)
        self._hint = label(self.tr("Nothing of a file is repaired: what is noticed about it is said here."), "faint", wrap=True)
        box = column(self.cards["before"], seam(), self.cards["after"], seam(), self._swap, self._hint, spacing=10)
        self._kept_title = label(self.tr("Kept in the open case"), "section")
        self.kept = label("", "muted", wrap=True, selectable=True)
        box.addWidget(self._kept_title)
        box.addWidget(self.kept)
        box.addStretch(1)
        box.setContentsMargins(0, 0, 0, 0)
        self.setLayout(box)
        self.show_choice()
        self.show_kept()

    def show_choice(self) -> None:
        choice, reading = self._comparing.draft.choice, self._comparing.reading.reading
        for role, card in self.cards.items():
            card.show_surface(loaded_of(choice, role), reading.get(role))
        self._swap.setVisible(choice.before is not None or choice.after is not None)

    def show_kept(self) -> None:
        """The comparisons that the open case keeps, newest first."""
        lines = []
        for line in self._comparing.keeping.lines:
            verdict = self.tr("reliable") if line.reliable else self.tr("not reliable")
            words = self.tr("{day}: with {before}, {n} areas, {verdict}") if line.areas != 1 else self.tr("{day}: with {before}, 1 area, {verdict}")
            text = words.format(day=fmt.day(line.created), before=line.before, n=line.areas, verdict=verdict)
            lines.append(text if line.of_this_mesh else self.tr("{line}; of an earlier surface").format(line=text))
        self.kept.setText("\n".join(lines))
        for part in (self._kept_title, self.kept):
            part.setVisible(bool(lines))

    def _remove(self, role: Role) -> None:
        draft = self._comparing.draft
        draft.edit("remove", **(cleared(draft.choice, role) | {role: None}))

    def _exchange(self) -> None:
        draft = self._comparing.draft
        gone = cleared(draft.choice, "before", same_object=True) | cleared(draft.choice, "after", same_object=True)
        draft.edit("swap", **(gone | {"before": draft.choice.after, "after": draft.choice.before}))
