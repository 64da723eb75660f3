"""Where things lie."""

from __future__ import annotations

import os
from pathlib import Path

BENCH = Path(__file__).resolve().parents[1]
ROOT = BENCH.parent
OUT = ROOT / "build" / "bench"
PROGRAMS = OUT / "cpp" / "bin"
CLASSES = OUT / "java"
WORK = OUT / "work"


def data_folder() -> Path | None:
    """A folder with real logs: OCCGRID_DATA, or ../shared/data beside the repository."""
    named = os.environ.get("OCCGRID_DATA")
    folder = Path(named) if named else ROOT.parent / "shared" / "data"
    return folder if folder.is_dir() else None


def find_log() -> Path | None:
    """The log that is mapped where none is named: Intel's if it is there."""
    folder = data_folder()
    if folder is None:
        return None
    logs = sorted([*folder.glob("*.log"), *folder.glob("*.clf")])
    intel = [log for log in logs if log.name.startswith("intel")]
    return next(iter([*intel, *logs]), None)
