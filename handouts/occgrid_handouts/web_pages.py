"""play.html and check.html: the pages of the folder web, as its own build makes them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from occgrid_handouts.machine import time_limit
from occgrid_handouts.platform_math import search_path

NAMES = ("play.html", "check.html")
SECONDS = 60


def web_pages(root: Path, work: Path) -> tuple[dict[str, bytes], list[str]]:
    """The pages by name, and what is missing, with the reason."""
    reason = _build(root / "web" / "build.mjs", work)
    found = {
        name: (work / name).read_bytes()
        for name in NAMES
        if not reason and (work / name).is_file()
    }
    missing = [
        f"{name}: {reason or 'web/build.mjs did not make it'}"
        for name in NAMES
        if name not in found
    ]
    return found, missing


def _build(program: Path, folder: Path) -> str:
    """Runs the build of the pages; says what went wrong, or nothing."""
    if not program.is_file():
        return "there is no web/build.mjs"
    node = shutil.which("node", path=search_path())
    if node is None:
        return "install nodejs"
    if not (program.parent / "node_modules").is_dir():
        return "run npm ci in web/"
    try:
        done = subprocess.run(
            [node, str(program), str(folder)],
            cwd=program.parent,
            capture_output=True,
            text=True,
            timeout=time_limit(SECONDS),
        )
    except subprocess.TimeoutExpired as error:
        return f"web/build.mjs took over {error.timeout:.0f} s"
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        return lines[-1] if lines else f"status {done.returncode}"
    return ""
