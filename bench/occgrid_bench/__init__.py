"""The benchmark: ports, baselines and peers at the same work, and how time and memory grow."""
