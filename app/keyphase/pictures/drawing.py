"""One picture of a labeling: the timeline, the path, or both."""

import io
from pathlib import Path
from typing import Any, Literal

from keyphase.errors import ExportError, MissingPackageError
from keyphase.files.writing import write_whole
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.pictures.path import draw_path
from keyphase.pictures.timeline import HEIGHTS, draw_timeline, rows_of
from keyphase.segmentation.segmentation import Segmentation

PICTURE_SUFFIXES = (".svg", ".pdf", ".png")

What = Literal["both", "timeline", "path"]


def draw(
    segmented: Labeling | Segmentation, path: Path | str | None = None, what: What = "both"
) -> Any:
    """The matplotlib figure of a segmentation or labeling, written to `path` where one is given.

    Above are the segments, below them position, force and the evidence, with a line at each
    boundary (whole where contact changes, dashed where motion does); beside them the path with the
    ellipsoids of the mixture at one standard deviation. The same input gives the same bytes.

    Raises MissingPackageError without matplotlib, ExportError for a path that does not end in .svg,
    .pdf or .png, or that cannot be written.
    """
    labeling = label(segmented) if isinstance(segmented, Segmentation) else segmented
    figure = _figure(labeling, what)
    if path is not None:
        write_whole(Path(path), picture_data(figure, Path(path)), ExportError)
    return figure


def picture_data(figure: Any, path: Path) -> bytes:
    """What the file of a figure holds that is named as `path` is.

    The same figure gives the same bytes. Raises ExportError for another ending than .svg, .pdf or
    .png.
    """
    suffix = path.suffix.lower()
    if suffix not in PICTURE_SUFFIXES:
        raise ExportError(f"{path}: expected a picture named *{', *'.join(PICTURE_SUFFIXES)}.")
    from matplotlib import rc_context

    dates = {".svg": {"Date": None}, ".pdf": {"CreationDate": None, "ModDate": None}}
    file = io.BytesIO()
    # Ids in an SVG are random without a salt.
    with rc_context({"svg.hashsalt": "keyphase", "pdf.fonttype": 42}):
        figure.savefig(file, format=suffix[1:], dpi=150, metadata=dates.get(suffix))
    return file.getvalue()


def _figure(labeling: Labeling, what: What) -> Any:
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingPackageError(
            "A picture needs the package 'matplotlib', which is not installed; "
            'pip install "keyphase[pictures]".'
        ) from error
    rows = rows_of(labeling.segmentation)
    heights = [HEIGHTS[("segments", "position", "force", "evidence").index(row)] for row in rows]
    widths = {"both": (13.0, 2.4), "timeline": (9.0, 0.0), "path": (5.0, 1.0)}[what]
    tall = 1.05 * sum(heights) + 0.9 if what != "path" else 4.6
    figure: Any = Figure(figsize=(widths[0], max(tall, 3.4)), layout="constrained")
    FigureCanvasAgg(figure)
    if what == "path":
        draw_path(figure.add_subplot(projection="3d"), labeling)
        return figure
    grid = figure.add_gridspec(
        len(rows),
        2 if what == "both" else 1,
        height_ratios=heights,
        width_ratios=(4.2, 2.0) if what == "both" else (1.0,),
    )
    first = figure.add_subplot(grid[0, 0])
    below = [figure.add_subplot(grid[i, 0], sharex=first) for i in range(1, len(rows))]
    draw_timeline([first, *below], labeling)
    if what == "both":
        draw_path(figure.add_subplot(grid[:, 1], projection="3d"), labeling)
    return figure
