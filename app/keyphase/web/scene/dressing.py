"""Light, background and theme of one page's scene.

None of it has an owner in the browser, where the last message wins: it is sent to the client of one
page only, never to all.
"""

import numpy as np
import viser

from keyphase.web.scene.palette import DARK, Theme
from keyphase.web.scene.recording.ground_shadow import SUN_M


class Dressing:
    """What surrounds whatever stands in the scene."""

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        scene = client.scene
        scene.configure_default_lights(enabled=False)
        scene.configure_environment_map(None)
        scene.add_light_ambient("/lights/ambient", intensity=2.1)
        self._sun = scene.add_light_directional(
            "/lights/sun", intensity=1.9, position=SUN_M, cast_shadow=False
        )

    def dress(self, theme: Theme) -> None:
        """Take the colours of a theme."""
        self._client.gui.configure_theme(
            dark_mode=theme is DARK, show_logo=False, show_share_button=False
        )

    def paint_sky(self, theme: Theme) -> None:
        """For a page of viser's own, whose canvas has no colour of ours behind it.

        Until an image is there all behind the scene is black, so our page does without.
        """
        sky = np.full((4, 4, 3), theme.sky, np.uint8)
        self._client.scene.set_background_image(sky, format="png")

    def cast_shadows(self, wanted: bool) -> None:
        """Whether what moves throws shadows."""
        self._sun.cast_shadow = wanted
