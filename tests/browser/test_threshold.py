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
    setup1: KeyphasePage,
) -> None:
    setup1.wait_for_scene()
    before = setup1.picture("slider_before")
    segments = setup1.segments.count()
    height = drawn_height(setup1, before)
    middle = setup1.threshold_slider()
    setup1.drag(middle, (middle[0] + 130, middle[1]), steps=6)
    setup1.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    setup1.settle()
    setup1.wait_for_scene()
    after = setup1.picture("slider_after")
    assert drawn_height(setup1, after) < height - 10
    assert setup1.segments.count() == len(setup1.document["segments"])
    if setup1.segments.count() != segments:
        view, color = setup1.box("#viser"), SEGMENT_COLORS[2]
        assert before.count_hue(color, view) != after.count_hue(color, view)


def test_dragging_the_line_moves_the_panels_value(setup1: KeyphasePage) -> None:
    scene = setup1.wait_for_scene()
    row = setup1.row("error")
    x = row.x + 0.5 * row.width
    target = line_height(setup1) - 25
    wanted = setup1.page.evaluate(
        "y => keyphase.timeline.errorAt(y)", target - setup1.box(".surface").y
    )
    setup1.drag((x, line_height(setup1)), (x, target))
    setup1.until(f"Math.abs(keyphase.state.document.threshold / {wanted} - 1) < 0.05")
    threshold = setup1.document["parameters"]["force_threshold"]
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


def test_the_threshold_is_typed_and_given_back_by_keys_alone(setup1: KeyphasePage) -> None:
    scene = setup1.wait_for_scene()
    automatic = setup1.document["threshold"]
    scene.evaluate(_FOCUS_NUMBER, automatic)
    setup1.press("Control+a")
    setup1.page.keyboard.type("5000")
    setup1.press("Enter")
    setup1.until("keyphase.state.document.parameters.force_threshold === 5000")
    assert contacts(setup1) == 0

    setup1.page.locator("#help").focus()
    setup1.press("Control+k")
    setup1.page.keyboard.type("threshold back")
    setup1.press("Enter")
    setup1.until("keyphase.state.document.parameters.force_threshold === null")
    assert setup1.document["threshold"] == automatic


def test_the_panels_button_gives_all_parameters_back(setup1: KeyphasePage) -> None:
    scene = setup1.wait_for_scene()
    setup1.change(
        lambda: setup1.page.evaluate("() => keyphase.actions.setThreshold(5000, false, null)")
    )
    setup1.change(lambda: scene.get_by_role("button", name="Reset to automatic").click())
    assert setup1.document["parameters"]["force_threshold"] is None
