"""Recording by lead-through at work: the workcell that runs, and its takes."""
