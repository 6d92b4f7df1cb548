"""Rotations: unit quaternions w x y z and rotation vectors, the one place that computes with them.

quaternions  over arrays of any leading shape
turns        by component, for formulae that are themselves written so
courses      over time: continuous in sign, followed past half a turn and past a whole one

Files that write orientations in other ways are read with SciPy's `Rotation` (`keyphase.readers`),
and inside its own steps the simulation keeps to MuJoCo's.
"""
