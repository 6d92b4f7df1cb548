"""A segmentation as a picture for papers: its timeline with evidence, its path with ellipsoids."""

from keyphase.pictures.drawing import PICTURE_SUFFIXES, draw, picture_data

__all__ = ["PICTURE_SUFFIXES", "draw", "picture_data"]
