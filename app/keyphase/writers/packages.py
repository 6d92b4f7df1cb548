"""Packages of optional formats, imported when something is written in them."""

from importlib import import_module
from typing import Any

from keyphase.errors import MissingPackageError


def package(module: str, extra: str) -> Any:
    """The module, or MissingPackageError that says how to install the extra it belongs to."""
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        raise MissingPackageError(
            f"Writing this needs the package '{module.partition('.')[0]}', which is not installed; "
            f'install it: pip install "keyphase[{extra}]".'
        ) from error
