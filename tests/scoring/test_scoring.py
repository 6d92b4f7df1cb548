"""Scores against reference events: what counts, what does not, and what must always hold."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.errors import ScoreError, SegmentFileError
from keyphase.labeling.comparing.matching import covering, match_times
from keyphase.scoring import Tally, Truth, as_json, as_table, read_truth, score, tally

times = st.lists(st.floats(0, 20), max_size=12, unique=True).map(sorted)
tolerances = st.floats(0.01, 3.0)
pairs = st.tuples(st.floats(0, 20), st.floats(0, 20)).map(lambda pair: tuple(sorted(pair)))
intervals = st.lists(pairs, max_size=3)


def segment_file(path, boundaries, duration_s=10.0):
    """A segment file with boundaries at these times and nothing else of interest."""
    edges = [0.0, *boundaries, duration_s]
    end = {"kind": "configuration", "position_tolerance_m": 0.005, "rotation_tolerance_rad": 0.05}
    content = {
        "schema_version": 1,
        "software_version": "keyphase 0",
        "demonstration": {
            "name": path.stem,
            "path": "gone.npz",
            "sha256": "0" * 64,
            "duration_s": duration_s,
            "rate_hz": 100.0,
        },
        "parameters": {},
        "boundaries": [
            {
                "time_s": time,
                "origin": "force",
                "interval_s": [time, time],
                "confidence": 0.5,
                "contact_change": True,
            }
            for time in boundaries
        ],
        "segments": [
            {
                "id": i + 1,
                "start_s": edges[i],
                "end_s": edges[i + 1],
                "label": "",
                "kept": True,
                "end_condition": end,
            }
            for i in range(len(edges) - 1)
        ],
        "plan": [],
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content))
    return path


def reference(path, **entries):
    """A truth.json; each entry is the times of a recording's events, or a whole entry."""
    content = {
        key.replace("__", "/"): entry
        if isinstance(entry, dict)
        else {"events": [[time, "x"] for time in entry], "tolerance_s": 0.25, "ignore": []}
        for key, entry in entries.items()
    }
    path.write_text(json.dumps(content))
    return path


@given(times, times, tolerances)
def test_matches_are_one_to_one_and_within_the_tolerance(a, b, tolerance):
    matches = match_times(a, b, tolerance)
    assert len({match.reference for match in matches}) == len(matches)
    assert len({match.found for match in matches}) == len(matches)
    assert all(abs(a[m.reference] - b[m.found]) <= tolerance for m in matches)


def test_as_many_as_possible_are_matched_even_where_nearest_first_would_lose_one():
    matches = match_times([1.0, 1.4], [1.3, 1.7], 0.35)
    assert [(match.reference, match.found) for match in matches] == [(0, 0), (1, 1)]


def test_two_events_with_a_boundary_each_inside_each_others_tolerance_both_count():
    counted = tally(Truth((1.0, 1.2), (), 0.25), [1.05, 1.15])
    assert (counted.precision, counted.recall) == (1.0, 1.0)


@given(st.lists(st.floats(0, 20), min_size=1, max_size=12, unique=True).map(sorted), tolerances)
def test_a_perfect_prediction_scores_one(events, tolerance):
    counted = tally(Truth(tuple(events), (), tolerance), events)
    assert (counted.precision, counted.recall, counted.f1) == (1.0, 1.0, 1.0)
    assert counted.timing_error_s == 0.0


@given(times, times, tolerances, st.floats(0, 20))
def test_one_more_boundary_never_lowers_recall(events, found, tolerance, more):
    truth = Truth(tuple(events), (), tolerance)
    before, after = tally(truth, found), tally(truth, sorted([*found, more]))
    assert after.found >= before.found
    assert after.missed <= before.missed


