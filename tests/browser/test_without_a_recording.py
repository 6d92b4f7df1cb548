"""What the page says when there is nothing, something unreadable, or nobody there."""

from pathlib import Path

from driver import Serve, Visit

from keyphase.files.shipped import shipped


def test_without_a_recording_the_page_says_how_to_open_one(serve: Serve, visit: Visit) -> None:
    page = visit(serve(), scene=False)
    page.page.locator("#empty").wait_for()
    assert "keyphase my_folder" in page.text("#empty")
    assert page.page.locator(".gutter:visible").count() == 0
    page.picture("empty")


def test_the_demonstration_is_opened_with_one_click(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder=tmp_path), scene=False)
    page.page.get_by_role("button", name="Open the demonstration").click()
    page.wait_for_document()
    assert page.page.locator("#empty").is_hidden()
    assert page.segments.count() == len(page.document["segments"]) > 3
    shown = shipped("data") / "setup1.npz"
    assert (tmp_path / "setup1.npz").read_bytes() == shown.read_bytes()


def test_the_first_steps_tick_themselves_until_they_are_closed(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder=tmp_path), size=(1280, 720), scene=False)
    page.page.get_by_role("button", name="Open the demonstration").click()
    page.wait_for_document()
    steps = page.page.locator("#first-steps li")
    assert steps.count() == 4
    page.press("]")
    page.change(lambda: page.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    page.press("Control+s")
    page.page.locator("#first-steps li.done").nth(1).wait_for()
    page.settle()
    page.picture("first_steps")
    done = "all => all.map(one => one.classList.contains('done'))"
    assert steps.evaluate_all(done) == [False, True, False, True]
    page.page.get_by_role("button", name="Close the first steps").click()
    page.page.locator("#first-steps").wait_for(state="hidden")


def test_without_a_recording_files_are_chosen_or_one_is_recorded(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder=tmp_path), scene=False)
    with page.page.expect_file_chooser():
        page.page.get_by_role("button", name="Choose files…").click()
    page.page.get_by_role("button", name="Record one").click()
    page.panel.get_by_role("button", name="Record", exact=True).wait_for()


def test_an_unreadable_recording_says_why_in_one_place(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    """Of several the one that was asked for; the list has the height that nothing else needs."""
    for name in ("broken", "other"):
        (tmp_path / f"{name}.csv").write_text("time_s,position_x_m\n0,1\n")
    page = visit(serve(tmp_path / "broken.csv", tmp_path / "other.csv"), scene=False)
    page.page.get_by_text("broken cannot be read").wait_for()
    page.picture("unreadable")
    assert "position_y_m" in page.text("#empty")
    assert page.page.locator(".gutter:visible").count() == 0
    page.page.locator(".queue-row", has_text="other").click()
    page.page.get_by_text("other cannot be read").wait_for()
    assert page.page.locator(".notice").count() == 0
    assert page.box("#queue").height > 0.9 * page.box("body").height

    page.page.locator("input[type=file]").set_input_files(shipped("data") / "setup1.npz")
    page.wait_for_document()
    page.page.locator(".queue-row", has_text="broken").click()
    page.page.locator(".notice").get_by_role("button", name="Say how it is read").click()
    page.page.locator("#describing[open]").wait_for()


def test_a_stopped_server_is_told_of_and_the_page_comes_back_with_it(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    server = serve(folder / "setup1.npz")
    page = visit(server, scene=False)
    page.wait_for_document()
    page.change(lambda: page.press("i"))
    saved_at = page.document["saved_at"]
    server.stop()
    page.until("keyphase.state.connected === false")
    page.settle()
    assert page.text("#saved") == "Not connected"
    assert f"Everything up to {saved_at} is saved" in page.text(".banner.gone")
    page.picture("stopped")

    segments = page.document["segments"]
    page.press("x")
    page.page.get_by_text("keyphase is not running: nothing was changed.").wait_for()
    assert page.document["segments"] == segments

    serve(folder / "setup1.npz", port=server.port)
    page.until("keyphase.state.connected === true && !keyphase.state.readOnly")
    page.settle()
    assert page.page.locator(".banner.gone").count() == 0
    assert page.document["segments"] == segments
    page.change(lambda: page.press("x"))
    page.errors.clear()
