"""Recordings of another task among those of one: how many are told apart."""

from collections.abc import Mapping, Sequence

import numpy as np
from transferring.known import Known
from transferring.trying import segmentation_of, taught_by_truth

from keyphase.transfer.proposing import propose, usual_cost_of

SHARE = 0.1
GOAL = 0.9


def outliers(tasks: Mapping[str, Sequence[Known]]) -> bool:
    """Print how many strangers are marked, and how many of the task are marked in error."""
    print("\nwith a tenth from other tasks:")
    good = True
    for name, known in tasks.items():
        strangers = _strangers(name, tasks, max(round(SHARE * len(known)), 4))
        for count in (1, 3):
            marked = _marked(known, count, strangers)
            line = f"  {name}, {count} taught: {marked[0]} of {marked[1]} strangers marked"
            print(f"{line}, {marked[2]} of {marked[3]} of its own marked", flush=True)
            good &= not marked[1] or marked[0] / marked[1] >= GOAL
    return good


def _strangers(name: str, tasks: Mapping[str, Sequence[Known]], count: int) -> list[Known]:
    others = [known for task, some in tasks.items() if task != name for known in some]
    rng = np.random.default_rng(1)
    drawn = rng.choice(len(others), min(count, len(others)), replace=False)
    return [others[i] for i in drawn]


def _marked(
    known: Sequence[Known], count: int, strangers: Sequence[Known]
) -> tuple[int, int, int, int]:
    rng = np.random.default_rng(2)
    apart = total = wrong = own = 0
    for _ in range(5):
        teachers = rng.choice(len(known), count, replace=False).tolist()
        taught = [taught_by_truth(known[i]) for i in teachers]
        usual = usual_cost_of(taught)

        def is_marked(one: Known, taught=taught, usual=usual) -> bool:
            found = propose(taught, one.demonstration, segmentation_of(one), usual_cost=usual)
            return found.outlier

        apart += sum(map(is_marked, strangers))
        total += len(strangers)
        mine = [one for i, one in enumerate(known) if i not in teachers]
        wrong += sum(map(is_marked, mine))
        own += len(mine)
    return apart, total, wrong, own
