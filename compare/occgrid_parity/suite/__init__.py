"""What the suite holds: its scenarios, the modes to map them in, the golden results."""
