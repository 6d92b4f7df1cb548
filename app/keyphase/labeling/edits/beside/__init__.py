"""Edits of what lies beside the segments: they change no boundary and no segment."""
