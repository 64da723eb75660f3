"""A whole class: the instructor's rules, each program behind a wall, and results that last."""
