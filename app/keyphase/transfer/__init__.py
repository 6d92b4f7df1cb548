"""From finished recordings to the others of the same task: boundaries and names."""
