"""The clocks: simulated time jumps, and waits for whoever paces it."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from scanner_core.clock import ScaledClock, SteppedClock, make_clock


def _in_threads(*actions: Callable[[], None]) -> None:
    threads = [threading.Thread(target=action) for action in actions]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(10)
    assert not any(thread.is_alive() for thread in threads)


def test_a_lone_sleeper_does_not_wait() -> None:
    clock = SteppedClock()
    clock.sleep(3600)
    assert clock.now_s() == 3600


def test_pacers_meet_at_every_tick() -> None:
    clock = SteppedClock()
    seen: dict[str, list[float]] = {"left": [], "right": []}
    pacers = {name: clock.pace() for name in seen}

    def follow(name: str) -> Callable[[], None]:
        def run() -> None:
            for tick in range(1, 101):
                pacers[name].wait_until(tick / 60)
                seen[name].append(clock.now_s())
            pacers[name].close()

        return run

    _in_threads(follow("left"), follow("right"))
    assert seen["left"] == seen["right"] == [tick / 60 for tick in range(1, 101)]


def test_time_stands_still_for_a_pacer_that_is_busy() -> None:
    clock = SteppedClock()
    pacer = clock.pace()
    woken = threading.Event()
    sleeper = threading.Thread(target=lambda: (clock.wait_until(5.0), woken.set()))
    sleeper.start()
    assert not woken.wait(0.15)
    assert clock.now_s() == 0.0
    pacer.close()
    assert woken.wait(5)
    sleeper.join()
    assert clock.now_s() == 5.0


def test_a_stop_ends_the_wait() -> None:
    clock = SteppedClock()
    holder = clock.pace()
    stop = threading.Event()
    answers: list[bool] = []
    waiter = threading.Thread(target=lambda: answers.append(clock.wait_until(1.0, stop)))
    waiter.start()
    stop.set()
    waiter.join(5)
    assert answers == [False]
    holder.close()


@pytest.mark.parametrize("clock", [SteppedClock(), ScaledClock()])
def test_a_pacer_that_is_closed_lets_go_who_waits(clock: SteppedClock | ScaledClock) -> None:
    holder, pacer = clock.pace(), clock.pace()
    answers: list[bool] = []
    waiter = threading.Thread(target=lambda: answers.append(pacer.wait_until(clock.now_s() + 3600.0)))
    waiter.start()
    pacer.close()
    waiter.join(5)
    assert answers == [False]
    assert not pacer.wait_until(clock.now_s() - 1.0)
    holder.close()


def test_a_scaled_clock_runs_faster() -> None:
    clock = ScaledClock(1000.0)
    begin_s = clock.now_s()
    clock.sleep(1.0)
    assert clock.now_s() - begin_s >= 1.0
    assert clock.wait_until(clock.now_s() - 1.0)


@pytest.mark.parametrize(("speed", "kind"), [("max", SteppedClock), (1.0, ScaledClock), (5.0, ScaledClock)])
def test_the_speed_chooses_the_clock(speed: float, kind: type) -> None:
    assert isinstance(make_clock(speed), kind)
