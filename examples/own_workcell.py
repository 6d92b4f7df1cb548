"""A workcell of one's own: setup 1 with a housing three times as heavy, replayed like any other."""

from dataclasses import replace
from pathlib import Path

import keyphase
from keyphase.files.shipped import shipped
from keyphase.simulation import register, workcell

known = workcell("setup1")


def furnish(spec, disturbance):
    known.furnish(spec, replace(disturbance, mass=3.0 * disturbance.mass))


register(replace(known, name="heavy", title="Setup 1, three times as heavy", furnish=furnish))
recording, segments = shipped("data") / "setup1.npz", Path("setup1.segments.json")
labeling = keyphase.label(keyphase.segment(keyphase.read(recording)))
keyphase.write_segment_file(labeling, segments)
print(keyphase.replay(segments, "heavy", demonstration=recording).outcome())
