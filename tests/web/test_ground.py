"""The ground of the scene: lit around the path, with a robot's shadow on it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.robot.arms import yumi_arms
from keyphase.robot.pose import Placement
from keyphase.web.scene.palette import DARK, LIGHT, Theme
from keyphase.web.scene.recording.ground import Ground, covered
from keyphase.web.scene.recording.ground_shadow import SUN_M, GroundShadow, shadow_of, thrown
from keyphase.web.transport.viser_page import HEAD

both_themes = pytest.mark.parametrize("theme", [LIGHT, DARK])


def _block() -> GroundShadow:
    """The shadow of a block of 0.4 by 0.2 m that lies on the ground at the origin."""
    x, y = np.meshgrid(np.linspace(-0.2, 0.2, 81), np.linspace(-0.1, 0.1, 41))
    shadow = thrown(np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3))
    assert shadow is not None
    return shadow


@both_themes
def test_behind_the_scene_is_the_sky_into_which_the_ground_fades(theme: Theme) -> None:
    assert f"canvas[data-engine] {{ background: #{bytes(theme.sky).hex()}; }}" in HEAD


@both_themes
def test_the_ground_has_its_colour_at_the_path_and_the_skys_far_away(theme: Theme) -> None:
    picture = Ground((0.3, -0.2, 0.0), 2.0).picture(theme, None, None)

    assert tuple(picture[len(picture) // 2, len(picture) // 2]) == theme.ground
    assert tuple(picture[0, 0]) == theme.sky


@both_themes
def test_a_shadow_darkens_the_ground_below_the_robot_only(theme: Theme) -> None:
    ground = Ground((0.0, 0.0, 0.0), 2.0)
    plain = ground.picture(theme, Placement(), None).astype(int)
    shaded = ground.picture(theme, Placement(), _block()).astype(int)
    middle = len(plain) // 2

    expected = (1.0 - theme.shade) * plain[middle, middle]
    assert np.abs(shaded[middle, middle] - expected).max() <= 1
    assert (shaded[: middle // 2] == plain[: middle // 2]).all()


@given(st.floats(0.05, 0.6))
def test_what_is_higher_throws_its_shadow_further_from_the_sun(height: float) -> None:
    shadow = thrown(np.array([[0.0, 0.0, height]]))

    assert shadow is not None
    expected = -height * np.array(SUN_M[:2]) / SUN_M[2]
    np.testing.assert_allclose(shadow.middle_m, expected, atol=0.02)


@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_the_shadow_stands_and_turns_with_the_robot(x: float, y: float) -> None:
    quarter_turn = (np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5))
    base = Placement((x, y, 0.3), quarter_turn)
    along, across = np.array([x, y + 0.13]), np.array([x + 0.17, y])

    assert covered(_block(), base, along) > 0.9
    assert covered(_block(), base, across) < 0.1


def test_the_feet_of_the_yumi_are_in_its_shadow() -> None:
    robot = yumi_arms()[0]
    shadow = shadow_of(robot)

    assert shadow is not None
    assert covered(shadow, Placement(), np.array([-0.1, 0.0])) > 0.99
    assert covered(shadow, Placement(), np.array([0.6, -0.3])) == 0.0


def test_nothing_throws_no_shadow() -> None:
    assert thrown(np.empty((0, 3))) is None
