"""Profiles survive being kept; what is damaged takes no other with it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scanner_core.delivery.own_profiles import KEY, own_profiles, parsed_profiles, profile_texts, wanted_profile
from scanner_core.delivery.profile import BUILT_IN, FORMATS, LONGEST_NAME, UNITS, Pose, Profile, default_profile, find_profile, free_name
from scanner_core.errors import DeliveryError

NAMES = st.text(min_size=1, max_size=LONGEST_NAME).filter(lambda text: bool(text.strip()))
PROFILES = st.builds(
    Profile,
    NAMES,
    st.sampled_from(FORMATS),
    st.sampled_from(UNITS),
    NAMES,
    st.text(max_size=30),
    st.sampled_from(Pose),
    st.booleans(),
    st.booleans(),
    st.booleans(),
)


@given(st.lists(PROFILES, max_size=4, unique_by=lambda profile: profile.name))
def test_profiles_are_kept(profiles: list[Profile]) -> None:
    assert parsed_profiles(profile_texts(profiles)) == tuple(profiles)


@pytest.mark.parametrize("text", ["", "{}", "[]", '{"name": 3}', '{"name": "a", "format": ".exe"}', '{"name": "a", "points": 1}', '{"name": " "}'])
def test_what_is_damaged_is_left_out(text: str) -> None:
    good = Profile("mine")
    assert parsed_profiles([text, *profile_texts([good, good])]) == (good,)


def test_own_profiles_come_from_the_settings(tmp_path: Path) -> None:
    settings = tmp_path / "settings.json"
    assert own_profiles(settings) == ()
    settings.write_text(json.dumps({KEY: profile_texts([Profile("mine", unit="inch")])}))
    assert own_profiles(settings) == (Profile("mine", unit="inch"),)
    settings.write_text("not json")
    assert own_profiles(settings) == ()


def test_a_profile_is_found_by_the_beginning_of_its_name() -> None:
    assert find_profile("ear") is BUILT_IN[0]
    assert find_profile("") is None
    own = (Profile("Ear lab Rossi"),)
    assert find_profile("ear", own) is None  # two begin so
    assert find_profile("ear lab rossi", own) is own[0]
    with pytest.raises(DeliveryError, match="'Archive"):
        wanted_profile("nothing", ())


def test_every_type_has_a_default() -> None:
    assert default_profile("ear").pose is Pose.CANAL_UP
    assert default_profile("arch-before").pose is Pose.OCCLUSAL
    assert default_profile("other").format == ".ply"
    assert free_name("a", {"a", "a (2)"}) == "a (3)"
