"""The command `keyphase replay`: what it prints and writes, and how it ends."""

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest

from keyphase.cli import main
from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.simulation import record
from keyphase.skills.exports.skill_file import read_skills

pytestmark = pytest.mark.slow


def keyphase(*arguments: object) -> int:
    """The exit status of the command."""
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    return int(ended.value.code or 0)


@pytest.fixture(scope="module")
def segments(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("segments")
    keyphase("segment", shipped("data") / "setup1.npz", "--output", folder)
    return folder / "setup1.segments.json"


def test_a_success_ends_with_0_and_says_so_last(segments, capsys) -> None:
    assert keyphase("replay", segments, "--workcell", "setup1") == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[-1] == "success"
    assert any("contact" in line for line in lines)


def test_skills_of_several_recordings_are_replayed_as_one(segments, tmp_path, capsys) -> None:
    save_npz(record("setup1", seed=3), tmp_path / "other.npz")
    keyphase("segment", tmp_path / "other.npz", "--output", tmp_path)
    other, written = tmp_path / "other.segments.json", tmp_path / "s.json"
    assert keyphase("replay", segments, "--with", other, "--skills", written) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "success"
    demonstrated = [one.spread for one in read_skills(written).skills if not one.connecting]
    assert [spread and spread.demonstrations for spread in demonstrated] == [2, 2, 2]
    assert keyphase("replay", segments, "--with", other, "--margin") == 1


def test_a_failure_ends_with_1_and_says_why_last(segments, capsys) -> None:
    options = ("--part-height", "9mm", "--end-conditions", "configuration")
    assert keyphase("replay", segments, *options) == 1
    last = capsys.readouterr().out.splitlines()[-1]
    assert last.startswith("failed, not ")
    assert "unexpected contact" in last


def test_it_writes_the_recording_and_the_plan_in_every_form(segments, tmp_path) -> None:
    names = {"output": "r.npz", "skills": "s.json", "behavior-tree": "t.xml", "program": "p.txt"}
    names |= {"urscript": "u.script", "rapid": "r.mod"}
    options = [part for key, name in names.items() for part in (f"--{key}", tmp_path / name)]
    assert keyphase("replay", segments, *options) == 0
    assert read(tmp_path / "r.npz").metadata["operator"] == "replay"
    skills = read_skills(tmp_path / "s.json").skills
    tree = ElementTree.parse(tmp_path / "t.xml")
    assert len(tree.findall("./BehaviorTree//Action[@ID='ExecuteSkill']")) == len(skills)
    assert (tmp_path / "u.script").read_text().endswith("keyphase_plan()\n")
    assert (tmp_path / "r.mod").read_text().endswith("ENDMODULE\n")
    assert len((tmp_path / "p.txt").read_text().splitlines()) == len(skills) + 1


def test_for_machines_it_prints_json(segments, capsys) -> None:
    assert keyphase("replay", segments, "--json") == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["succeeded"] is True
    assert list(printed)[-1] == "outcome"


def test_trials_print_the_rate_with_its_interval_last_and_draw_it(
    segments, tmp_path, capsys
) -> None:
    picture = tmp_path / "trials.svg"
    spread = ("--part-height", "5mm", "--friction", "0.2..0.6")
    status = keyphase("replay", segments, "--trials", 2, "--jobs", 1, *spread, "--plot", picture)
    last = capsys.readouterr().out.splitlines()[-1]
    assert status == 0
    assert last.startswith("Success in 2 of 2 worlds (100.0 %, 95 % confidence 34.2 to 100.0 %)")
    assert ElementTree.parse(picture).getroot().tag.endswith("svg")


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (("--friction", "0.2..0.6"), "add --trials"),
        (("--workcell", "setup9"), "recording, or a file NAME.toml"),
        (("--part-height", "high"), "--part-height"),
        (("--trials", "2", "--output", "r.npz"), "leave out --trials"),
        (("--plot", "p.svg"), "add --trials"),
        (("--demonstration", str(shipped("data") / "setup2.npz")), "has changed since"),
        (("--part-height", "50mm"), "smaller disturbance"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(segments, capsys, options, why) -> None:
    assert keyphase("replay", segments, *options) == 1
    told = capsys.readouterr().err.strip()
    assert why in told
    assert "\n" not in told
