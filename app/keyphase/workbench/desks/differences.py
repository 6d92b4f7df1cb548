"""Whether anything of an open recording has changed that its pages are told."""

from keyphase.workbench.desks.open_recording import OpenRecording


def differs(before: tuple[object, ...], after: tuple[object, ...]) -> bool:
    """Whether anything that is told of an open recording has changed."""
    return any(
        one is not other and (not isinstance(one, _PLAIN) or one != other)
        for one, other in zip(before, after, strict=True)
    )


_PLAIN = (bool, str, tuple, type(None))


def told_of(opened: OpenRecording) -> tuple[object, ...]:
    """All that is told of an open recording."""
    journal = opened.journal
    return (
        opened.document,
        opened.folder.settings,
        opened.labeling,
        opened.kept_labeling,
        opened.parameters,
        journal.changed,
        journal.read_only,
        journal.notices,
        journal.elsewhere,
    )
