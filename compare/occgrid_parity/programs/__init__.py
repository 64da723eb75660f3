"""Programs that are no ports: their command, how they are run, the map that they have written."""
