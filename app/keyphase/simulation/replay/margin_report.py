"""A margin in words, as JSON values, and as a picture."""

from collections.abc import Iterator, Sequence
from html import escape
from typing import Any

from keyphase.simulation.replay.margin import Margin, PlanMargin, Reach

OPPOSITE = {"higher": "lower", "towards the tool": "away from it"}
"""Axes that are told as one range."""

_LINE_COLORS = ("#1098ad", "#f08c00", "#868e96")
WIDTH, ROW, LEFT, SCALE = 960, 30, 330, 9.0
_INK, _FAINT = "#343a40", "#dee2e6"


def margin_verdict(margin: Margin) -> str:
    """The first plan's range beside the others': "works from −20 to +20 mm; by pose alone …"."""
    first, *others = margin.plans
    said = [f"works {_range(first)}" if _works(first) else f"does not work: {first.nominal}"]
    said += [f"{each.plan} {_range(each) if _works(each) else 'not at all'}" for each in others]
    return "; ".join(said)


def margin_text(margin: Margin) -> str:
    """A table, one row a plan; the verdict comes last."""
    names = [reach.axis for reach in margin.plans[0].reaches]
    width = max(len(each.plan) for each in margin.plans)
    columns = [max(len(name), 8) for name in names]
    head = "  ".join(f"{name:>{wide}}" for name, wide in zip(names, columns, strict=True))
    lines = [f"{'':{width}}  {head}"]
    for each in margin.plans:
        cells = [f"{_value(reach):>{w}}" for reach, w in zip(each.reaches, columns, strict=True)]
        lines.append(f"{each.plan:{width}}  {'  '.join(cells)}")
    lines += [f"{each.plan}: {each.nominal}" for each in margin.plans if not _works(each)]
    return "\n".join([*lines, margin_verdict(margin)])


def margin_values(margin: Margin) -> dict[str, Any]:
    """The same as JSON values."""
    return {
        "workcell": margin.workcell,
        "plans": [
            {
                "plan": each.plan,
                "nominal": each.nominal,
                "reaches": [
                    {
                        "axis": reach.axis,
                        "unit": reach.unit,
                        "value": reach.value,
                        "unbounded": reach.unbounded,
                        "failed": reach.failed,
                    }
                    for reach in each.reaches
                ],
            }
            for each in margin.plans
        ],
        "verdict": margin_verdict(margin),
    }


def margin_svg(margin: Margin, title: str) -> str:
    """A bar for each plan along each axis, as long as it reaches; an arrow where it goes on."""
    reaches = margin.plans[0].reaches
    height = 96 + len(reaches) * (ROW * len(margin.plans) * 0.5 + 22)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}" '
        f'width="{WIDTH}" height="{height:.0f}" font-family="system-ui, sans-serif">',
        f'<rect width="{WIDTH}" height="{height:.0f}" fill="#ffffff"/>',
        _text(24, 28, title, "600", 16),
        _text(24, 50, margin_verdict(margin)),
    ]
    y = 84.0
    for index in range(len(reaches)):
        parts += _axis(margin.plans, index, y)
        y += ROW * len(margin.plans) * 0.5 + 22
    return "\n".join([*parts, "</svg>"]) + "\n"


def _axis(plans: Sequence[PlanMargin], index: int, top: float) -> Iterator[str]:
    yield _text(24, top + 12, plans[0].reaches[index].axis, "600")
    for row, plan in enumerate(plans):
        reach, y = plan.reaches[index], top + row * ROW * 0.5
        long = _length(reach)
        color = _LINE_COLORS[row % len(_LINE_COLORS)]
        yield _text(150, y + 11, plan.plan, size=11)
        yield _bar(LEFT, y + 2, max(long, 1.5), color)
        yield _text(LEFT + long + 10, y + 11, _value(reach), size=11)


def _bar(x: float, y: float, wide: float, color: str) -> str:
    return f'<rect x="{x:.1f}" y="{y:.1f}" width="{wide:.1f}" height="10" fill="{color}"/>'


def _length(reach: Reach) -> float:
    if reach.value is None:
        return 0.0
    return SCALE * (reach.value if reach.unit else 20.0 * (reach.value - 0.3))


def _works(plan: PlanMargin) -> bool:
    return plan.nominal == "success"


def _range(plan: PlanMargin) -> str:
    """From how far lower to how far higher, or nearer and further, with the other axes left out."""
    by_name = {reach.axis: reach for reach in plan.reaches}
    for up, down in OPPOSITE.items():
        if up in by_name and down in by_name:
            low, high = by_name[down], by_name[up]
            return f"from −{_number(low)} to +{_number(high)} {high.unit}"
    return "in the nominal world"


def _value(reach: Reach) -> str:
    if reach.value is None:
        return "–"
    return f"{_number(reach)}{'+' if reach.unbounded else ''} {reach.unit}".strip()


def _number(reach: Reach) -> str:
    assert reach.value is not None
    return f"{reach.value:.0f}" if reach.unit else f"{reach.value:.1f}"


def _text(x: float, y: float, text: str, weight: str = "400", size: int = 13) -> str:
    plain = "".join(c if c.isprintable() else " " for c in text)
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-weight="{weight}" font-size="{size}" '
        f'fill="{_INK}">{escape(plain)}</text>'
    )
