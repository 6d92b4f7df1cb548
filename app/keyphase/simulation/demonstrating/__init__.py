"""A demonstration made in a workcell: a scripted operator, lead-through, the recorder."""
