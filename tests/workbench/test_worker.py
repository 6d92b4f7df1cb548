"""Jobs one at a time, of each kind only the newest; a playhead that knows its recording's ends."""

import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.workbench.playback import AROUND_S, Playhead
from keyphase.workbench.worker import Worker


def _busy(worker: Worker) -> threading.Event:
    """Keep the worker busy until the event is set."""
    begun, go = threading.Event(), threading.Event()

    def wait() -> None:
        begun.set()
        go.wait()

    worker.submit(wait)
    begun.wait()
    return go


def test_of_one_kind_only_the_newest_runs() -> None:
    done: list[int] = []
    worker = Worker(pytest.fail)
    go = _busy(worker)
    for value in range(100):
        worker.submit(lambda value=value: done.append(value), "slider")
    go.set()

    assert worker.wait_until_idle(10)
    assert done == [99]


def test_jobs_without_a_kind_all_run_in_order() -> None:
    done: list[int] = []
    worker = Worker(pytest.fail)
    go = _busy(worker)
    for value in range(100):
        worker.submit(lambda value=value: done.append(value))
    go.set()

    assert worker.wait_until_idle(10)
    assert done == list(range(100))


def test_who_submits_can_wait_for_the_job_also_for_one_that_never_runs() -> None:
    done: list[str] = []
    worker = Worker(pytest.fail)
    go = _busy(worker)
    replaced = worker.submit(lambda: done.append("replaced"), "slider")
    waiting = worker.submit(lambda: done.append("newest"), "slider")
    assert replaced.is_set()
    assert not waiting.is_set()
    go.set()
    assert waiting.wait(10)
    assert done == ["newest"]

    go = _busy(worker)
    forgotten = worker.submit(pytest.fail)
    worker.stop()
    assert forgotten.is_set()
    assert worker.submit(pytest.fail).is_set()
    go.set()


def test_it_is_free_but_for_jobs_of_a_kind_that_nobody_asked_for() -> None:
    worker = Worker(pytest.fail)
    assert worker.is_free()
    go = _busy(worker)
    assert not worker.is_free()
    go.set()
    assert worker.wait_until_idle(10)
    looked_at = threading.Event()
    worker.submit(looked_at.wait, "look")
    assert worker.is_free(but_for="look")
    assert not worker.is_free()
    looked_at.set()
    assert worker.wait_until_idle(10)
    assert worker.is_free()


def test_an_error_is_reported_and_the_next_job_runs() -> None:
    errors: list[Exception] = []
    done: list[str] = []
    worker = Worker(errors.append)
    worker.submit(lambda: 1 / 0)  # type: ignore
    worker.submit(lambda: done.append("next"))

    assert worker.wait_until_idle(10)
    assert isinstance(errors[0], ZeroDivisionError)
    assert done == ["next"]


@given(
    st.floats(-1e6, 1e6),
    st.floats(0, 1e3),
    st.floats(0.01, 100) | st.floats(-100, -0.01),
    st.booleans(),
)
def test_the_playhead_never_leaves_the_recording(
    time_s: float, elapsed_s: float, speed: float, loop: bool
) -> None:
    head = Playhead(2.0, 2.0, 9.0).at(time_s).played(True, speed, loop).advanced(elapsed_s)

    assert 2.0 <= head.time_s <= 9.0
    assert head.playing or head.time_s == (9.0 if speed > 0.0 else 2.0)


def test_playing_again_at_the_end_begins_at_the_start() -> None:
    assert Playhead(9.0, 2.0, 9.0).played(True, 1.0, False).time_s == 2.0


def test_backwards_it_runs_to_the_start_and_then_begins_at_the_end() -> None:
    head = Playhead(4.0, 2.0, 9.0).played(True, -2.0, False)

    assert head.advanced(0.5).time_s == 3.0
    assert (head.advanced(5.0).time_s, head.advanced(5.0).playing) == (2.0, False)
    assert head.advanced(5.0).played(True, -2.0, False).time_s == 9.0
    assert head.around(5.0).speed == 2.0


def test_a_paused_playhead_stays() -> None:
    assert Playhead(3.0, 2.0, 9.0).advanced(1.0).time_s == 3.0


def test_looping_goes_on_from_the_start() -> None:
    head = Playhead(8.0, 2.0, 9.0, playing=True, loop=True).advanced(2.0)

    assert head.time_s == 3.0
    assert head.playing


@given(st.floats(2.0, 9.0), st.floats(0.0, 100.0), st.sampled_from([0.1, 1.0, 4.0]))
def test_a_doubt_is_played_with_what_is_around_it_until_another_place_is_sought(
    time_s: float, elapsed_s: float, speed: float
) -> None:
    head = Playhead(2.0, 2.0, 9.0, speed=speed).around(time_s)
    assert head.between_s == (max(time_s - AROUND_S, 2.0), min(time_s + AROUND_S, 9.0))
    later = head.advanced(elapsed_s)
    assert later.playing
    assert head.between_s[0] <= later.time_s <= head.between_s[1]
    assert later.played(True, 0.5, loop=False).between_s == head.between_s
    sought = later.at(3.0)
    assert (sought.playing, sought.between_s) == (False, None)