@given(times, times, tolerances)
def test_a_false_boundary_never_raises_precision(events, found, tolerance):
    truth = Truth(tuple(events), (), tolerance)
    before, after = tally(truth, found), tally(truth, [*found, 20.0 + 2 * tolerance])
    assert after.found == before.found
    assert after.false == before.false + 1
    assert before.precision is None or (after.precision or 0.0) <= before.precision


@given(times, times, tolerances)
def test_precision_and_recall_change_places_with_reference_and_prediction(a, b, tolerance):
    forth = tally(Truth(tuple(a), (), tolerance), b)
    back = tally(Truth(tuple(b), (), tolerance), a)
    assert (forth.precision, forth.recall) == (back.recall, back.precision)
    assert forth.f1 == back.f1


@given(times, times, tolerances, st.floats(0, 3))
def test_a_wider_tolerance_never_finds_less(events, found, tolerance, wider):
    narrow = tally(Truth(tuple(events), (), tolerance), found)
    wide = tally(Truth(tuple(events), (), tolerance + wider), found)
    assert wide.found >= narrow.found


@given(times, times, tolerances, intervals)
def test_intervals_to_ignore_only_take_false_boundaries_away(events, found, tolerance, ignore):
    strict = tally(Truth(tuple(events), (), tolerance), found)
    lenient = tally(Truth(tuple(events), tuple(ignore), tolerance), found)
    assert (lenient.found, lenient.missed) == (strict.found, strict.missed)
    assert lenient.false + lenient.ignored == strict.false


def test_an_unmatched_boundary_in_an_interval_to_ignore_counts_neither_way():
    counted = tally(Truth((1.0, 5.0), ((4.5, 6.0),), 0.25), [1.1, 4.9, 5.6, 8.0])
    assert counted == Tally(2, 0, 1, 1, (pytest.approx(0.1), pytest.approx(0.1)))


@given(times, times)
def test_covering_is_a_part_and_one_for_equal_segments(a, b):
    assert 0.0 <= covering(a, b, (0.0, 20.0)) <= 1.0 + 1e-12
    assert covering(a, a, (0.0, 20.0)) == pytest.approx(1.0)


def test_covering_weighs_by_duration():
    assert covering([5.0], [], (0.0, 10.0)) == pytest.approx(0.5)
    assert covering([2.0], [3.0], (0.0, 10.0)) == pytest.approx(0.2 * 2 / 3 + 0.8 * 7 / 8)


def test_a_folder_is_scored_per_recording_and_per_set(tmp_path):
    truth = reference(tmp_path / "truth.json", a__1=[2.0, 4.0], a__2=[3.0], b__1=[], c__1=[1.0])
    segment_file(tmp_path / "out" / "a" / "1.segments.json", [2.1, 6.0])
    segment_file(tmp_path / "out" / "a" / "2.segments.json", [3.0])
    segment_file(tmp_path / "out" / "b" / "1.segments.json", [7.0])
    result = score(truth, tmp_path / "out")
    assert [each.key for each in result.recordings] == ["a/1", "a/2", "b/1"]
    assert result.missing == ("c/1",)
    sets = result.sets
    assert (sets["a"].found, sets["a"].missed, sets["a"].false) == (2, 1, 1)
    assert sets["a"].f1 == pytest.approx(2 / 3)
    assert sets["a"].timing_error_s == pytest.approx(0.05)
    assert (sets["b"].precision, sets["b"].recall) == (0.0, None)
    assert result.macro_f1 == pytest.approx(2 / 3)
    assert result.recordings[2].covering is None


def test_json_for_machines_and_a_table_for_people_say_the_same(tmp_path):
    truth = reference(tmp_path / "truth.json", a__1=[2.0, 4.0])
    segment_file(tmp_path / "a" / "1.segments.json", [2.1, 6.0])
    result = score(truth, tmp_path)
    content = json.loads(as_json(result))
    assert content["sets"]["a"]["precision"] == 0.5
    assert content["recordings"]["a/1"]["timing_error_s"] == pytest.approx(0.1)
    assert content["macro_f1"] == 0.5
    lines = as_table(result).splitlines()
    assert lines[1].split()[:4] == ["a/1", "0.500", "0.500", "0.500"]
    assert lines[1].split()[-3:-1] == ["100", "0.500"]
    assert "0.500 judged, 0.500 strict" in as_table(result)


