"""Measure ports, baselines and peers: python bench/run.py [--quick] (see --help)."""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [
    str(HERE),
    str(HERE.parent / "python"),
    str(HERE.parent / "compare"),
]

from occgrid_bench.cli import main  # noqa: E402

if __name__ == "__main__":
    main()
