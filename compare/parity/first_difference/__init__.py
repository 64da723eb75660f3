"""Finds where a program's map first differs: the scan, the beam, the cell."""
