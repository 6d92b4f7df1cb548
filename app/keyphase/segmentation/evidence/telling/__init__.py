"""What is drawn and told of the evidence: reasons, numbers over a line, the track, Gaussians."""
