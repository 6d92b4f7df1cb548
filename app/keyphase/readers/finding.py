"""Which files are recordings, and which recipe reads a table."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from keyphase.errors import DemonstrationError, KeyphaseError
from keyphase.files.parts import split_part, with_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, first_bytes, read_whole
from keyphase.readers.companions import companions_among
from keyphase.readers.formats.known import Format, format_of
from keyphase.readers.known_tables import begins_known, known_header, leaves_nothing_open
from keyphase.readers.native_csv import MAX_HEADER_BYTES, has_native_header
from keyphase.readers.recipes.file import load_recipe
from keyphase.readers.recipes.fitting import is_meant_for
from keyphase.readers.recipes.presets import fitting_preset, preset_sides
from keyphase.readers.recipes.recipe import Recipe
from keyphase.readers.recipes.several import parts_of_table
from keyphase.readers.table import open_table

RECIPE_SUFFIX = ".recipe.toml"
FOLDER_RECIPE = "recipe.toml"
EXPORTS_FOLDER = "keyphase_exports"
"""Copies of recordings with their segments, which are no recordings of their own."""

_TABLE_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".log", ".asc")
_BINARY_SUFFIXES = (".hdf5", ".h5", ".zip", ".bag", ".mcap", ".mat", ".npy", ".parquet")
EXPORTED_SUFFIXES = (".segments.csv", ".segments.mcap", ".program.txt")
"""What keyphase writes beside recordings and would be read as one, if a recipe lies there."""


class Found(NamedTuple):
    """A recording and its name relative to the folder it was found in (or its own name)."""

    path: Path
    relative: Path


def find_recordings(
    paths: Iterable[Path | str], recipe: Path | str | None = None
) -> tuple[Found, ...]:
    """The recordings among files and, recursively, in folders; sorted within each, each once.

    A file that is named is taken as it is; reading it says what is wrong with it. In a folder
    count archives (.npz), native tables, and tables that have a recipe: their own, their folder's,
    or the one given for all; not the wrench of another one in a file of its own, nor notes in
    prose. Hidden folders and files and what was exported are passed over, links to folders not
    followed. No more of a file than its first lines is read. Raises DemonstrationError for a folder
    that cannot be listed.
    """
    found: dict[str, Found] = {}
    for path in map(Path, paths):
        for recording in _found(path, recipe):
            found.setdefault(os.path.abspath(recording.path), recording)
    return tuple(found.values())


def _found(path: Path, recipe: Path | str | None) -> Iterator[Found]:
    if not os.path.isdir(path) or format_of(path) is not None:
        yield from _parts(Found(path, Path(path.name)), recipe)
        return
    for recording in _in_folder(path, recipe):
        yield from _parts(recording, recipe)


def _parts(recording: Found, recipe: Path | str | None) -> Iterator[Found]:
    """Each recording of a file that holds many; the file itself where it is one, or unreadable."""
    path, relative = recording
    try:
        names = parts_of(path, recipe)
    except Exception:
        # Reading it says what is wrong, be it a defect; the others are found all the same.
        names = ()
    if not names:
        yield recording
    for name in names:
        yield Found(with_part(path, name), with_part(relative, name))


def parts_of(path: Path, recipe: Recipe | Path | str | None = None) -> tuple[str, ...]:
    """The recordings in a file or dataset that holds many, or none where it is one.

    Raises DemonstrationError and RecipeError for what cannot be read.
    """
    form = format_of(path)
    chosen = recipe or own_recipe(path) or folder_recipe(path)
    if form is not None:
        inner = form.parts(path)
        sides = _sides(path, form, inner[0] if inner else None, chosen)
        if not sides:
            return inner
        return tuple(f"{one}+{side}" for one in inner for side in sides) or sides
    if chosen is None or split_part(path)[1] is not None or not os.path.isfile(path):
        return ()
    loaded = _loaded(chosen)
    if loaded.split is None:
        return tuple(loaded.parts)
    file = read_whole(path, DEFAULT_LIMIT_BYTES)
    return parts_of_table(
        open_table(file.name, file.data, loaded.table, DEFAULT_LIMIT_BYTES), loaded
    )


def arms_beside(path: Path, recipe: Recipe | Path | str | None = None) -> tuple[Path, ...]:
    """The other tools that were recorded at the same time, in the same rows: of `run.csv#left` it
    is `run.csv#right`, of `a.hdf5#demo_3+left` it is `a.hdf5#demo_3+right`.

    Raises DemonstrationError and RecipeError for what cannot be read.
    """
    file, part = split_part(path)
    if part is None:
        return ()
    inner, plus, side = part.rpartition("+")
    form, chosen = format_of(file), recipe or own_recipe(file) or folder_recipe(file)
    if form is None:
        sides = tuple(_loaded(chosen).parts) if chosen else ()
        side, before = part, ""
    else:
        sides = _sides(file, form, inner or None, chosen)
        before = f"{inner}{plus}"
    if side not in sides:
        return ()
    return tuple(with_part(file, f"{before}{other}") for other in sides if other != side)


def _sides(
    path: Path, form: Format, inner: str | None, recipe: Recipe | Path | str | None
) -> tuple[str, ...]:
    """The tools side by side in one recording of a format, by its recipe or its preset."""
    if recipe is not None:
        return tuple(_loaded(recipe).parts)
    return preset_sides(form.names(path, inner))


def _loaded(recipe: Recipe | Path | str) -> Recipe:
    return recipe if isinstance(recipe, Recipe) else load_recipe(recipe)


def own_recipe(path: Path) -> Path | None:
    """The recipe of the one table at `path`, `<file>.recipe.toml`, where it is there."""
    recipe = path.with_name(path.name + RECIPE_SUFFIX)
    return recipe if os.path.isfile(recipe) else None


def folder_recipe(path: Path) -> Path | None:
    """The `recipe.toml` of the folder of `path`, where it is there and can be meant for it."""
    recipe = path.with_name(FOLDER_RECIPE)
    return recipe if os.path.isfile(recipe) and not _is_for_others(recipe, path) else None


def passed_over_recipe(path: Path) -> Path | None:
    """The recipe of its folder, where a file is read by a preset since that names other columns."""
    recipe = path.with_name(FOLDER_RECIPE)
    return recipe if os.path.isfile(recipe) and folder_recipe(path) is None else None


def _is_for_others(recipe: Path, path: Path) -> bool:
    """Whether its columns are not those of a file that a preset reads without anything to say."""
    try:
        form = format_of(path)
        names = known_header(path) if form is None else _known_columns(form, path)
        return bool(names) and not is_meant_for(load_recipe(recipe), names)
    except KeyphaseError:
        # Reading it says what is wrong.
        return False


def _known_columns(form: Format, path: Path) -> tuple[str, ...]:
    """The columns of a file, where a preset knows them and leaves nothing open."""
    names = form.names(path, next(iter(form.parts(path)), None))
    return names if leaves_nothing_open(fitting_preset(names)) else ()


def undescribed_alike(path: Path, folder: Path) -> tuple[Path, ...]:
    """Files right in a folder that nobody has said how to read and that are of the format of
    `path`, sorted.
    """
    form = format_of(path)
    try:
        paths = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    except OSError:
        return ()
    if form is not None:
        alike = [one for one in paths if one.suffix == path.suffix and format_of(one) is form]
        return tuple(one for one in alike if not (own_recipe(one) or folder_recipe(one)))
    return tuple(
        path
        for path in paths
        if path.name.lower().endswith(_TABLE_SUFFIXES)
        and not path.name.endswith(EXPORTED_SUFFIXES)
        and path.is_file()
        and not _is_recording(path, recipe_given=False)
    )


def begins_native(path: Path) -> bool:
    """Whether a file begins with the header of a native table; reads no more of it than that."""
    try:
        return has_native_header(first_bytes(path, MAX_HEADER_BYTES))
    except (OSError, ValueError):
        return False


def _in_folder(folder: Path, recipe: Path | str | None) -> Iterator[Found]:
    paths, shut = [], list[Path]()

    def pass_over(error: OSError) -> None:
        if Path(error.filename) == folder:
            _refuse(error)
        shut.append(Path(error.filename))

    for parent, folders, files in os.walk(folder, onerror=pass_over):
        folders[:] = [one for one in folders if one != EXPORTS_FOLDER and not one.startswith(".")]
        datasets = [name for name in folders if format_of(Path(parent, name)) is not None]
        folders[:] = [name for name in folders if name not in datasets]
        paths += [Path(parent, name) for name in datasets]
        paths += [Path(parent, name) for name in files if not name.startswith(".")]
    beside = companions_among(
        paths, lambda path: Path(recipe) if recipe else own_recipe(path) or folder_recipe(path)
    )
    paths = [path for path in paths if path not in beside]
    for path in sorted([*paths, *shut], key=lambda path: path.relative_to(folder).parts):
        if os.path.isdir(path) or (
            os.path.isfile(path) and _is_recording(path, recipe is not None)
        ):
            yield Found(path, path.relative_to(folder))


def _refuse(error: OSError) -> None:
    raise DemonstrationError(
        f"{error.filename}: the folder cannot be listed ({error.strerror}); check its permissions."
    ) from error


def _is_recording(path: Path, recipe_given: bool) -> bool:
    name = path.name.lower()
    if name.endswith(EXPORTED_SUFFIXES):
        return False
    if name.endswith(".npz"):
        return True
    if name.endswith(_BINARY_SUFFIXES):
        return format_of(path) is not None
    if not name.endswith(_TABLE_SUFFIXES):
        return False
    return bool(
        recipe_given
        or own_recipe(path)
        or folder_recipe(path)
        or begins_native(path)
        or begins_known(path)
    )
