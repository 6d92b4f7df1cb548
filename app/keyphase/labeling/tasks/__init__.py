"""Tasks of a folder: the ordered phases that its recordings go through."""
