"""One connection cannot keep the others waiting, however much it sends."""

import threading
from pathlib import Path

from talking import PageClient, StartServer

from keyphase.web.protocol.conversation import MAX_CHANGES
from keyphase.web.transport.budget import MESSAGES_PER_S, Budget
from keyphase.workbench.desks.asked import Asked


def test_a_connection_may_send_a_burst_and_then_waits() -> None:
    budget = Budget()
    burst = [budget.wait_s() for _ in range(int(MESSAGES_PER_S))]
    spent = Budget(left=0.0)

    assert burst == [0.0] * len(burst)
    assert 0.0 < spent.wait_s() <= 1.0 / MESSAGES_PER_S


def test_an_edit_comes_before_most_of_another_pages_flood(
    own_copy: Path, start_server: StartServer
) -> None:
    server, go = start_server(own_copy), threading.Event()
    with PageClient(server) as flooding, PageClient(server) as other:
        recording = flooding.wait_for("document")["id"]
        other.wait_for("document")
        with server.workbench.library.at(recording) as desk:
            held_up = Asked("nobody", desk.state.revision, print)
            desk.change(lambda _: go.wait(20) and None, held_up)
        for number in range(50):
            _label(flooding, f"flood {number}", number)
        for number in range(50):
            other.send("seek", time_s=number / 100)
            other.wait_for("playhead", lambda m, at=number / 100: m["time_s"] == at)
        _label(other, "mine", 1000)
        _until_heard(other)
        go.set()
        other.wait_for("document", lambda m: bool(m["cause"]) and m["cause"]["event"] == 1000)

    causes = [m["cause"] for m in other.heard if m["type"] == "document" and m["cause"]]
    assert len(causes) <= MAX_CHANGES + 2


def _label(page: PageClient, label: str, event: int) -> None:
    page.send("edit", edit={"kind": "label", "time_s": 0.1, "label": label}, event=event)


def _until_heard(page: PageClient) -> None:
    """A page is heard in order: what it said before has been heard when this is answered."""
    page.send("seek", time_s=0.77)
    page.wait_for("playhead", lambda m: m["time_s"] == 0.77)
