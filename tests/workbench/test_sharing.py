"""Parameters for a whole folder leave alone what is done, and one undo takes them back."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from two_pages import TalkingPage, workbench_on

from keyphase.labeling.storage.folder_settings import read_folder_settings

GIVEN = "All recordings of this folder now have these parameters."
BACK = "All recordings of this folder have their former parameters again."

Seen = dict[str, list[tuple[float, float, str]]]


@contextmanager
def page_on(folder: Path, names: str, done: str) -> Iterator[TalkingPage]:
    """A page at recording `a`, which has parameters of its own, in a folder where some are done."""
    workbench = workbench_on(folder, names)
    page = TalkingPage(workbench, "page")
    for name in done:
        page.say("done", page.open(name), done=True)
        page.wait_for(lambda: page.told["document"]["state"] == "done")
    page.open("a")
    page.say("set", page.document(), parameter="min_distance_s", value=2.0)
    page.wait_for(lambda: page.told["document"]["parameters"]["min_distance_s"] == 2.0)
    yield page
    workbench.close()


def seen(page: TalkingPage, names: str) -> Seen:
    """The segments of some recordings."""
    return {
        name: [(s["start_s"], s["end_s"], s["label"]) for s in page.open(name)["segments"]]
        for name in names
    }


def journals(folder: Path, names: str) -> list[bytes]:
    return [(folder / ".keyphase" / f"{name}.npz.journal").read_bytes() for name in names]


def say(page: TalkingPage, kind: str, told: str, **fields: object) -> None:
    """Ask something of recording `a`, and wait until a sentence is told."""
    document = page.open("a")
    page.told.pop("notice", None)
    page.say(kind, document, **fields)
    page.wait_for(lambda: page.told.get("notice", {}).get("text") == told)


def test_of_ten_the_four_done_are_the_same_to_the_last_byte_and_one_undo_restores_the_others(
    tmp_path: Path,
) -> None:
    with page_on(tmp_path, "abcdefghij", "bcde") as page:
        before, bytes_before = seen(page, "bj"), journals(tmp_path, "bcde")

        say(page, "spread", GIVEN, step="apply")
        given = seen(page, "bj")
        assert given["b"] == before["b"]
        assert len(given["j"]) < len(before["j"])
        assert read_folder_settings(tmp_path).parameters.min_distance_s == 2.0

        say(page, "undo", BACK)
        assert seen(page, "bj") == before
        assert read_folder_settings(tmp_path).parameters.min_distance_s != 2.0
        assert journals(tmp_path, "bcde") == bytes_before
        states = [item["state"] for item in page.told["recordings"]["items"]]
        assert states == ["touched", *4 * ["done"], *5 * ["automatic"]]


def test_what_would_be_found_now_of_a_done_one_is_offered_as_a_comparison(tmp_path: Path) -> None:
    with page_on(tmp_path, "ab", "b") as page:
        assert not any("found now" in notice["text"] for notice in page.open("b")["notices"])
        say(page, "spread", GIVEN, step="apply")
        document = page.open("b")
        assert any("compare with “found now”" in notice["text"] for notice in document["notices"])
        page.say("compare", document, **{"with": "found now"})
        page.wait_for(lambda: "comparison" in page.told)
        told = page.told["comparison"]
        assert len(told["only_first_s"]) > len(told["only_second_s"])
        assert page.open("b")["segments"] == document["segments"]


def test_the_preview_says_which_are_done_and_with_the_box_what_would_become_of_them(
    tmp_path: Path,
) -> None:
    with page_on(tmp_path, "abc", "b") as page:
        for include in (False, True):
            page.told.pop("spread", None)
            page.say("spread", page.open("a"), step="look", include_done=include)
            page.wait_for(lambda: len(page.told.get("spread", {}).get("items", ())) == 3)
            items = page.told["spread"]["items"]
            assert [item["done"] for item in items] == [False, True, False]
            assert [bool(item["goes_s"]) for item in items] == [False, include, True]


def test_with_the_box_done_ones_are_opened_again_and_one_undo_closes_them(tmp_path: Path) -> None:
    with page_on(tmp_path, "abc", "bc") as page:
        before = seen(page, "b")
        say(page, "spread", GIVEN, step="apply", include_done=True)
        assert seen(page, "b") != before
        assert page.open("b")["state"] == "touched"
        # Whoever goes on with one of them since keeps what was made of it.
        page.say("edit", page.open("c"), edit={"kind": "label", "time_s": 0.1, "label": "mine"})
        page.wait_for(lambda: page.told["document"]["segments"][0]["label"] == "mine")
        say(page, "undo", BACK)
        assert any("c was worked on since" in refused["text"] for refused in page.refused)
        assert page.open("c")["segments"][0]["label"] == "mine"
        assert seen(page, "b") == before
        assert page.open("b")["state"] == "done"


def test_parameters_that_the_folder_got_meanwhile_are_not_taken_back(tmp_path: Path) -> None:
    with page_on(tmp_path, "ab", "") as page:
        say(page, "spread", GIVEN, step="apply")
        page.say("set", page.open("b"), parameter="min_distance_s", value=0.9)
        page.wait_for(lambda: page.told["document"]["parameters"]["min_distance_s"] == 0.9)
        page.told.pop("notice", None)
        page.say("spread", page.document(), step="apply")
        page.wait_for(lambda: page.told.get("notice", {}).get("text") == GIVEN)
        page.say("undo", page.open("a"))
        page.wait_for(
            lambda: any("by now" in one["text"] for one in page.told["document"]["notices"])
        )
        assert read_folder_settings(tmp_path).parameters.min_distance_s == 0.9
