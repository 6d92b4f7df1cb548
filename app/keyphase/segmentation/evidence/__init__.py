"""One probability for every boundary: candidates, their evidence, and the choice among them."""
