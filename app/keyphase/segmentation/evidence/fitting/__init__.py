"""Fits the weights from demonstrations whose truth is known."""
