"""Several demonstrations, one skill: aligned by their phases, in their middle."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.errors import SkillError
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.skills.exports.skill_file import library_of_text, skill_text
from keyphase.skills.exports.skill_library import library_of
from keyphase.skills.library import skills_of
from keyphase.skills.many import mean_of, skills_of_many


@dataclass(frozen=True)
class Planned:
    start_s: float
    end_s: float
    label: str
    end_condition: EndCondition


def demonstrated(tempo: float, aside_m: float, threshold_N: float = 2.0):
    """Down until a force steps in, then along; slower by `tempo` and `aside_m` away."""
    time = np.arange(0, 1001) / 250.0
    down = np.clip(time / 2.0, 0.0, 1.0)
    along = np.clip((time - 2.0) / 2.0, 0.0, 1.0)
    smooth = [x * x * (3.0 - 2.0 * x) for x in (along, down)]
    position = np.stack([0.2 * smooth[0], 0 * time + aside_m, 0.3 - 0.1 * smooth[1]], axis=1)
    force = np.zeros_like(position)
    force[time >= 2.0, 2] = 5.0
    end = tempo * 2.0
    planned = (
        Planned(0.0, end, "down", ContactEnd((0.0, 0.0, 1.0), threshold_N)),
        Planned(end, 2.0 * end, "along", ConfigurationEnd()),
    )
    return Demonstration("one", tempo * time, position, force_N=force), planned


def test_the_mean_lies_between_and_its_contact_stays_sharp():
    mean = mean_of([demonstrated(0.8, -0.01, 1.0), demonstrated(1.4, 0.03, 3.0)])
    made = mean.demonstration
    assert made.duration_s == pytest.approx(4.4, abs=0.01)
    np.testing.assert_allclose(made.position_m[:, 1], 0.01, atol=1e-9)
    np.testing.assert_allclose(mean.spread_m, 0.02, atol=1e-3)
    assert made.force_N is not None
    before, after = made.force_N[[np.searchsorted(made.time_s, t) for t in (2.15, 2.25)], 2]
    assert (before, after) == (0.0, 5.0)
    assert [segment.label for segment in mean.segments] == ["down", "along"]
    end = mean.segments[0].end_condition
    assert isinstance(end, ContactEnd)
    assert end.threshold_N == 2.0


def test_skills_of_the_mean_are_skills_like_any_other():
    skills = skills_of_many([demonstrated(1.0, 0.0), demonstrated(1.2, 0.02)])
    assert [skill.label for skill in skills if not skill.connecting] == ["down", "along"]
    assert isinstance(skills[0].end_condition, ContactEnd)
    np.testing.assert_allclose(skills[0].end_position_m, (0.0, 0.01, 0.2), atol=1e-3)


def test_each_skill_says_how_far_the_demonstrations_lie_apart_also_in_its_file():
    many = [demonstrated(1.0, 0.0), demonstrated(1.2, 0.04)]
    skills = skills_of_many(many)
    assert skills[0].spread is not None
    assert skills[0].spread.demonstrations == 2
    np.testing.assert_allclose(skills[0].spread.position_m, 0.02, atol=1e-3)
    read = library_of_text(skill_text(library_of(mean_of(many).demonstration, skills)))
    kept = read.skills[0].spread
    assert kept is not None
    np.testing.assert_array_equal(kept.position_m, skills[0].spread.position_m)


def test_what_is_pressed_is_what_most_pressed_though_the_mean_is_blurred():
    many = [demonstrated(1.0, aside_m) for aside_m in (0.0, 0.01, 0.02)]
    late = many[2][0]
    assert late.force_N is not None
    many[2] = replace(late, force_N=3.0 * late.force_N), many[2][1]
    pressed = [skills_of(*one)[0].press for one in many]
    together = skills_of_many(many)[0].press
    assert together is not None
    assert together.force_N == np.median([one.force_N for one in pressed if one])


def test_what_lies_between_phases_may_be_empty_in_some():
    one, planned = demonstrated(1.0, 0.0)
    rested = (replace(planned[0], end_s=1.9), planned[1])
    mean = mean_of([(one, planned), (one, rested), (one, planned)])
    assert [segment.label for segment in mean.segments] == ["down", "along"]
    assert mean.segments[0].end_s == mean.segments[1].start_s


def test_a_plan_in_another_order_than_was_recorded_is_refused():
    one, planned = demonstrated(1.0, 0.0)
    with pytest.raises(SkillError, match="order in which they were recorded"):
        mean_of([(one, planned[::-1])])


def test_one_demonstration_is_its_own_mean():
    one = demonstrated(1.0, 0.0)
    np.testing.assert_allclose(
        mean_of([one]).demonstration.position_m, one[0].position_m, atol=1e-9
    )


def test_demonstrations_of_other_phases_are_refused():
    one, planned = demonstrated(1.0, 0.0)
    other = (replace(planned[0], label="up"), planned[1])
    with pytest.raises(SkillError, match=r"same phases.*keyphase propose"):
        skills_of_many([(one, planned), (one, other)])
