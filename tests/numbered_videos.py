"""Small videos whose every frame carries its number as sixteen light or dark blocks."""

from fractions import Fraction
from pathlib import Path

import av
import numpy as np
from numpy.typing import NDArray

WIDTH, HEIGHT = 256, 144
BLOCK = 32
"""Edge of a block [px]; eight in a row, two rows, the lowest bit first, at the upper left."""

# Faster presets leave out what changes in every other frame.
LIKE_LEROBOT = ("libsvtav1", {"preset": "8", "crf": "30", "svtav1-params": "keyint=2:lp=1"})
H264_LIKE_LEROBOT = ("libx264", {"preset": "veryfast", "g": "2", "crf": "30", "threads": "1"})
H264 = ("libx264", {"preset": "veryfast", "g": "250", "threads": "1"})

READ_NUMBER = """(video) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [256, 144];
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(video, 0, 0, 256, 144);
  let number = 0;
  for (let bit = 0; bit < 16; bit++) {
    const [x, y] = [(bit % 8) * 32 + 16, (bit >> 3) * 32 + 16];
    if (context.getImageData(x, y, 1, 1).data[1] > 128) number |= 1 << bit;
  }
  return number;
}"""
"""A script's function of a video element: the number its picture carries."""


def picture(number: int) -> NDArray[np.uint8]:
    """The frame of that number (H, W, 3); below the blocks something moves."""
    pixels = np.full((HEIGHT, WIDTH, 3), 40, dtype=np.uint8)
    for bit in range(16):
        row, column = BLOCK * (bit // 8), BLOCK * (bit % 8)
        pixels[row : row + BLOCK, column : column + BLOCK] = 230 if number >> bit & 1 else 20
    x = number * 3 % WIDTH
    pixels[80:130, x : x + 24] = (200, 120, 40)
    return pixels


def read_number(pixels: NDArray[np.uint8]) -> int:
    """The number that a frame (H, W, 3) carries."""
    bits = (
        int(pixels[BLOCK * (b // 8) + 16, BLOCK * (b % 8) + 16, 1] > 128) << b for b in range(16)
    )
    return sum(bits)


def write_video(
    path: Path,
    frames: int,
    fps: float = 30.0,
    first: int = 0,
    codec: tuple[str, dict[str, str]] = H264,
    size: tuple[int, int] = (WIDTH, HEIGHT),
) -> Path:
    """A video of frames numbered from `first`; the file's ending says in which container."""
    name, options = codec
    rate = Fraction(fps).limit_denominator(1001)
    with av.open(str(path), "w") as output:
        stream = output.add_stream(name, rate=rate, options=dict(options))
        stream.width, stream.height, stream.pix_fmt = *size, "yuv420p"
        for number in range(first, first + frames):
            frame = av.VideoFrame.from_ndarray(picture(number), format="rgb24")
            frame = frame.reformat(*size, "yuv420p")
            frame.pts, frame.time_base = number - first, 1 / rate
            output.mux(stream.encode(frame))
        output.mux(stream.encode())
    return path


def numbers_in(path: Path) -> list[int]:
    """The numbers that the frames of a video carry."""
    with av.open(str(path)) as video:
        frames = (one.reformat(WIDTH, HEIGHT, "rgb24") for one in video.decode(video=0))
        return [read_number(one.to_ndarray()) for one in frames]
