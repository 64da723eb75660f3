"""Where the ports, the scenarios and the golden results lie."""

from __future__ import annotations

from pathlib import Path

HERE = Path(__file__).resolve().parents[3]


def find_root(start: Path | None = None) -> Path:
    """The repository's root: the nearest folder with SPEC.md and a port in it.

    It is looked for from ``start`` (default: the current folder) upwards, then
    beside this package. Raises FileNotFoundError where there is none.
    """
    first = (start or Path.cwd()).resolve()
    for folder in (first, *first.parents, HERE):
        if (folder / "SPEC.md").is_file() and (folder / "scenarios").is_dir():
            return folder
        if (folder / "SPEC.md").is_file() and any(folder.glob("*/port.toml")):
            return folder
    raise FileNotFoundError(
        f"no folder with SPEC.md and ports at or above {first}: say --root DIR"
    )
