"""A folder of recordings: its vocabulary, its parameters, its queue, by mouse and by keys."""

import shutil
from pathlib import Path

from driver import KeyphasePage, Serve, Visit

from keyphase.files.shipped import shipped


def _open(page: KeyphasePage, name: str) -> None:
    page.page.locator(".queue-row", has_text=name).first.click()
    page.until(f"keyphase.state.document.name === '{name}'")


def _name_selected(page: KeyphasePage, name: str) -> None:
    page.press("l")
    page.until("keyphase.state.renaming !== null && !document.getElementById('rename').hidden")
    page.page.keyboard.type(name)
    page.change(lambda: page.press("Enter"))


def _one_gaussian(page: KeyphasePage) -> None:
    """One Gaussian, which only the paper's method fits to find boundaries."""
    page.set_parameter("variant", "paper")
    one = "() => keyphase.actions.send({type: 'set', parameter: 'gaussians', value: 1})"
    page.change(lambda: page.page.evaluate(one))


def test_a_name_once_given_is_a_number_key_in_the_next_recording(two: KeyphasePage) -> None:
    two.press("]")
    two.until("keyphase.state.selected === 0")
    two.press("1")
    two.page.locator(".notice", has_text="No name has the number 1 yet").wait_for()
    _name_selected(two, "Reach")
    color = two.document["segments"][0]["color"]
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.press("]")
    two.press("]")
    two.until("keyphase.state.selected === 1")
    two.change(lambda: two.press("1"))

    assert two.labels()[1] == "Reach"
    assert two.document["segments"][1]["color"] == color
    segments = two.document["segments"]
    assert two.state("selected") == next(k for k in range(2, 9) if segments[k]["kept"])


def test_back_leads_to_the_recording_before_after_a_reload_too(two: KeyphasePage) -> None:
    two.until("location.hash === '#setup1'")
    two.page.reload()
    two.wait_for_document()
    two.press("PageDown")
    two.until("location.hash === '#synthetic_setup1'")
    two.page.go_back()
    two.until("keyphase.state.document.name === 'setup1'")


def test_a_name_is_completed_and_can_be_taken_out_of_the_vocabulary(two: KeyphasePage) -> None:
    two.press("]")
    _name_selected(two, "Reach")
    two.click(two.middle_of(2), count=2)
    two.page.locator("#rename li", has_text="Reach").first.wait_for()
    two.page.keyboard.type("rea")
    two.press("ArrowDown")
    two.settle()
    two.picture("vocabulary")
    two.change(lambda: two.press("Enter"))
    assert two.labels()[2] == "Reach"

    two.click(two.middle_of(3), count=2)
    entry = two.page.locator("#rename li", has_text="Reach").first
    entry.hover()
    entry.get_by_role("button").dispatch_event("pointerdown")
    two.until("keyphase.state.labels.length === 0")
    assert two.labels()[2] == "Reach"


def test_parameters_are_applied_to_all_by_keys_after_a_look_at_what_would_change(
    two: KeyphasePage,
) -> None:
    _one_gaussian(two)
    two.press("Control+k")
    two.page.keyboard.type("parameters to all")
    two.press("Enter")
    two.page.locator("#spread button:focus", has_text="Apply to all").wait_for()
    two.picture("spread")
    assert "would change" in two.text("#spread p")
    assert "boundar" in two.text("#spread .spread-row:has-text('synthetic_setup1') .goes")
    assert "Gaussians 1" in two.text("#spread .spread-row:has-text('gives them')")

    two.press("Enter")
    two.page.locator(".notice", has_text="All recordings").wait_for()
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    assert two.document["parameters"]["gaussians"] == 1


def test_the_panels_button_applies_parameters_to_all_by_clicks(two: KeyphasePage) -> None:
    page = two
    page.set_parameter("force_threshold", 0.9)
    page.panel.get_by_role("button", name="Apply to all…").click()
    page.page.locator("#spread button:enabled", has_text="Apply to all").wait_for()
    page.picture("spread_by_mouse")
    page.page.locator("#spread").get_by_role("button", name="Apply to all").click()
    page.page.locator(".notice", has_text="All recordings").wait_for()
    _open(page, "synthetic_setup1")
    assert page.document["parameters"]["force_threshold"] == 0.9


