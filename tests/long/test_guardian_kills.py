"""Twenty kills and twenty hangs in a row, each seen by the witness."""

from __future__ import annotations

import signal
import time

import pytest

from tests.core.devices.boards import remote_board
from tests.core.devices.test_guardian import OFF_WITHIN_S, off_after_s, victim

pytestmark = pytest.mark.long


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP])
def test_laser_is_off_in_time_after_every_one(how: signal.Signals) -> None:
    times_s = []
    with remote_board() as remote:
        for _ in range(20):
            with victim(remote) as program:
                since_s = time.monotonic()
                program.send_signal(how)
                times_s.append(off_after_s(remote, since_s))
            time.sleep(1.0)  # until the guardian of this one has released the port
    print(f"{how.name}: median {sorted(times_s)[10]:.3f} s, longest {max(times_s):.3f} s")
    assert max(times_s) < OFF_WITHIN_S
