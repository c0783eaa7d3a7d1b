"""A choice of what can happen to a lit laser, witnessed; all of it stands in ``tests/long/test_laser_states.py``."""

from __future__ import annotations

import signal
import time

import pytest

from scanner_core.errors import MotionStoppedError
from tests.core.devices.boards import remote_board
from tests.core.devices.laser_states import DARK_WITHIN_S, happen
from tests.core.devices.test_guardian import off_after_s

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGHUP"), reason="signals")


def test_ends_of_the_program_and_of_its_guardian_leave_it_dark() -> None:
    with remote_board() as remote:
        for state, event in (("sweep", "SIGHUP"), ("standing", "os._exit"), ("sweep", "guardian")):
            seen = happen(remote, state, event)
            assert seen.dark_after_s < DARK_WITHIN_S[event], (state, event)
            assert not seen.lit_again, (state, event)


def test_an_owner_that_hangs_is_told_when_it_comes_back() -> None:
    """The process lives and so does its heartbeat; only the thread that lit the laser stands still."""
    with remote_board() as remote, remote.open() as controller:
        controller.laser(True)
        since_s = time.monotonic()
        assert 1.5 < off_after_s(remote, since_s) < DARK_WITHIN_S["hang"]
        with pytest.raises(MotionStoppedError) as caught:
            controller.aim(0.0, 0.0)
        assert caught.value.code == "E-MOT-19"
        assert controller.recover() is True, "nothing moved"
        controller.aim(1.0, 1.0)


def test_stop_from_another_thread_is_dark_at_once_in_a_sweep_and_lights_nothing_afterwards() -> None:
    with remote_board() as remote, remote.open() as controller:
        controller.sweep(60.0, 0.0, 10.0)
        time.sleep(0.3)
        assert remote.witness.laser_log()[-1][1] > 0.0
        since_s = time.monotonic()
        controller.stop()
        assert off_after_s(remote, since_s) < 0.2
        with pytest.raises(MotionStoppedError):
            controller.wait_idle(5.0)
        remote.witness.happen("open_door")
        remote.witness.happen("close_door")
        time.sleep(0.2)
        assert remote.witness.laser_log()[-1][1] == 0.0
