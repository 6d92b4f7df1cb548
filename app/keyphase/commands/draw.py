"""The command `keyphase draw`: a segmentation as a picture for papers."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import tyro

from keyphase.commands.saying import say
from keyphase.errors import ExportError
from keyphase.segmentation.parameters import Parameters


@dataclass(frozen=True)
class DrawSegmentation:
    """Draw a recording's segments, or those of a segment file, as SVG, PDF or PNG."""

    path: tyro.conf.Positional[Path]
    """A recording, which is segmented, or a segment file."""
    output: Path
    """The picture: *.svg, *.pdf or *.png."""
    recipe: Path | None = None
    """How to read a table that is not in keyphase's own form (TOML)."""
    what: Literal["both", "timeline", "path"] = "both"
    """The timeline with the evidence, the path with its ellipsoids, or both."""
    parameters: tyro.conf.OmitArgPrefixes[Parameters] = field(default_factory=Parameters)
    """Of a recording; a segment file has its own."""
    replace: bool = False
    """Replace a file in the way that keyphase did not write, or that was changed since."""

    def run(self) -> int:
        """Draw, and name the picture."""
        from keyphase.commands.putting import put
        from keyphase.labeling.label import label
        from keyphase.labeling.segment_file import SUFFIX
        from keyphase.pictures import draw, picture_data
        from keyphase.readers import read
        from keyphase.segmentation import segment
        from keyphase.writers import SegmentedRecording

        if self.path.name.endswith(SUFFIX):
            item = SegmentedRecording.of_file(self.path, recipe=self.recipe)
            labeling = item.labeling()
        else:
            labeling = label(segment(read(self.path, self.recipe), self.parameters))
        picture = picture_data(draw(labeling, what=self.what), self.output)
        put(self.output, picture, self.path.name, replace=self.replace, refusal=ExportError)
        say(self.output)
        return 0
