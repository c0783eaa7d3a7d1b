"""GRBL's numbers in words: alarms with their remedy, and refusals."""

from __future__ import annotations

from dataclasses import dataclass

HOME_AND_RESUME = "home the rig and resume"


@dataclass(frozen=True, slots=True)
class Meaning:
    """What an alarm says, and what a person does about it."""

    text: str
    remedy: str


ALARMS: dict[int, Meaning] = {
    1: Meaning("an axis ran into its limit switch", "free the axis, then home the rig and resume"),
    2: Meaning("a move would have left the travel of an axis", "check the limits in the rig file, then home the rig"),
    3: Meaning("it was reset while it moved, its position is lost", HOME_AND_RESUME),
    4: Meaning("the probe was in the wrong state", HOME_AND_RESUME),
    5: Meaning("the probe found nothing", HOME_AND_RESUME),
    6: Meaning("homing was interrupted by a reset", "home the rig again"),
    7: Meaning("homing was interrupted by the safety door", "close the door and home the rig again"),
    8: Meaning("homing could not free the limit switch", "check the limit switches and $27, or turn homing off with $22=0"),
    9: Meaning("homing found no limit switch", "check the limit switches and $130 to $132"),
    10: Meaning("homing found no second limit switch", "check the limit switches"),
}

LOCKED = Meaning("it is locked until it is homed or unlocked", HOME_AND_RESUME)

REFUSALS: dict[int, str] = {
    1: "a letter was expected",
    2: "a number was not understood",
    3: "no such $ command",
    4: "a value must not be negative",
    5: "homing is not enabled in $22",
    6: "the step pulse is too short",
    7: "its settings were damaged and reset",
    8: "only possible while idle",
    9: "locked by an alarm or while jogging",
    10: "soft limits need homing",
    11: "the line is too long",
    12: "the step rate is too high",
    13: "the safety door is open",
    14: "the line is too long",
    15: "the jog leaves the travel",
    16: "no valid jog command",
    17: "laser mode needs a PWM output",
    20: "a command that it does not know",
    21: "two commands that exclude each other",
    22: "no feed rate was set",
    23: "a whole number was expected",
    24: "two commands want the axes",
    25: "a word was repeated",
    26: "axis words are missing",
    27: "the line number is not valid",
    28: "a value is missing",
    31: "axis words without a motion",
    33: "the target is not valid",
    36: "words without a use, or an axis that it does not have",
}


def alarm_meaning(number: int) -> Meaning:
    return ALARMS.get(number, Meaning("an alarm that GRBL 1.1 does not know", HOME_AND_RESUME))


def refusal_meaning(number: int) -> str:
    return REFUSALS.get(number, "an error that GRBL 1.1 does not know")