def test_parameters_are_not_applied_where_a_person_thinks_better_of_it(two: KeyphasePage) -> None:
    _open(two, "setup1")
    two.set_parameter("force_threshold", 0.9)
    two.page.evaluate("() => keyphase.actions.spread('look')")
    two.until("keyphase.state.spread?.items.length === 2")
    told = two.state("spread")
    two.page.locator("#spread").get_by_role("button", name="Cancel").click()
    two.until("keyphase.state.spread === null")
    # What was under way comes late.
    two.page.evaluate("spread => keyphase.store.set({ spread })", told)
    two.settle()
    assert two.page.locator("#spread").is_hidden()
    _open(two, "synthetic_setup1")

    assert two.document["parameters"]["force_threshold"] is None


def test_a_recording_is_done_and_the_next_one_opens(two: KeyphasePage) -> None:
    unsure = sum(boundary["unsure"] for boundary in two.document["boundaries"])
    two.press("k")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.until("keyphase.state.recordings.items[0].state === 'done'")
    told = two.text("#notices")
    assert f"Done with {unsure} boundary unsure (Ctrl Z). Next: synthetic_setup1." in told
    notice, scene = two.box(".notice"), two.box("#scene")
    assert scene.y <= notice.y < notice.y + notice.height <= scene.y + scene.height
    two.change(lambda: two.page.locator("#badge").click())
    two.until("keyphase.state.recordings.items[1].state === 'done'")
    assert two.page.locator(".queue-row svg[aria-label=done]").count() == 2

    two.change(lambda: two.press("Shift+K"))
    two.until("keyphase.state.recordings.items[1].state === 'touched'")
    two.press("PageUp")
    two.until("keyphase.state.document.name === 'setup1'")
    two.until("!document.querySelector('.notice')")


def test_the_least_certain_recording_opens(two: KeyphasePage) -> None:
    two.until("keyphase.state.recordings.items.every(item => item.confidence !== null)")
    items = two.state("recordings")["items"]
    least = min(items, key=lambda item: item["confidence"])["name"]
    two.press("u")
    two.until(f"keyphase.state.document.name === '{least}'")
    _open(two, next(item["name"] for item in items if item["name"] != least))
    two.page.locator("#least-certain").click()
    two.until(f"keyphase.state.document.name === '{least}'")


def test_next_and_previous_and_the_order_of_the_list_by_clicks(two: KeyphasePage) -> None:
    two.until("keyphase.state.recordings.items.every(item => item.confidence !== null)")
    two.page.locator(".queue-row").first.click()
    assert two.page.evaluate("document.activeElement.className") == "surface"
    two.page.locator("#next-recording").click()
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.page.locator("#previous-recording").click()
    two.until("keyphase.state.document.name === 'setup1'")

    two.page.locator("#queue-sort").click()
    two.settle()
    shown = two.page.locator(".queue-confidence").all_inner_texts()
    assert shown == sorted(shown)


def test_doubts_are_settled_by_two_keys_from_one_recording_to_the_next(
    tmp_path: Path, serve: Serve, visit: Visit
) -> None:
    for name in ("first.npz", "second.npz"):
        shutil.copy(shipped("data") / "setup1.npz", tmp_path / name)
    page = visit(serve(tmp_path), scene=False)
    page.wait_for_document()
    page.until("keyphase.state.recordings.items.every(item => item.confidence !== null)")
    first, second = page.state("recordings")["items"]
    assert first["unsure"] == 1
    assert second["unsure"] > 0
    page.press("n")
    page.until("keyphase.state.playhead.between_s !== null && keyphase.state.playhead.playing")
    time_s = page.document["boundaries"][page.state("current")]["time_s"]
    assert page.state("playhead")["between_s"] == [time_s - 0.7, time_s + 0.7]
    page.change(lambda: page.press("Enter"))
    page.page.locator(".notice", has_text="N: the next doubt, in second").wait_for()
    page.until("keyphase.state.playhead.between_s === null && !keyphase.state.playhead.playing")

    page.press("n")
    page.until("keyphase.state.document.name === 'second' && keyphase.state.current !== null")
    boundaries = page.document["boundaries"]
    unsure = [k for k, one in enumerate(boundaries) if one["unsure"]]
    least = min(unsure, key=lambda k: boundaries[k]["confidence"])
    assert page.state("current") == least
    assert f"{len(unsure)} unsure" in page.text("#transport .unsure")

    for _ in unsure:
        page.change(lambda: page.press("Enter"))
    page.page.locator(".notice", has_text="No doubt left").wait_for()
    page.press("n")
    page.page.locator(".notice", has_text="No boundary is unsure").wait_for()
    assert page.page.locator(".notice").count() == 1
    page.press("Escape")
    assert page.page.locator(".notice").count() == 0


