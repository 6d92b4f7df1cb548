"""Where edits and settings lie on disk: journal, lock, state folder, folder settings."""
