"""Write the bad scenarios of this folder: python scenarios/bad/generate.py [FOLDER]

`cases.py` has them; README.md says what they are.
"""

from __future__ import annotations

import sys
from pathlib import Path

from cases import all_cases


def main(folder: Path) -> None:
    """Writes every bad scenario and, as expected.txt, their errors into ``folder``."""
    expected = []
    # as the shell lists the files in the C locale
    for case in sorted(all_cases(), key=lambda case: f"{case.name}.log"):
        file = folder / f"{case.name}.log"
        file.write_bytes(case.data)
        expected.append(f"{file.name}:{case.line}: {case.reason}\n")
    text = "".join(expected)
    (folder / "expected.txt").write_text(text, encoding="ascii", newline="\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
