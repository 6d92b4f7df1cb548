"""The paper's method, whole: position mixture, normalized error and its peaks, combination."""
