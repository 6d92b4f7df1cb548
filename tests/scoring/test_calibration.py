"""Confidences that mean what they say, and the picture of a score."""

import sys

import pytest

from keyphase.cli import main
from keyphase.errors import MissingPackageError, ScoreError
from keyphase.scoring import Claim, Score, Truth, calibration
from keyphase.scoring.picture import draw_score
from keyphase.scoring.score import score_recording


def test_the_error_is_the_mean_distance_between_confidence_and_share_right():
    outcomes = [(0.95, True)] * 3 + [(0.95, False)] + [(0.25, False)] * 4
    found = calibration(outcomes)
    assert found.error == pytest.approx(0.5 * 0.2 + 0.5 * 0.25)
    assert (found.count, found.sure, found.sure_right) == (8, 4, 3)
    assert [(each.low, each.count, each.right) for each in found.bins] == [
        (0.2, 4, 0.0),
        (0.9, 4, 0.75),
    ]


def test_nothing_judged_has_no_error():
    assert calibration([]).error is None


def test_full_confidence_belongs_to_the_last_bin():
    assert calibration([(1.0, True)]).bins[0].low == 0.9


@pytest.fixture
def scored() -> Score:
    truth = Truth((1.0, 4.0), (), 0.25)
    claims = [Claim(1.1, True, 0.95), Claim(7.0, False, 0.3)]
    return Score((score_recording("a/1", truth, claims, (0.0, 10.0)),), ())


@pytest.mark.parametrize("ending", [".png", ".svg"])
def test_a_score_is_drawn(scored, tmp_path, ending):
    path = tmp_path / f"score{ending}"
    draw_score(scored, path)
    assert path.read_bytes()[:5] in (b"\x89PNG\r", b"<?xml")


def test_a_picture_of_another_kind_is_refused(scored, tmp_path):
    with pytest.raises(ScoreError, match=r"\*\.svg"):
        draw_score(scored, tmp_path / "score.txt")


def test_without_matplotlib_the_message_says_what_to_install(scored, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    with pytest.raises(MissingPackageError, match=r"keyphase\[pictures\]"):
        draw_score(scored, tmp_path / "score.png")


def test_a_folder_of_ones_own_is_made_segmented_and_scored(tmp_path, capsys):
    for command in (
        f"make-demonstrations --output {tmp_path} --families reach press --count 1",
        f"segment {tmp_path} --output {tmp_path / 'out'} --jobs 1",
        f"score {tmp_path / 'truth.json'} {tmp_path / 'out'} --picture {tmp_path / 'score.png'}",
    ):
        with pytest.raises(SystemExit) as ended:
            main(command.split())
        assert ended.value.code == 0
    said = capsys.readouterr().out
    assert "expected calibration error" in said
    assert "contact" in said
    assert (tmp_path / "score.png").exists()
