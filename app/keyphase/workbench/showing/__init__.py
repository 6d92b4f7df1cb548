"""What is shown of a recording at work: curves, reasons, comparisons, doubts."""
