"""The commands that the handouts print: how each port is run."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from built_handouts import needs
from occgrid_handouts.facts import COMMANDS
from occgrid_handouts.platform_math import search_path
from occgrid_handouts.project import ROOT

pytestmark = pytest.mark.long

TOOLS = {
    "python": ("python3", "python3"),
    "cpp": ("g++ cmake libeigen3-dev", "cmake"),
    "java": ("openjdk-17-jdk-headless", "java"),
    "matlab": ("octave", "octave-cli"),
    "mathematica": ("woxi", "woxi"),
}


@pytest.mark.parametrize(
    ("language", "command"),
    [(one, command) for one, both in COMMANDS.items() for command in both],
)
def test_command_draws_the_lesson(
    language: str, command: str, tmp_path: Path
) -> None:
    """In a folder that looks like the suite's, where nothing else lies."""
    needs(*TOOLS[language])
    for name in (".venv", *COMMANDS, "scenarios"):
        (tmp_path / name).symlink_to(ROOT / name)
    before = set(tmp_path.iterdir())
    subprocess.run(
        ["sh", "-c", command],
        cwd=tmp_path,
        env={**os.environ, "PATH": search_path()},
        check=True,
    )
    (made,) = set(tmp_path.iterdir()) - before
    if made.is_dir():
        names = sorted(path.name for path in made.iterdir())
        assert names == ["lesson.logodds", "lesson.pgm", "lesson.yaml"]
    elif made.suffix == ".pgm":
        assert made.read_text().startswith("P2\n220 180\n255\n")
    else:
        assert made.read_bytes().startswith(b"\x89PNG")
