"""Files dropped on the page or chosen: they arrive, or are refused with the reason."""

import base64
from pathlib import Path

import pytest
from driver import KeyphasePage

from keyphase.files.shipped import shipped

_DROP_ON = """(node, { name, data }) => {
  const bytes = Uint8Array.from(atob(data), letter => letter.charCodeAt(0));
  const transfer = new DataTransfer();
  transfer.items.add(new File([bytes], name));
  for (const kind of ['dragover', 'drop']) {
    node.dispatchEvent(
      new DragEvent(kind, { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }
}"""


def _drop(page: KeyphasePage, name: str, data: bytes) -> None:
    dropped = {"name": name, "data": base64.b64encode(data).decode()}
    page.page.locator("body").evaluate(_DROP_ON, dropped)


def test_a_dropped_recording_opens(editor: KeyphasePage) -> None:
    _drop(editor, "setup2.npz", (shipped("data") / "setup2.npz").read_bytes())
    editor.until("keyphase.state.document.name === 'setup2'")

    editor.until("document.querySelectorAll('.queue-row').length === 2")
    assert editor.page.locator("#drop-target").is_hidden()


def _drop_from_disk(page: KeyphasePage, path: Path) -> None:
    """As a file manager drops files and folders."""
    devtools = page.page.context.new_cdp_session(page.page)
    data = {"items": [], "files": [str(path)], "dragOperationsMask": 1}
    for kind in ("dragEnter", "dragOver", "drop"):
        devtools.send("Input.dispatchDragEvent", {"type": kind, "x": 700, "y": 900, "data": data})


def test_of_a_dropped_folder_the_recordings_come_and_a_dataset_is_told_the_way(
    editor: KeyphasePage, tmp_path: Path
) -> None:
    some = tmp_path / "some"
    (some / "within").mkdir(parents=True)
    (some / "README.txt").write_text("two recordings")
    for at in ("first.npz", "within/second.npz"):
        (some / at).write_bytes((shipped("data") / "setup2.npz").read_bytes())
    _drop_from_disk(editor, some)
    editor.until("document.querySelectorAll('.queue-row').length === 3")
    names = sorted(item["name"] for item in editor.state("recordings")["items"])
    assert names == ["first", "second", "setup1"]

    bag = tmp_path / "run_7"
    bag.mkdir()
    (bag / "metadata.yaml").write_text("rosbag2_bagfile_information: {}")
    (bag / "run_7_0.mcap").write_bytes(b"MCAP")
    _drop_from_disk(editor, bag)
    editor.page.locator(".notice.warning", has_text="keyphase run_7").wait_for()
    assert editor.page.locator(".notice.warning").count() == 1


def test_a_chosen_recording_opens_by_keys_alone(editor: KeyphasePage, folder: Path) -> None:
    chosen = folder / "elsewhere" / "setup1.npz"
    chosen.parent.mkdir()
    chosen.write_bytes((folder / "synthetic_setup1.npz").read_bytes())
    with editor.page.expect_file_chooser() as chooser:
        editor.press("Control+o")
    chooser.value.set_files(chosen)

    editor.until("keyphase.state.document.name === 'setup1_2'")
    assert (folder / "setup1_2.npz").read_bytes() == chosen.read_bytes()


def test_the_page_shows_where_files_can_be_dropped(editor: KeyphasePage) -> None:
    editor.page.evaluate("""() => {
      const transfer = new DataTransfer();
      transfer.items.add(new File(["x"], "x.npz"));
      document.body.dispatchEvent(
        new DragEvent('dragover', { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }""")
    editor.page.locator("#drop-target").wait_for()
    editor.picture("drop_target")


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("run.exe", "of none of these kinds"),
        ("<img src=x onerror=alert(1)>.npz", "onerror"),
        ("run_0.db3", "keyphase FOLDER"),
    ],
)
def test_what_is_no_recording_is_refused_with_the_reason(
    editor: KeyphasePage, folder: Path, name: str, told: str
) -> None:
    before = {path.name for path in folder.iterdir()}
    _drop(editor, name, b"MZ")
    editor.page.locator(".notice.warning", has_text=told).wait_for()
    editor.picture("upload_refused")

    assert {path.name for path in folder.iterdir()} == before
    assert editor.page.locator(".queue-row").count() == 1
    assert editor.page.locator(".notice img").count() == 0


def test_after_a_refused_file_the_next_one_still_comes(editor: KeyphasePage) -> None:
    _drop(editor, "run.exe", b"MZ")
    _drop(editor, "setup2.npz", (shipped("data") / "setup2.npz").read_bytes())

    editor.until("keyphase.state.document.name === 'setup2'")


def test_a_dropped_segment_file_is_compared_at_once(editor: KeyphasePage, folder: Path) -> None:
    editor.press("Control+s")
    editor.page.locator(".notice", has_text="Written to").wait_for()
    written = (folder / "setup1.segments.json").read_bytes()
    _drop(editor, "anna.segments.json", written)
    editor.page.locator(".other-segment").first.wait_for()

    assert editor.state("comparison")["with"] == "anna.segments.json"
    assert editor.state("comparison")["f1"] == 1.0
    assert (folder / "anna.segments.json").read_bytes() == written


def test_a_recording_is_chosen_with_the_mouse(editor: KeyphasePage) -> None:
    with editor.page.expect_file_chooser() as chooser:
        editor.page.locator("#add-recording").click()
    chooser.value.set_files(shipped("data") / "setup2.npz")
    editor.until("keyphase.state.document.name === 'setup2'")


def test_a_recording_dropped_over_the_scene_opens(setup1: KeyphasePage) -> None:
    scene = setup1.wait_for_scene()
    data = base64.b64encode((shipped("data") / "setup2.npz").read_bytes()).decode()
    scene.locator("canvas").first.evaluate(_DROP_ON, {"name": "setup2.npz", "data": data})
    setup1.until("keyphase.state.document.name === 'setup2'")
    assert setup1.page.locator("#drop-target").is_hidden()


_SLOWLY = """() => {
  keyphase.socket.roomFor = () => new Promise(next => setTimeout(next, 100));
}"""
"""As over a slow network: a piece now and then."""


@pytest.mark.parametrize("by", ["mouse", "key"])
def test_a_file_on_its_way_is_given_up(timeline: KeyphasePage, folder: Path, by: str) -> None:
    before = {path.name for path in folder.iterdir()}
    timeline.page.evaluate(_SLOWLY)
    _drop(timeline, "long.npz", bytes(8 << 20))
    timeline.until("keyphase.state.sending?.fraction > 0.1")
    timeline.settle()
    timeline.picture("sending")
    assert timeline.text("#sending").startswith("Sending long.npz")
    if by == "mouse":
        timeline.page.get_by_role("button", name="Do not send it").click()
    else:
        timeline.press("Escape")
    timeline.page.locator(".notice", has_text="long.npz was not added").wait_for()

    assert timeline.page.locator("#sending").is_hidden()
    assert {path.name for path in folder.iterdir()} == before
    _drop(timeline, "setup2.npz", (shipped("data") / "setup2.npz").read_bytes())
    timeline.until("keyphase.state.document.name === 'setup2'")
