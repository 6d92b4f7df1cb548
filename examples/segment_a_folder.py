"""Segment every recording of a folder and print its phases: `python segment_a_folder.py FOLDER`."""

import sys
from pathlib import Path

import keyphase

for recording in sorted(Path(sys.argv[1]).glob("*.npz")):
    segmentation = keyphase.segment(keyphase.read(recording))
    keyphase.write_segment_file(
        keyphase.label(segmentation), Path(f"{recording.stem}.segments.json")
    )
    for piece in segmentation.segments:
        print(f"{recording.stem}: {piece.start_s:6.2f} to {piece.end_s:6.2f} s  {piece.label}")
