"""What a hand moved stays drawn as it was left until the server's answer, 80 ms later, has come."""

from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

_SLOW_SOCKET = """
const ofPrototype = Object.getOwnPropertyDescriptor(WebSocket.prototype, "onmessage");
const send = WebSocket.prototype.send;
WebSocket.prototype.send = function (data) { setTimeout(() => send.call(this, data), 40); };
Object.defineProperty(WebSocket.prototype, "onmessage", {
  set(heard) {
    const hear = (event) => window.kept ? window.kept.push(() => heard(event)) : heard(event);
    ofPrototype.set.call(this, (event) => setTimeout(() => hear(event), 40));
  },
});
"""
"""40 ms on the way there and 40 ms on the way back, or for as long as there is a list `kept`."""

_RECORD = """(read) => {
  const seen = (window.seenFrames = []);
  const look = eval(read);
  const record = () => {
    const { pending, held } = keyphase.state;
    const waiting = pending.length > 0 || "min_distance_s" in held;
    seen.push({ value: look(), waiting });
    if (seen.length < 600) requestAnimationFrame(record);
  };
  addEventListener("pointerup", () => requestAnimationFrame(record), { once: true, capture: true });
}"""


@pytest.fixture
def slow(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.page.add_init_script(_SLOW_SOCKET)
    page.page.reload()
    page.wait_for_document()
    return page


def frames_until_answered(page: KeyphasePage) -> list[dict[str, float]]:
    """From the pointer's going up to a few frames after the answer."""
    page.until("seenFrames.some(one => one.waiting) && !seenFrames.at(-1).waiting")
    page.settle()
    seen = page.page.evaluate("() => seenFrames")
    answered = next(k for k, one in enumerate(seen) if k and not one["waiting"])
    return seen[: answered + 2]


def test_a_dragged_boundary_never_jumps_back(slow: KeyphasePage) -> None:
    row = slow.row("boundaries")
    time_s = slow.document["boundaries"][1]["time_s"]
    start = (slow.x(time_s), row.y + row.height / 2)
    end_x = start[0] + 37
    slow.press("v")
    slow.page.evaluate(
        _RECORD,
        """() => Number(document.querySelector('[data-boundary="1"] .boundary-line')
            .getAttribute("d").match(/^M([\\d.]+)/)[1])""",
    )
    slow.drag(start, (end_x, start[1]))
    seen = frames_until_answered(slow)
    left_at = end_x - slow.box(".surface").x
    assert [one["value"] for one in seen] == pytest.approx([left_at] * len(seen), abs=1.0)


def test_a_slider_that_was_let_go_keeps_its_value(slow: KeyphasePage) -> None:
    thumb = slow.slider("Min. distance, s")
    number = slow.panel.get_by_label("Min. distance, s, value")
    slow.page.evaluate(
        _RECORD,
        "() => Number(document.querySelector('[aria-label=\"Min. distance, s, value\"]').value)",
    )
    slow.drag(thumb, (thumb[0] + 45, thumb[1]))
    left_at = float(number.input_value())
    assert left_at > 0.4
    seen = frames_until_answered(slow)
    assert {one["value"] for one in seen} == {left_at}


def test_a_name_given_is_seen_at_once(slow: KeyphasePage) -> None:
    slow.click(slow.middle_of(0))
    slow.press("l")
    slow.page.locator("#rename input").fill("reach")
    slow.page.evaluate("() => { window.kept = []; }")
    slow.press("Enter")
    slow.until("keyphase.state.pending.length === 1")
    slow.settle()
    label = slow.page.locator("[data-segment='0'] .segment-label")
    assert label.text_content() == "reach"
    slow.page.evaluate("() => { for (const hear of window.kept) hear(); window.kept = null; }")
    slow.until("keyphase.state.pending.length === 0")
    slow.settle()
    assert label.text_content() == "reach"
    assert slow.labels()[0] == "reach"
