"""Where the files that travel with keyphase are, in a checkout and in an installation alike."""

from pathlib import Path

from keyphase.errors import KeyphaseError


def shipped(kind: str) -> Path:
    """Folder of shipped files: `kind` is "data" or "static_robots".

    In a wheel they lie inside the package, in a checkout at its top level.

    Raises KeyphaseError where neither exists, which means a broken installation.
    """
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "_shipped" / kind, package.parent.parent / kind):
        if folder.is_dir():
            return folder
    raise KeyphaseError(
        f"The folder '{kind}' that comes with keyphase is missing beside {package}; "
        "install keyphase again."
    )
