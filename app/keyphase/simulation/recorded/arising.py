"""Surfaces that come to stand where the tool already is: each stands before it, not around it.

A recording tells of a surface from the moment on at which its way there was no longer behind it. A
tool that comes from behind, or that a nearer surface would have met before, is inside it by then;
thrown out of it, it would feel a force that nothing in the recording is the cause of.
"""


class Arising:
    """How far each surface, by its index, stands back for the tool that it found in its place."""

    def __init__(self) -> None:
        self._back_m = dict[int, float]()

    def absent(self, index: int) -> None:
        """It is out of the tool's way: it may come to stand anew."""
        self._back_m.pop(index, None)

    def back_m(self, index: int, depth_m: float, pressed_m: float) -> float:
        """How far a surface stands back along its normal [m].

        The tool is `depth_m` inside it, of which `pressed_m` were recorded. It was found so as the
        surface came to stand; as it comes out, the surface follows it, and gives way no more.
        """
        beyond_m = max(depth_m - pressed_m, 0.0)
        self._back_m[index] = min(self._back_m.get(index, beyond_m), beyond_m)
        return self._back_m[index]
