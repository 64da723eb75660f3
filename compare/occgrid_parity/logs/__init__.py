"""Scenarios made from the laser logs of others."""
