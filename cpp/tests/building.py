"""What the tests share that compile something."""

from __future__ import annotations

import argparse
import subprocess
from collections.abc import Sequence
from pathlib import Path

PORT = Path(__file__).resolve().parent.parent


def arguments() -> argparse.Namespace:
    """``--compiler``: a C++ compiler; ``--build``: the port's build folder."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--build", type=Path, default=PORT / "build")
    return parser.parse_args()


def run(
    command: Sequence[str | Path], folder: Path | None = None
) -> tuple[int, str]:
    """Exit status, and all that the command has printed."""
    done = subprocess.run(
        [str(word) for word in command],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    return done.returncode, done.stdout


def must(command: Sequence[str | Path], folder: Path | None = None) -> str:
    """What the command has printed; ends the test where it fails."""
    status, text = run(command, folder)
    if status != 0:
        words = " ".join(str(word) for word in command)
        raise SystemExit(f"FAILED: {words}\n{text}")
    return text


def unity(folder: Path) -> Path:
    """All of the program, the tests left out, as one source."""
    source = folder / "unity.cpp"
    names = sorted((PORT / "src").glob("*.cpp"))
    source.write_text("".join(f'#include "{name}"\n' for name in names))
    return source


def include_flags(eigen: str = "/usr/include/eigen3") -> list[str]:
    """What the unity source needs."""
    return [
        "-std=c++17",
        f"-I{PORT / 'include'}",
        f"-I{PORT / 'src'}",
        f"-I{eigen}",
        "-pthread",
    ]
