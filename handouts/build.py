"""Build the course handouts: python handouts/build.py --out build/handouts"""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [
    str(HERE),
    str(HERE.parent / "python"),
    str(HERE.parent / "compare"),
]

from occgrid_handouts.cli import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
