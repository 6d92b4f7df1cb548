"""A score as a table for people and as JSON for machines."""

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from keyphase.scoring.calibration import SURE, Calibration
from keyphase.scoring.counting import Tally
from keyphase.scoring.score import RecordingScore, Score, unjudged_per_minute

_COLUMNS = ("F1", "precision", "recall", "found", "missed", "false", "unjudged/min", "timing ms")
_BESIDE = ("strict F1", "covering")


def as_json(score: Score) -> str:
    """Everything, for machines; null where a figure is undefined.

    The figures of a recording or set are the strict ones; the judged ones are under `judged`.
    """
    of_sets = score.calibration_of_sets
    content = {
        "macro_f1": score.macro_f1,
        "judged_macro_f1": score.judged_macro_f1,
        "calibration": _calibration(score.calibration),
        "sets": {
            name: {
                **_figures(score.sets[name]),
                "judged": _judged(score.judged_sets[name], group),
                "kinds": {kind: _figures(each) for kind, each in score.kinds(name).items()},
                "calibration": _calibration(of_sets[name]),
            }
            for name, group in score.grouped.items()
        },
        "recordings": {
            each.key: {
                **_figures(each.tally),
                "covering": each.covering,
                "judged": _judged(each.judged.tally, [each]),
            }
            for each in score.recordings
        },
        "missing": list(score.missing),
    }
    return json.dumps(content, indent=1, ensure_ascii=False)


def as_table(score: Score) -> str:
    """Tables for people: recordings, sets, kinds where they are told, and the calibration."""
    names = [each.key for each in score.recordings] + list(score.grouped)
    width = max(len("recording"), *map(len, names))
    lines = [_header("recording", width)]
    for each in score.recordings:
        beside = [_shown(each.tally.f1), _shown(each.covering)]
        lines.append(_line(each.key, each.judged.tally, [each], beside, width))
    lines += ["", _header("set", width)]
    for name, group in score.grouped.items():
        beside = [_shown(score.sets[name].f1), "–"]
        lines.append(_line(name, score.judged_sets[name], group, beside, width))
    lines += _kinds(score, width)
    lines += ["", f"macro F1 over sets with events: {_shown(score.judged_macro_f1)} judged, "]
    lines[-1] += f"{_shown(score.macro_f1)} strict"
    lines += _calibration_lines(score)
    if score.missing:
        lines.append(f"without a segment file: {', '.join(score.missing)}")
    return "\n".join(lines)


def _kinds(score: Score, width: int) -> list[str]:
    lines = []
    for name in score.grouped:
        for kind, tally in score.kinds(name).items():
            cells = [tally.f1, tally.precision, tally.recall]
            counts = f"{tally.found:>11}{tally.missed:>11}{tally.false:>11}"
            shown = "".join(f"{_shown(cell):>11}" for cell in cells)
            lines.append(f"{name:<{width}}  {kind:<8}{shown}{counts}")
    if not lines:
        return []
    heads = "".join(f"{head:>11}" for head in _COLUMNS[:6])
    return ["", f"{'set':<{width}}  {'kind':<8}{heads}", *lines]


def _calibration_lines(score: Score) -> list[str]:
    whole = score.calibration
    if whole.error is None:
        return ["no boundary was judged, so nothing can be said of confidences"]
    lines = [
        f"confidences of {whole.count} judged boundaries: expected calibration error "
        f"{whole.error:.3f}; {whole.sure_right} of {whole.sure} given with {SURE} or more are right"
    ]
    for each in whole.bins:
        lines.append(
            f"  {each.low:.1f} to {each.high:.1f}: {each.count:5d} given, mean confidence "
            f"{each.confidence:.2f}, {each.right:.2f} right"
        )
    return lines


def _judged(tally: Tally, group: Sequence[RecordingScore]) -> dict[str, Any]:
    return {**_figures(tally), "unjudged_per_minute": unjudged_per_minute(group)}


def _figures(tally: Tally) -> dict[str, Any]:
    return {
        "precision": tally.precision,
        "recall": tally.recall,
        "f1": tally.f1,
        "timing_error_s": tally.timing_error_s,
        "found": tally.found,
        "missed": tally.missed,
        "false": tally.false,
        "ignored": tally.ignored,
    }


def _calibration(calibration: Calibration) -> dict[str, Any]:
    return {
        "boundaries": calibration.count,
        "expected_calibration_error": calibration.error,
        "sure": calibration.sure,
        "sure_right": calibration.sure_right,
        "bins": [asdict(each) for each in calibration.bins],
    }


def _header(first: str, width: int) -> str:
    heads = "".join(f"{name:>{_wide(name)}}" for name in (*_COLUMNS, *_BESIDE))
    return f"{first:<{width}}{heads}"


def _line(
    name: str, tally: Tally, group: Sequence[RecordingScore], beside: Sequence[str], width: int
) -> str:
    timing = None if tally.timing_error_s is None else f"{1e3 * tally.timing_error_s:.0f}"
    cells = [
        _shown(tally.f1),
        _shown(tally.precision),
        _shown(tally.recall),
        str(tally.found),
        str(tally.missed),
        str(tally.false),
        f"{unjudged_per_minute(group):.1f}",
        timing or "–",
        *beside,
    ]
    heads = (*_COLUMNS, *_BESIDE)
    shown = "".join(f"{c:>{_wide(h)}}" for c, h in zip(cells, heads, strict=True))
    return f"{name:<{width}}{shown}"


def _wide(head: str) -> int:
    return max(9, len(head)) + 2


def _shown(value: float | None) -> str:
    return "–" if value is None else f"{value:.3f}"
