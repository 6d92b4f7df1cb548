"""What a tool that nobody subtracted shows: its weight as it turns, its inertia as it moves."""

from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.speed import Speed
from keyphase.segmentation.evidence.tool.inertia import without_inertia
from keyphase.segmentation.evidence.tool.weight import without_weight


def without_tool(grid: Grid, speed: Speed) -> Grid:
    """The grid with the tool's weight and inertia taken out of its wrench, where they show."""
    return without_inertia(without_weight(grid), speed)
