"""Edits of a stretch of time, whatever segments there are in it."""
