"""Labels, names and metadata are text, whatever they look like."""

import json
from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, Serve, Visit

HOSTILE = [
    '<img src=x onerror="parent.hacked=1;window.hacked=1">',
    "<script>window.hacked=1</script>",
    "</text></svg><script>window.hacked=1</script>",
    "[x](javascript:window.hacked=1)",
    "{{7*7}} ${window.hacked=1}",
    "\u202egnitfil\u202c <b>bold</b>",
    "a" * 180,
]


@pytest.mark.parametrize("label", HOSTILE, ids=range(len(HOSTILE)))
def test_a_label_stays_text(editor: KeyphasePage, label: str) -> None:
    editor.page.evaluate("label => keyphase.actions.label(label, 0)", label)
    editor.until("keyphase.state.document.edits > 0 || document.querySelector('.notice')")
    editor.page.evaluate("() => keyphase.actions.rename(0)")
    editor.press("Escape")
    editor.press("Control+k")
    editor.press("Escape")
    editor.settle()
    assert editor.page.evaluate("() => window.hacked") is None
    assert editor.page.locator("main img[src]:not([src^='/app']), #editor script").count() == 0


def test_a_hostile_name_and_metadata_run_nothing_in_page_and_scene(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    with np.load(folder / "setup1.npz") as recorded:
        arrays = dict(recorded)
    arrays["metadata_json"] = np.array(json.dumps({"name": HOSTILE[0], "task": HOSTILE[1]}))
    path = folder / "<img src=x onerror=window.hacked=1>.npz"
    np.savez(path, **arrays)
    page = visit(serve(path))
    page.wait_for_document()
    page.wait_for_scene()
    page.page.evaluate("label => keyphase.actions.label(label, 0)", HOSTILE[0])
    page.until("keyphase.state.document.edits > 0 || document.querySelector('.notice')")
    page.wait_for_scene()
    page.picture("hostile")
    assert page.page.evaluate("() => window.hacked") is None
    assert page.scene.evaluate("() => window.hacked") is None


MESSAGES: list[dict[str, object]] = [
    {"type": HOSTILE[0]},
    {"type": "edit", "edit": {"kind": HOSTILE[0]}},
    {"type": "edit", "edit": {"kind": "label", "time_s": 1.0, "label": HOSTILE[0], "x": 1}},
    {"type": "edit", "edit": {"kind": "add", "time_s": 1e300}},
    {"type": "set", "parameter": HOSTILE[0], "value": 1.0},
    {"type": "set", "parameter": "gaussians", "value": -1.0},
    {"type": "open", "id": HOSTILE[0]},
    {"type": "select", "segment": 999},
    {"type": "seek", "time_s": HOSTILE[0]},
    {"type": "compare", "with": "../../../etc/passwd"},
    {"type": "take_over", "from": HOSTILE[0]},
    {"type": "export", "kind": "../../x"},
    {"type": "show", "what": HOSTILE[0], "visible": True},
]


def test_hostile_messages_are_refused_in_words_and_change_nothing(editor: KeyphasePage) -> None:
    before = editor.document
    notice = editor.page.locator(".notice.warning")
    for message in MESSAGES:
        editor.page.evaluate("message => keyphase.actions.send(message)", message)
        notice.wait_for()
        assert editor.page.locator(".notice :is(img, script, [onload], [onerror])").count() == 0
        notice.get_by_role("button").click()
        notice.wait_for(state="detached")

    assert editor.page.evaluate("() => window.hacked") is None
    assert editor.document["boundaries"] == before["boundaries"]
    assert editor.labels() == [segment["label"] for segment in before["segments"]]


def test_no_script_can_be_put_into_the_page(editor: KeyphasePage) -> None:
    editor.errors.clear()
    editor.page.evaluate(
        """() => {
          const script = document.createElement('script');
          script.textContent = 'window.hacked = 1';
          document.body.append(script);
        }"""
    )
    assert editor.page.evaluate("() => window.hacked") is None
    assert any("Content Security Policy" in error for error in editor.errors)
    editor.errors.clear()


def test_the_token_leaves_the_address(editor: KeyphasePage) -> None:
    assert "token" not in editor.page.url
