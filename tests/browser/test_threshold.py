"""Moving the threshold, by its line and by the panel's slider, changes both views."""

from driver import ACCENT, SEGMENT_COLORS, KeyphasePage, Picture


def line_height(page: KeyphasePage) -> float:
    """Where the threshold line is told to be on the page [px]."""
    told = page.page.evaluate(
        "() => keyphase.timeline.thresholdY(keyphase.state.document.threshold)"
    )
    return page.box(".surface").y + told


def drawn_height(page: KeyphasePage, picture: Picture) -> float:
    """Where the accent-coloured line is seen [px]."""
    row = page.row("error")
    rows = picture.rows_with(ACCENT["light"], row, least=int(row.width / 3), tolerance=24)
    return sum(rows) / len(rows)


def contacts(page: KeyphasePage) -> int:
    return sum(boundary["contact_change"] for boundary in page.document["boundaries"])


def test_the_line_stays_where_it_was_dragged(editor: KeyphasePage) -> None:
    row = editor.row("error")
    x = row.x + 0.5 * row.width
    target = line_height(editor) - 20
    editor.change(lambda: editor.drag((x, line_height(editor)), (x, target)))
    editor.until("keyphase.state.heldThreshold === null")
    editor.page.mouse.move(10, 10)
    editor.settle()
    assert abs(drawn_height(editor, editor.picture("threshold_dragged")) - target) < 2


def test_dragging_the_line_above_all_peaks_takes_the_contact_change_away(
    editor: KeyphasePage,
) -> None:
    assert contacts(editor) >= 1
    row = editor.row("error")
    x = row.x + 0.5 * row.width
    editor.drag((x, line_height(editor)), (x, row.y + 2))
    editor.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    assert editor.boundaries.count() == len(editor.document["boundaries"])
    assert editor.segments.count() == len(editor.document["segments"])


def test_what_would_come_or_go_is_shown_until_the_line_is_let_go(editor: KeyphasePage) -> None:
    row = editor.row("error")
    x = row.x + 0.5 * row.width
    mouse = editor.page.mouse
    mouse.move(x, line_height(editor))
    mouse.down()
    mouse.move(x, row.y + 2, steps=8)
    editor.until("keyphase.state.ghost.some(g => g.fate === 'goes')")
    editor.settle()
    assert editor.page.locator(".ghost.goes").count() >= 1
    editor.picture("ghosts")
    mouse.up()
    editor.until("keyphase.state.ghost.length === 0")
    editor.settle()
    assert editor.page.locator(".ghost").count() == 0


def test_the_panels_slider_moves_the_line_and_recolors_the_trajectory(
    scene_editor: KeyphasePage,
) -> None:
    scene_editor.wait_for_scene()
    before = scene_editor.picture("slider_before")
    segments = scene_editor.segments.count()
    height = drawn_height(scene_editor, before)
    middle = scene_editor.threshold_slider()
    scene_editor.drag(middle, (middle[0] + 130, middle[1]), steps=6)
    scene_editor.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    scene_editor.settle()
    scene_editor.wait_for_scene()
    after = scene_editor.picture("slider_after")
    assert drawn_height(scene_editor, after) < height - 10
    assert scene_editor.segments.count() == len(scene_editor.document["segments"])
    if scene_editor.segments.count() != segments:
        view, color = scene_editor.box("#viser"), SEGMENT_COLORS[2]
        assert before.count_hue(color, view) != after.count_hue(color, view)


def test_dragging_the_line_moves_the_panels_value(scene_editor: KeyphasePage) -> None:
    scene = scene_editor.wait_for_scene()
    row = scene_editor.row("error")
    x = row.x + 0.5 * row.width
    target = line_height(scene_editor) - 25
    wanted = scene_editor.page.evaluate(
        "y => keyphase.timeline.errorAt(y)", target - scene_editor.box(".surface").y
    )
    scene_editor.drag((x, line_height(scene_editor)), (x, target))
    scene_editor.until(f"Math.abs(keyphase.state.document.threshold / {wanted} - 1) < 0.05")
    threshold = scene_editor.document["parameters"]["force_threshold"]
    scene.wait_for_function(
        """wanted => [...document.querySelectorAll('input')].some(
             field => Math.abs(Number(field.value) - wanted) <= 0.01 * wanted)""",
        arg=threshold,
    )


def test_every_move_is_timed_from_the_hand_to_the_frame(timeline: KeyphasePage) -> None:
    row = timeline.row("error")
    x = row.x + 0.5 * row.width
    timeline.drag((x, line_height(timeline)), (x, line_height(timeline) - 25), steps=6)
    timeline.until("keyphase.latency.length > 0")
    measured = timeline.page.evaluate("() => keyphase.latency")
    assert all(0 < one["milliseconds"] < 60_000 for one in measured)
    assert {one["source"] for one in measured} == {"line"}


_FOCUS_NUMBER = """wanted => [...document.querySelectorAll('input')].find(
  field => Math.abs(Number(field.value) / wanted - 1) < 0.01).focus()"""


def test_the_threshold_is_typed_and_given_back_by_keys_alone(scene_editor: KeyphasePage) -> None:
    scene = scene_editor.wait_for_scene()
    automatic = scene_editor.document["threshold"]
    scene.evaluate(_FOCUS_NUMBER, automatic)
    scene_editor.press("Control+a")
    scene_editor.page.keyboard.type("5000")
    scene_editor.press("Enter")
    scene_editor.until("keyphase.state.document.parameters.force_threshold === 5000")
    assert contacts(scene_editor) == 0

    scene_editor.page.locator("#help").focus()
    scene_editor.press("Control+k")
    scene_editor.page.keyboard.type("threshold back")
    scene_editor.press("Enter")
    scene_editor.until("keyphase.state.document.parameters.force_threshold === null")
    assert scene_editor.document["threshold"] == automatic


def test_the_panels_button_gives_all_parameters_back(scene_editor: KeyphasePage) -> None:
    scene = scene_editor.wait_for_scene()
    scene_editor.change(
        lambda: scene_editor.page.evaluate("() => keyphase.actions.setThreshold(5000, false, null)")
    )
    scene_editor.change(lambda: scene.get_by_role("button", name="Reset to automatic").click())
    assert scene_editor.document["parameters"]["force_threshold"] is None
