"""Segment files and other exports beside the recordings; never over a stranger's file."""
