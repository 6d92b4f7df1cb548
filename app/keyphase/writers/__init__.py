"""Segments out, into other people's files: a writer for each format, what it carries, and `write`.

What a format cannot carry is known before it is written: `planned_export(…).not_carried`.
"""

from keyphase.writers.exporting import PlannedExport, PlannedFile, planned_export
from keyphase.writers.offers import Offer, offers
from keyphase.writers.registry import WRITERS, writer_named
from keyphase.writers.segmented import SegmentedRecording, found_segment_files
from keyphase.writers.writer import Options, Writer

__all__ = [
    "WRITERS",
    "Offer",
    "Options",
    "PlannedExport",
    "PlannedFile",
    "SegmentedRecording",
    "Writer",
    "found_segment_files",
    "offers",
    "planned_export",
    "writer_named",
]
