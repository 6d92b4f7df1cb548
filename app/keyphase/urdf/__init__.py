"""Robot descriptions as files from anywhere: checked before any library parses them."""
