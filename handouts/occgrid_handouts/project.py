"""What is printed: the repository, its version, commit and date."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import occgrid

ROOT = Path(__file__).resolve().parents[2]
COMMAND = "make handouts"


@dataclass(frozen=True)
class Edition:
    """Version, commit and date of the sources.

    ``seconds`` since 1970 is the commit's date, or SOURCE_DATE_EPOCH where that is set: the only date that enters a
    file.
    """

    version: str
    commit: str
    seconds: int


def current_edition(root: Path = ROOT) -> Edition:
    """The edition of the working tree; outside git the commit is "unknown" and the date 1970."""
    commit = _git(root, "rev-parse", "--short=12", "HEAD")
    changed = _git(root, "status", "--porcelain", "--untracked-files=no")
    date = _git(root, "log", "-1", "--format=%ct") or "0"
    if commit and changed:
        commit += " with changes"
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH") or date)
    return Edition(occgrid.__version__, commit or "unknown", seconds)


def _git(root: Path, *arguments: str) -> str:
    """What git says, or nothing."""
    try:
        done = subprocess.run(
            ["git", "--no-optional-locks", *arguments],
            cwd=root,
            capture_output=True,
            text=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return ""
    return done.stdout.strip()
