"""Tests of `occgrid-parity check`."""
