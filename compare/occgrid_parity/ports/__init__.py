"""The five ports: their declarations, how they are built, their probes."""
