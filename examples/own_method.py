"""A method of one's own: boundaries wherever the tool slows down to a tenth of its top speed."""

import numpy as np

import keyphase
from keyphase.files.shipped import shipped


def slow_spots(demonstration, _parameters):
    velocity = np.gradient(demonstration.position_m, demonstration.time_s, axis=0)
    slow = np.linalg.norm(velocity, axis=1) < 0.1 * np.linalg.norm(velocity, axis=1).max()
    edges = np.flatnonzero(np.diff(slow.astype(int)) > 0) + 1
    apart = edges[np.diff(demonstration.time_s[edges], prepend=-np.inf) > 0.3]
    return [keyphase.FoundBoundary(float(demonstration.time_s[i])) for i in apart if i > 1]


keyphase.register_method("slow_spots", slow_spots)
demonstration = keyphase.read(shipped("data") / "setup1.npz")
for piece in keyphase.segment(demonstration, keyphase.Parameters(variant="slow_spots")).segments:
    print(f"{piece.start_s:6.2f} to {piece.end_s:6.2f} s  {piece.label}")
