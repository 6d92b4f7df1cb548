"""How far the world may differ until a plan fails: right segmentations beside wrong ones.

    python tests/benchmarks/margins.py setup1 setup2 [RECORDING…] [--axes higher lower] [--plans …]

A set-up is its bundled recording, segmented as it is proposed, beside the same boundaries 0.4 s
late, as many boundaries evenly spaced, and the first two skills as one. Any other recording is
tried in the world made from it, one whose force is doubted as if it were not. Beside both stand the
plan by pose alone and all as one skill.
Prints a row of a Markdown table for each plan.
"""

import argparse
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError
from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment
from keyphase.readers import read
from keyphase.segmentation import Segmenter
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.segmentation import Segment
from keyphase.simulation.choosing import cell_for, met_by
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.replay.margin import Margin, axes_of, margin_of
from keyphase.simulation.replay.margin_plans import margin_plans
from keyphase.simulation.workcells.registry import workcell_names
from keyphase.skills.library import skills_of
from keyphase.skills.skill import Skill

LATE_S = 0.4


def proposed(segmenter: Segmenter) -> list[LabeledSegment]:
    """The plan as it is proposed."""
    labeling = label(segmenter.segment(), {}, segmenter.segment_between)
    return [labeling.segments[entry.segment] for entry in labeling.plan]


def wrong(
    segmenter: Segmenter, segments: Sequence[LabeledSegment]
) -> Mapping[str, tuple[Segment, ...]]:
    """Segmentations of the same stretch that are wrong on purpose, described as any other."""
    ends = [segment.end_s for segment in segments]
    start, end, count = segments[0].start_s, ends[-1], len(ends)
    contact = [isinstance(segment.end_condition, ContactEnd) for segment in segments]

    def between(edges: Sequence[float], contacts: Sequence[bool]) -> tuple[Segment, ...]:
        starts = [start, *edges[:-1]]
        spans = zip(starts, edges, contacts, strict=True)
        return tuple(segmenter.segment_between(*span) for span in spans)

    late = [min(one + LATE_S, end - 0.1) for one in ends[:-1]]
    even = [start + (end - start) * (i + 1) / count for i in range(count - 1)]
    return {
        f"boundaries {LATE_S} s late": between([*late, end], contact),
        "evenly spaced": between([*even, end], contact),
        "first two as one": between(ends[1:], contact[1:]),
    }


def margin_for(
    name: str, axes: Sequence[str] | None, only: Sequence[str] | None = None
) -> tuple[Demonstration, Margin]:
    """The margins of a set-up by name, or of a recording by its path; of all plans or `only` some.

    Their names are those in the table.
    """
    bundled = name in workcell_names()
    demonstration = read(shipped("data") / f"{name}.npz" if bundled else Path(name))
    cell = cell_for(demonstration, name if bundled else "recording")
    if isinstance(cell, RecordedCell) and cell.doubt is not None:
        print(f"{name}: {cell.doubt}")
        cell.doubt = None
    met = met_by(demonstration, cell)
    segmenter = Segmenter(met)
    segments = proposed(segmenter)
    plans: dict[str, Sequence[Skill]] = dict(margin_plans(met, segments))
    if bundled:
        for what, stretches in wrong(segmenter, segments).items():
            plans[what] = skills_of(met, stretches)
    plans = {what: skills for what, skills in plans.items() if not only or what in only}
    known = [axis.name for axis in axes_of(cell)]
    return met, margin_of(cell, met, plans, axes=[a for a in axes or known if a in known])


def rows(name: str, margin: Margin) -> list[str]:
    """A row for each plan: what became of it, and how far it reaches along each axis."""
    reaches = margin.plans[0].reaches
    head = ["recording", "plan", "nominal", *(f"{r.axis}, {r.unit or 'μ'}" for r in reaches)]
    lines = [" | ".join(head), " | ".join("---" for _ in head)]
    for plan in margin.plans:
        cells = [
            "—" if reach.value is None else f"{'≥ ' if reach.unbounded else ''}{reach.value:.3g}"
            for reach in plan.reaches
        ]
        lines.append(" | ".join([Path(name).stem, plan.plan, plan.nominal, *cells]))
    return [f"| {line} |" for line in lines]


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("recordings", nargs="+")
    parser.add_argument("--axes", nargs="*")
    parser.add_argument("--plans", nargs="*")
    asked = parser.parse_args()
    for name in asked.recordings:
        begun = time.monotonic()
        try:
            _, margin = margin_for(name, asked.axes, asked.plans)
        except KeyphaseError as error:
            print(f"{name}: {error}\n", flush=True)
            continue
        print(*rows(name, margin), f"({time.monotonic() - begun:.0f} s)\n", sep="\n", flush=True)


if __name__ == "__main__":
    main()
