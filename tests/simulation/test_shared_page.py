"""A shared replay says what it is."""

from dataclasses import replace

from replaying import bundled, nominal

from keyphase import __version__
from keyphase.simulation.replay.shared_page import summary, with_summary

FILM = "<html><body><div>film</div></body></html>"


def test_it_names_recording_verdict_skills_forces_and_versions() -> None:
    result, demonstration = nominal("setup1"), bundled("setup1")[0]
    page = with_summary(FILM, result, demonstration)
    assert page.startswith("<html><body><div>film</div>")
    assert page.endswith("</body></html>")
    for said in (demonstration.name, result.outcome(), f"keyphase {__version__}", "MuJoCo"):
        assert said in page
    for skill, each in zip(result.skills, result.results, strict=True):
        assert skill.label in page
        assert f"{each.peak_force_N:.1f} N" in page
    for goal in result.checks:
        assert goal in page


def test_the_timeline_has_a_bar_for_each_skill() -> None:
    result = nominal("setup1")
    page = summary(result, bundled("setup1")[0])
    assert page.count("<rect") == len(result.results)
    assert "<polyline" in page


def test_skills_that_were_not_begun_are_listed() -> None:
    result = nominal("setup1")
    early = replace(result, results=result.results[:1])
    page = summary(early, bundled("setup1")[0])
    assert page.count("not begun") == len(result.skills) - 1


def test_no_label_can_write_into_the_page() -> None:
    result = nominal("setup1")
    hostile = replace(result.skills[0], label="<script>x</script>")
    page = summary(replace(result, skills=(hostile, *result.skills[1:])), bundled("setup1")[0])
    assert "<script>" not in page
    assert "&lt;script&gt;" in page
