"""All cameras of a recording, wherever its videos are."""

from collections.abc import Callable, Iterator
from pathlib import Path

from keyphase.cameras.beside import videos_beside
from keyphase.cameras.camera import Camera, Footage, Stretch
from keyphase.cameras.container import PLAYED, Video, looked_at
from keyphase.cameras.encoding import converted
from keyphase.cameras.in_bags import videos_in_bag
from keyphase.cameras.in_hdf5 import videos_in_hdf5
from keyphase.cameras.in_lerobot import videos_in_lerobot
from keyphase.cameras.kept import Kept
from keyphase.errors import CameraError, KeyphaseError
from keyphase.files.parts import split_part
from keyphase.readers.formats.known import BAG, HDF5, LEROBOT, format_of


def _untold(_share: float) -> None:
    return


def footage_of(
    recording: Path,
    start_s: float,
    *,
    kept: Kept | None = None,
    tell: Callable[[float], None] = _untold,
) -> Footage:
    """The cameras of a recording that begins at `start_s` [s], as its signals are read.

    What a browser cannot play is made playable once, in the user's cache; `tell` hears how far that
    is. Nothing is raised for a video that cannot be shown: it is among `refused` with the reason.
    """
    kept = kept or Kept()
    cameras: dict[str, Camera] = {}
    refused: list[str] = []
    for source in (_in_recording, _beside):
        try:
            for stretch in source(recording, start_s, kept, tell):
                try:
                    camera = _camera(stretch, start_s, kept)
                    cameras.setdefault(camera.name, camera)
                except KeyphaseError as error:
                    refused.append(str(error))
        except KeyphaseError as error:
            refused.append(str(error))
    return Footage(tuple(cameras.values()), tuple(refused))


def _beside(
    recording: Path, _start_s: float, _kept: Kept, _tell: Callable[[float], None]
) -> Iterator[Stretch]:
    return videos_beside(recording)


def _in_recording(
    recording: Path, start_s: float, kept: Kept, tell: Callable[[float], None]
) -> Iterator[Stretch]:
    """The videos that the format itself has or names."""
    file, part = split_part(recording)
    episode = part.partition("+")[0] if part else None
    form = format_of(file)
    if form is LEROBOT:
        yield from videos_in_lerobot(file, episode)
    elif form is HDF5:
        yield from videos_in_hdf5(file, episode, start_s, kept)
    elif form is BAG:
        yield from videos_in_bag(file, kept, tell)


def _camera(stretch: Stretch, start_s: float, kept: Kept) -> Camera:
    """The camera of a video that was found. Raises CameraError where it cannot be shown."""
    file, video = stretch.file, looked_at(stretch.file)
    if video.codec not in PLAYED:
        file = kept.made(file, "played", lambda to: converted(stretch.file, video, to))
        video = looked_at(file)
    return Camera(
        stretch.name,
        file,
        video.media_type,
        video.fps,
        _frames(stretch, video),
        stretch.from_s,
        start_s if stretch.begins_s is None else stretch.begins_s,
        video.width,
        video.height,
    )


def _frames(stretch: Stretch, video: Video) -> int:
    first = round(stretch.from_s * video.fps)
    last = video.frames if stretch.to_s is None else round(stretch.to_s * video.fps)
    count = min(last, video.frames) - first
    if count < 1:
        raise CameraError(
            f"{stretch.file}: the recording's part, from {stretch.from_s:.3f} s, lies behind the "
            f"end of the video at {video.frames / video.fps:.3f} s."
        )
    return count
