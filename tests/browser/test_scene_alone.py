"""viser draws the scene and nothing else: the page has the controls."""

from driver import KeyphasePage

_SHOWN = """() => [...document.querySelectorAll("button, input, select, a, [role=alert]")]
  .filter(node => node.checkVisibility()).map(node => node.outerHTML.slice(0, 120))"""


def test_nothing_of_visers_own_is_seen(setup1: KeyphasePage) -> None:
    page = setup1
    scene = page.wait_for_scene()
    page.picture("scene_alone")
    assert scene.evaluate(_SHOWN) == []
