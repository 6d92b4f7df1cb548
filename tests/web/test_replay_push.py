"""The spring of the gizmo by which the tool of a replay is pushed."""

from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest

from keyphase.web.scene.replaying.replay_push import PushGizmo


def test_the_label_of_a_spring_is_made_once_and_goes_along() -> None:
    scene = Mock()
    gizmo = PushGizmo(Mock(scene=scene), "/push", np.zeros(3), lambda _: None)
    dragged = scene.add_transform_controls.return_value.on_update.call_args.args[0]
    hand = SimpleNamespace(position=(0.0, 0.15, 0.0))
    with pytest.raises(StopIteration):  # it waits for nothing
        dragged(SimpleNamespace(phase="update", target=hand)).send(None)
    assert scene.add_label.call_args.args[1] == "30 N"
    gizmo.follow(np.array([0.0, 0.05, 0.0]))
    assert scene.add_label.call_count == scene.add_line_segments.call_count == 1
    label = scene.add_label.return_value
    assert label.text == "20 N"
    assert label.position == pytest.approx([0.0, 0.1, 0.0])
