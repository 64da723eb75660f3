"""Tests of `parity check`."""
