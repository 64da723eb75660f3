"""sin, cos, exp and log by Java's StrictMath, which is specified to be fdlibm.

What it answers is compared with the Python port's portable_math: two programs
that know nothing of each other must give the same double, or nothing is written.
"""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np
from exact import bits_of, double, hexadecimal

from occgrid import portable_math

ROOT = Path(__file__).resolve().parents[2]
REFERENCE = ROOT / "compare" / "reference" / "StrictMathReference.java"


def strict_math(function: str, arguments: Sequence[float]) -> list[float]:
    """sin, cos, exp or log (by name) of each argument."""
    with tempfile.TemporaryDirectory() as folder:
        asked, answered = Path(folder, "asked"), Path(folder, "answered")
        asked.write_text("".join(f"{hexadecimal(x)}\n" for x in arguments))
        reference = ["java", "-cp", _compiled().name, REFERENCE.stem]
        subprocess.run([*reference, function, asked, answered], check=True)
        lines = answered.read_text().splitlines()
    values = [double(int(line, 16)) for line in lines]
    _compare(function, arguments, values)
    return values


@cache
def _compiled() -> tempfile.TemporaryDirectory[str]:
    """A folder with the reference's class, for as long as this program runs."""
    folder = tempfile.TemporaryDirectory()
    subprocess.run(["javac", "-d", folder.name, REFERENCE], check=True)
    return folder


def _compare(
    function: str, arguments: Sequence[float], values: Sequence[float]
) -> None:
    port = getattr(portable_math, function)
    with np.errstate(all="ignore"):
        found = port(np.array(arguments, dtype=np.float64)).tolist()
    for x, value, other in zip(arguments, values, found, strict=True):
        if bits_of(value) != bits_of(other):
            raise SystemExit(
                f"{function}({hexadecimal(x)}): StrictMath gives "
                f"{hexadecimal(value)}, the Python port {hexadecimal(other)}"
            )
