"""Segments made executable: movement primitives with end conditions."""
