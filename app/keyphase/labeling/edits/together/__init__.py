"""Edits that are made in many recordings of a folder together, and taken back together."""
