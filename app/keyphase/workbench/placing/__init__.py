"""A robot beside a recording: where it stands, and how it must move."""
