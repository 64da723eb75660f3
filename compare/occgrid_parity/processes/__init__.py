"""Runs commands: in a process group of their own, within limits, several side by side."""
