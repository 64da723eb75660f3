"""The check of a program: level after level, then the verdict."""
