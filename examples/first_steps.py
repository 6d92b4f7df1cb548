"""First steps: from a recording to key phases, a picture, and a segment file.

Run it as it stands, or read it with its results in `docs/first_steps.ipynb`, which is made of it:
`python tests/benchmarks/make_notebook.py`. A cell begins at each `# %%`.
"""

# %% [markdown]
# # From a recording to key phases
#
# A demonstration is one recording of a tool: where it was, and what pressed on it. The one read
# here ships with keyphase: a simulated YuMi presses a cap onto its housing and slides it to a wall.

# %%
import keyphase
from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Label

demonstration = keyphase.read(shipped("data") / "setup1.npz")
print(f"{demonstration.duration_s:.1f} s, {len(demonstration)} rows")

# %% [markdown]
# Its segments are found from position and force together. Each has a label, and a condition by
# which it is over: a contact, with its threshold, or a configuration.

# %%
segmentation = keyphase.segment(demonstration)
for piece in segmentation.segments:
    ends = type(piece.end_condition).__name__.removesuffix("End").lower()
    print(f"{piece.start_s:6.2f} to {piece.end_s:6.2f} s  {piece.label:22} ends by {ends}")

# %% [markdown]
# Every boundary says how sure it is, and why it is there.

# %%
for boundary in segmentation.boundaries[:4]:
    print(f"{boundary.time_s:6.2f} s  {boundary.confidence:4.0%}  {boundary.reasons[0].sentence}")

# %% [markdown]
# The picture has the segments above what was measured, with the path beside it.

# %%
keyphase.draw(segmentation, "first_steps.png")

# %% [markdown]
# A person's edits lie over what was found, and can be undone. The segment file holds the result,
# and what made it; `keyphase open` shows the same in the browser.

# %%
document = keyphase.Document(demonstration)
document = document.apply(Label(0.5, "reach for the cap"), keyphase.label(segmentation))
labeling = keyphase.label(segmentation, document.edits)
print(labeling.segments[0].label, "- instead of", segmentation.segments[0].label)
keyphase.write_segment_file(labeling, "first_steps.segments.json")
