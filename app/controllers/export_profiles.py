"""The export profiles: those of the program, a person's own, and which one is chosen for which type of order."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from app.controllers.preferences import Preferences
from scanner_core.delivery.own_profiles import parsed_profiles, profile_texts
from scanner_core.delivery.profile import BUILT_IN, Profile, default_profile, find_profile, free_name

SETTING = "export_profiles"


class ExportProfiles(QObject):
    """`changed` when a profile, or the choice, is another; what is changed can be undone like every setting."""

    changed = Signal()

    def __init__(self, preferences: Preferences, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._preferences = preferences
        preferences.changed.connect(self._heard)

    @property
    def own(self) -> tuple[Profile, ...]:
        return parsed_profiles(self._preferences.settings.export_profiles)

    @property
    def every(self) -> tuple[Profile, ...]:
        """Those of the program first."""
        return (*BUILT_IN, *self.own)

    def is_own(self, profile: Profile) -> bool:
        return profile not in BUILT_IN

    def chosen(self, kind: str) -> Profile:
        """For a type of order: the one that was chosen last for it, else the program's."""
        name = self._choices().get(_family(kind), "")
        found = find_profile(name, self.own) if name else None
        return found if found is not None and found.name == name else default_profile(kind)

    def choose(self, kind: str, name: str) -> None:
        """Take the profile of that name from now on for orders of this type."""
        choices = self._choices() | {_family(kind): name}
        self._preferences.settings.export_choice = [f"{family}={chosen}" for family, chosen in choices.items()]
        self._preferences.keep()
        self.changed.emit()

    def copy(self, kind: str, profile: Profile) -> Profile:
        """A person's own profile like this one, chosen at once."""
        made = replace(profile, name=free_name(profile.name, {known.name for known in self.every}))
        self._put((*self.own, made))
        self.choose(kind, made.name)
        return made

    def change(self, kind: str, before: Profile, after: Profile) -> None:
        """A person's own profile becomes another; a name that is taken gets a number."""
        if after.name != before.name:
            after = replace(after, name=free_name(after.name, {known.name for known in self.every} - {before.name}))
        self._put(tuple(after if known == before else known for known in self.own))
        if after.name != before.name:
            self.choose(kind, after.name)

    def remove(self, profile: Profile) -> None:
        self._put(tuple(known for known in self.own if known != profile))

    # -------------------------------------------------------------------------------- inside
    def _put(self, profiles: tuple[Profile, ...]) -> None:
        self._preferences.edit(SETTING, profile_texts(profiles))

    def _choices(self) -> dict[str, str]:
        pairs = (entry.partition("=") for entry in self._preferences.settings.export_choice)
        return {family: name for family, _, name in pairs if name}

    def _heard(self, name: str) -> None:
        if name == SETTING:
            self.changed.emit()


def _family(kind: str) -> str:
    """Before and after are one type."""
    return kind.partition("-")[0]
