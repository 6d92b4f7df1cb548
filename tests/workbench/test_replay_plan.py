"""The plan of a labeled recording, made executable."""

import threading
from types import SimpleNamespace
from typing import cast

from keyphase.files.shipped import shipped
from keyphase.labeling.edits import edit_from_json
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.readers import read
from keyphase.segmentation import Segmenter
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.replaying.margin import MarginRun, ReplayMargin
from keyphase.workbench.replaying.plan import plan_of
from keyphase.workbench.replaying.settings import ReplaySettings
from keyphase.workbench.tasks import Tasks
from keyphase.workbench.telling import Telling

DEMONSTRATION = read(shipped("data") / "setup1.npz")


def labeled(*edits: dict[str, object]) -> Labeling:
    segmenter = Segmenter(DEMONSTRATION)
    segmentation = segmenter.segment(Parameters())
    applied = dict(enumerate(map(edit_from_json, edits)))
    return label(segmentation, applied, segmenter.segment_between)


def test_kept_segments_become_skills_in_the_order_of_the_plan() -> None:
    labeling = labeled({"kind": "drop_idle"})
    kept = [index for index, segment in enumerate(labeling.segments) if segment.kept]
    skills = [one for one in plan_of(labeling).planned if one.segment is not None]
    assert [one.segment for one in skills] == kept
    assert [one.entry for one in skills] == list(range(len(kept)))


def test_a_repeated_segment_runs_again_after_a_connecting_move() -> None:
    first = labeled({"kind": "drop_idle"}).plan[0].time_s
    repeated = labeled({"kind": "drop_idle"}, {"kind": "plan", "order": [first, first]})
    planned = plan_of(repeated).planned
    assert [one.segment for one in planned[:3]] == [0, None, 0]
    assert planned[1].skill.connecting


def test_without_contact_ends_every_skill_ends_at_its_pose() -> None:
    planned = plan_of(labeled({"kind": "drop_idle"}), "configuration").planned
    assert all(isinstance(one.skill.end_condition, ConfigurationEnd) for one in planned)


def test_a_margin_of_an_empty_plan_says_so() -> None:
    emptied = SimpleNamespace(plan=(), segments=())
    told: list[str | None] = []
    telling = Telling(lambda _level, text: told.append(text), Tasks(lambda _task: None))
    over = threading.Event()

    def show(run: MarginRun) -> None:
        if run.over:
            told.append(run.outcome)
            over.set()

    opened = SimpleNamespace(
        recording=SimpleNamespace(name="setup1"), demonstration=DEMONSTRATION, labeling=emptied
    )
    margin = ReplayMargin(telling, show)
    margin.run(cast(DeskState, opened), ReplaySettings())
    assert over.wait(20.0)
    assert "at least one segment" in str(told[0])
    margin.stop()
