"""Changes the Python port, one small thing at a time, and asks whether the scenarios see it."""
