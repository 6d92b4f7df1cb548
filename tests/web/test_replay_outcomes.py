"""The table of a replay's outcomes in the panel."""

import re
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from talking import PageClient, StartServer

from keyphase.files.shipped import shipped
from keyphase.web.replay_outcomes import outcome_table
from keyphase.web.server import PageServer

HOSTILE = '3 <b onload="x">|*a*</td>'


@pytest.fixture
def server(tmp_path: Path, start_server: StartServer) -> PageServer:
    return start_server(Path(shutil.copy(shipped("data") / "setup1.npz", tmp_path)))


def replayed(server: PageServer, label: str | None = None) -> ElementTree.Element:
    """The table after a replay, with the first segment given a label."""
    with PageClient(server) as page:
        page.wait_for("document")
        page.send("edit", edit={"kind": "drop_idle"})
        page.wait_for("document", lambda m: not m["proposed_drops"])
        if label:
            page.send("edit", edit={"kind": "label", "time_s": 0.1, "label": label})
            page.wait_for("document", lambda m: m["segments"][0]["label"] == label)
        page.send("replay", do="run", speed=4.0)
        page.wait_for("replay", lambda m: m["phase"] == "over")
        running = server.session.replay.running
        assert running
        return ElementTree.fromstring(outcome_table(running))


def rows_of(table: ElementTree.Element) -> list[list[str]]:
    return [["".join(cell.itertext()) for cell in row] for row in table.iter("tr")]


def test_every_skill_has_a_row_with_its_outcome_time_and_force(server: PageServer) -> None:
    head, *rows = rows_of(replayed(server))
    assert head == ["Skill", "Outcome", "Time", "Peak"]
    assert [row[:2] for row in rows] == [
        ["connect", "reached"],
        ["1 Forward", "reached"],
        ["3 Down until contact", "contact"],
        ["5 Slide left until contact", "contact"],
    ]
    for row in rows:
        assert re.fullmatch(r"\d\.\d\d s", row[2])
        assert re.fullmatch(r"\d\.\d N", row[3])


def test_a_label_stays_text(server: PageServer) -> None:
    table = replayed(server, HOSTILE)
    assert f"1 {HOSTILE}" in [row[0] for row in rows_of(table)]
    assert {element.tag for element in table.iter()} == {
        "table",
        "tr",
        "th",
        "td",
        "span",
        "div",
        "b",
    }
