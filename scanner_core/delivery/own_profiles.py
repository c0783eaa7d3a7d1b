"""A person's own profiles, as the settings keep them: one JSON text each, so that one that is damaged takes no other with it."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from scanner_core.delivery.profile import BUILT_IN, Profile, find_profile
from scanner_core.errors import DeliveryError
from scanner_core.user_folders import settings_file

KEY = "export_profiles"
"""Of the settings."""


def parsed_profiles(texts: Iterable[object]) -> tuple[Profile, ...]:
    """What can be read of the texts; a name that is there already is left out."""
    found: list[Profile] = []
    names = {profile.name for profile in BUILT_IN}
    for text in texts:
        try:
            profile = Profile.from_dict(json.loads(str(text)))
        except (TypeError, ValueError):
            continue
        if profile.name not in names:
            names.add(profile.name)
            found.append(profile)
    return tuple(found)


def profile_texts(profiles: Iterable[Profile]) -> list[str]:
    """The reverse of :func:`parsed_profiles`."""
    return [json.dumps(profile.as_dict(), ensure_ascii=False) for profile in profiles]


def own_profiles(settings: Path | None = None) -> tuple[Profile, ...]:
    """Those of the window's settings; none when there are none or they cannot be read."""
    try:
        stored = json.loads((settings or settings_file()).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return ()
    texts = stored.get(KEY) if isinstance(stored, dict) else None
    return parsed_profiles(texts) if isinstance(texts, list) else ()


def wanted_profile(name: str, own: tuple[Profile, ...]) -> Profile:
    """The profile of that name; E-DLV-02 when there is none."""
    profile = find_profile(name, own)
    if profile is None:
        raise DeliveryError("E-DLV-02", name=name, known=", ".join(f"'{known.name}'" for known in (*own, *BUILT_IN)))
    return profile
