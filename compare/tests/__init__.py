"""Tests of the harness, and the parity tests of the ports."""
