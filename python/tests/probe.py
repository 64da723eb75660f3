"""The port's probe: lays open portable_math, Philox and Bresenham to the suite's tests (see CONTRIBUTING.md)."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from occgrid import portable_math
from occgrid.noise import philox4x32
from occgrid.ray import bresenham


def main(function: str, source: str, target: str) -> None:
    lines = Path(source).read_text(encoding="ascii").splitlines()
    if function == "philox":
        words = np.array(
            [[int(word, 16) for word in line.split()] for line in lines],
            dtype=np.uint64,
        )
        answers = []
        for c0, c1, c2, c3, k0, k1 in words.tolist():
            counter = np.array([[c0], [c1], [c2], [c3]], dtype=np.uint64)
            answers.append(
                " ".join(
                    f"{word:08x}"
                    for word in philox4x32(counter, (k0, k1))[:, 0].tolist()
                )
            )
    elif function == "bresenham":
        answers = []
        for line in lines:
            gx0, gy0, gx1, gy1 = map(int, line.split())
            gx, gy = bresenham(gx0, gy0, gx1, gy1)
            answers.append(
                " ".join(
                    f"{x},{y}"
                    for x, y in zip(gx.tolist(), gy.tolist(), strict=True)
                )
            )
    else:
        arguments = np.array(
            [int(line, 16) for line in lines], dtype=np.uint64
        ).view(np.float64)
        results = getattr(portable_math, function)(arguments)
        results[np.isnan(results)] = np.nan
        answers = [f"{bits:016x}" for bits in results.view(np.uint64).tolist()]
    Path(target).write_text("\n".join(answers) + "\n", encoding="ascii")


if __name__ == "__main__":
    main(*sys.argv[1:])
