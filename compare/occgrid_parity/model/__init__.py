"""The contract taken apart: its mapper in steps, the cells of lines, the beams that rounding decides."""