def test_the_name_in_the_header_opens_the_list_of_recordings(two: KeyphasePage) -> None:
    two.page.locator("#crumb").click()
    found = two.page.locator("#palette [role=option] span:first-child")
    assert found.all_text_contents() == ["setup1", "synthetic_setup1"]
    two.press("ArrowDown")
    two.press("Enter")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")


def test_next_and_previous_by_keys(two: KeyphasePage) -> None:
    two.press("PageDown")
    two.until("keyphase.state.document.name === 'synthetic_setup1'")
    two.press("PageUp")
    two.until("keyphase.state.document.name === 'setup1'")


def test_a_second_server_opens_the_recording_for_looking_and_says_so(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    first = visit(serve(folder / "setup1.npz"), scene=False)
    first.wait_for_document()
    second = visit(serve(folder / "setup1.npz"), scene=False)
    second.wait_for_document()
    second.settle()
    second.picture("second_server")

    assert "Read only" in second.text("#banners")
    assert "editing setup1.npz" in second.text("#banners")
    second.press("]")
    second.press("x")
    second.press("Control+s")
    second.page.locator(".notice", has_text="Written to").wait_for()
    assert second.document["edits"] == 0


def _changed_recording(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """A page on a recording that was labeled and has other bytes since."""
    path = folder / "setup1.npz"
    server = serve(path)
    before = visit(server, scene=False)
    before.wait_for_document()
    before.change(lambda: before.page.evaluate("() => keyphase.actions.addBoundary(0.6)"))
    before.close()
    server.stop()
    path.write_bytes((folder / "synthetic_setup1.npz").read_bytes())
    after = visit(serve(path), scene=False)
    after.wait_for_document()
    return after


def test_labels_of_a_recording_that_changed_are_kept_when_a_person_says_so(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = _changed_recording(folder, serve, visit)
    assert "has changed since" in page.text("#banners")
    page.picture("changed")
    page.change(lambda: page.page.get_by_role("button", name="Keep them").click())

    page.until("!keyphase.state.document.changed")
    assert page.document["edits"] == 1


def test_a_recording_that_changed_is_started_over_when_a_person_says_so(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = _changed_recording(folder, serve, visit)
    page.page.get_by_role("button", name="Start over").click()

    page.until("!keyphase.state.document.changed")
    assert all(abs(b["time_s"] - 0.6) > 1e-6 for b in page.document["boundaries"])


def test_edits_that_lost_their_place_are_brought_back_or_forgotten(two: KeyphasePage) -> None:
    two.set_parameter("variant", "paper")
    moved = two.document["boundaries"][0]["time_s"]
    two.change(lambda: two.page.evaluate("t => keyphase.actions.moveBoundary(t, t + 0.05)", moved))
    last = two.document["boundaries"][-1]["time_s"]
    two.change(lambda: two.page.evaluate("t => keyphase.actions.moveBoundary(t, t + 0.05)", last))
    two.set_parameter("force_threshold", 1.0)
    one = "() => keyphase.actions.send({type: 'set', parameter: 'gaussians', value: 1})"
    two.change(lambda: two.page.evaluate(one))
    lost = two.document["inapplicable"]
    assert lost
    two.picture("inapplicable")
    two.change(lambda: two.page.get_by_role("button", name="Bring back").first.click())
    assert len(two.document["inapplicable"]) == len(lost) - 1
    if len(lost) > 1:
        two.change(lambda: two.page.get_by_role("button", name="Forget").first.click())
        assert len(two.document["inapplicable"]) == len(lost) - 2
