"""Packages of optional formats, imported when a file of theirs is met."""

from importlib import import_module
from pathlib import Path
from typing import Any

from keyphase.errors import MissingPackageError


def package(module: str, extra: str, path: Path) -> Any:
    """The module, or MissingPackageError that says how to install the extra it belongs to."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        raise MissingPackageError(
            f"{path}: reading this needs the package '{module.partition('.')[0]}', which is not "
            f'installed; install it: pip install "keyphase[{extra}]".'
        ) from error
