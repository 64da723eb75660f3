"""The ports: their declarations, how they are built, their probes."""
