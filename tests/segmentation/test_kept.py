"""What stays while a line is dragged is not made again."""

import numpy as np

from keyphase.segmentation.kept import Kept, places_before


def test_a_value_is_made_again_only_where_what_it_depends_on_changes():
    made: list[tuple[int, float]] = []

    def make(candidate: int, on: list[float]) -> tuple[int, float]:
        made.append((candidate, on[0]))
        return made[-1]

    kept = Kept(3, 1, make)
    kept.of(np.array([0, 2]), np.array([[1.0], [1.0]]))
    values = kept.of(np.array([0, 1, 2]), np.array([[1.0], [1.0], [5.0]])).tolist()
    assert values == [(0, 1.0), (1, 1.0), (2, 5.0)]
    assert made == [(0, 1.0), (2, 1.0), (1, 1.0), (2, 5.0)]


def test_what_was_there_before_is_found_by_all_that_names_it():
    before = np.array([[0.0, 1.0, 2.0], [1.0, 2.0, 3.0]])
    now = np.array([[0.0, 1.0, 1.5, 2.0], [1.0, 1.5, 2.0, 3.0]])
    assert places_before(before, now).tolist() == [0, -1, -1, 2]
    assert places_before(np.zeros((2, 0)), now).tolist() == [-1] * 4
