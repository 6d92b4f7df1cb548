"""Every format that segments can be written in, by name."""

from keyphase.errors import ExportError
from keyphase.writers.elan import ELAN
from keyphase.writers.hdf5.mimicgen import MIMICGEN
from keyphase.writers.hdf5.reassemble import REASSEMBLE
from keyphase.writers.hdf5.robomimic import ROBOMIMIC
from keyphase.writers.label_studio import LABEL_STUDIO
from keyphase.writers.lerobot.labels import LEROBOT
from keyphase.writers.lerobot.tasks import LEROBOT_TASKS
from keyphase.writers.mcap_file import MCAP
from keyphase.writers.own_files import CSV, JSON
from keyphase.writers.plans import BEHAVIOR_TREE, PROGRAM, RAPID, SKILLS, URSCRIPT
from keyphase.writers.rerun_file import RERUN
from keyphase.writers.writer import Writer

WRITERS: tuple[Writer, ...] = (
    JSON,
    CSV,
    SKILLS,
    BEHAVIOR_TREE,
    PROGRAM,
    URSCRIPT,
    RAPID,
    LEROBOT,
    LEROBOT_TASKS,
    ROBOMIMIC,
    MIMICGEN,
    REASSEMBLE,
    ELAN,
    LABEL_STUDIO,
    RERUN,
    MCAP,
)
"""In the order in which they are offered."""


def writer_named(name: str) -> Writer:
    """The writer of that name. Raises ExportError for a name that is none."""
    found = next((writer for writer in WRITERS if writer.name == name), None)
    if found is None:
        names = ", ".join(writer.name for writer in WRITERS)
        raise ExportError(f"Expected a format among {names}, but got {name[:80]!r}.")
    return found
