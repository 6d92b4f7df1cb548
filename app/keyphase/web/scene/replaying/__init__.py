"""What takes the scene over: a replay, or a workcell that is led by hand."""
