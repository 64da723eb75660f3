"""Maps all scenarios with all ports and compares the maps, bit for bit."""
