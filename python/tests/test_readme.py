"""README.md: its commands run, and its program prints what stands below it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

PORT = Path(__file__).parents[1]
README = (PORT / "README.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^    \.\./\.venv/bin/(.*)$", README, re.MULTILINE)


def test_the_library(tmp_path: Path) -> None:
    (program,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    (expected,) = re.findall(r"```text\n(.*?)```", README, re.DOTALL)
    (tmp_path / "scenarios").symlink_to(PORT.parent / "scenarios")
    ended = subprocess.run(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stdout == expected
    assert expected.startswith("0.9892011065412029\n")
    assert (tmp_path / "fine.png").stat().st_size > 10_000


def test_there_are_commands() -> None:
    assert len(COMMANDS) == 5
    assert COMMANDS[-1] == "pytest tests"  # these


@pytest.mark.parametrize("command", COMMANDS[:-1])
def test_a_command(command: str, tmp_path: Path) -> None:
    """As it is printed, from a folder beside scenarios/."""
    (tmp_path / "scenarios").symlink_to(PORT.parent / "scenarios")
    (tmp_path / "python").mkdir()
    program, *arguments = command.split()
    assert program == "occgrid"
    ended = subprocess.run(
        [sys.executable, "-m", "occgrid", *arguments],
        cwd=tmp_path / "python",
        capture_output=True,
        text=True,
        check=True,
    )
    assert ended.stderr == ""
    assert ended.stdout or list((tmp_path / "build" / "maps").iterdir())