def test_one_file_belongs_to_the_key_its_path_ends_with(tmp_path):
    truth = reference(tmp_path / "truth.json", a__1=[2.0], b__1=[3.0], c__2=[4.0])
    one = segment_file(tmp_path / "b" / "1.segments.json", [3.0])
    assert [each.key for each in score(truth, one).recordings] == ["b/1"]
    two = segment_file(tmp_path / "elsewhere" / "2.segments.json", [4.0])
    assert [each.key for each in score(truth, two).recordings] == ["c/2"]


def test_one_file_that_could_belong_to_several_recordings_is_refused(tmp_path):
    truth = reference(tmp_path / "truth.json", a__1=[2.0], b__1=[3.0])
    path = segment_file(tmp_path / "1.segments.json", [3.0])
    with pytest.raises(ScoreError, match="any of a/1, b/1"):
        score(truth, path)
    other = segment_file(tmp_path / "9.segments.json", [3.0])
    with pytest.raises(ScoreError, match="none of the reference's"):
        score(truth, other)


def test_a_folder_without_segment_files_is_refused(tmp_path):
    truth = reference(tmp_path / "truth.json", a__1=[2.0])
    (tmp_path / "empty").mkdir()
    with pytest.raises(ScoreError, match=r"a/1\.segments\.json"):
        score(truth, tmp_path / "empty")


def test_a_segment_file_that_is_malformed_is_refused(tmp_path):
    truth = reference(tmp_path / "truth.json", a=[2.0])
    (tmp_path / "a.segments.json").write_text("{}")
    with pytest.raises(SegmentFileError, match="required"):
        score(truth, tmp_path)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[]",
        b"{}",
        b'{"a": []}',
        b'{"a": {}}',
        b'{"a": {"events": [[1.0, "x"]]}}',
        b'{"a": {"events": [1.0], "tolerance_s": 0.1}}',
        b'{"a": {"events": [["x", 1.0]], "tolerance_s": 0.1}}',
        b'{"a": {"events": [], "tolerance_s": -1}}',
        b'{"a": {"events": [], "tolerance_s": NaN}}',
        b'{"a": {"events": [], "tolerance_s": 1, "ignore": [[1]]}}',
        b'{"../a": {"events": [], "tolerance_s": 1}}',
        b'{"a": {"events": [], "tolerance_s": 1, "judged": {"what": "some", "events": []}}}',
        b'{"a": {"events": [], "tolerance_s": 1, "judged": {"what": "all"}}}',
        b'{"a": {"events": [], "tolerance_s": 1, "judged": '
        b'{"what": "all", "events": [[1, "x"]], "window_s": [[-1, 0]]}}}',
        b'{"a": {"events": [], "tolerance_s": 1, "judged": '
        b'{"what": "all", "events": [[1, "x"]], "window_s": []}}}',
        b'{"a": {"events": [], "tolerance_s": 1, "judged": '
        b'{"what": "all", "events": [[1, "x"]], "kinds": ["sight"]}}}',
    ],
)
def test_a_malformed_reference_is_refused(tmp_path, content):
    path = tmp_path / "truth.json"
    path.write_bytes(content)
    with pytest.raises(ScoreError, match=r"truth\.json"):
        read_truth(path)


def test_a_reference_that_is_missing_is_refused(tmp_path):
    with pytest.raises(ScoreError, match="cannot be read"):
        read_truth(tmp_path / "nothing.json")


def test_the_shared_reference_can_be_read(real_data):
    truths = read_truth(real_data / "truth.json")
    assert len(truths) == 47
    assert truths["lund_yumi/leadthrough"].ignore_s[0] == (0.0, 2.0)
