"""Whatever a person does, in whatever order: see `editing_machine` for what must hold."""

import pytest
from editing_machine import Editing
from hypothesis import settings
from hypothesis.stateful import run_state_machine_as_test


@pytest.mark.slow
def test_random_edits_sliders_undo_redo_and_restarts_keep_everything_in_order():
    run_state_machine_as_test(
        Editing,
        settings=settings(
            max_examples=20, stateful_step_count=40, deadline=None, derandomize=True, database=None
        ),
    )
