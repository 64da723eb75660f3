"""A mapper with one mistake of the catalogue: mistaken.py MISTAKE [--noise-free | --seed N] OUT SCENARIO"""

import sys
from pathlib import Path

from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model.worlds import read_world

mistake, *mode, out, scenario = sys.argv[1:]
seed = int(mode[1]) if mode[0] == "--seed" else None
drawn = MISTAKES[mistake](read_world(scenario), seed).draw()
height, width = drawn.pixels.shape
name = Path(scenario).stem
rows = [" ".join(map(str, row)) for row in drawn.pixels.tolist()]
(Path(out) / f"{name}.pgm").write_text(
    "\n".join(["P2", f"{width} {height}", "255", *rows]) + "\n"
)
rows = [" ".join(map(repr, row)) for row in drawn.log_odds.tolist()]
(Path(out) / f"{name}.logodds").write_text(
    "\n".join([f"# logodds {width} {height}", *rows]) + "\n"
)
