"""Where the source files of a port lie, and which of them make up a module."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

SUFFIXES = (
    ".py",
    ".cpp",
    ".hpp",
    ".h",
    ".java",
    ".m",
    ".wl",
    ".wls",
    ".js",
    ".mjs",
)
NOT_SOURCES = re.compile(
    r"\..*|build.*|target|tests?|pages|node_modules|__pycache__|.*\.egg-info"
)


def plain(name: str) -> str:
    """A name without the marks of its case: map_writer, mapWriter and MapWriter are mapwriter."""
    return name.replace("_", "").replace("-", "").lower()


def source_files(folder: Path) -> Iterator[Path]:
    """A port's own sources, by path; neither its tests nor web pages nor what was built."""
    for path in sorted(folder.iterdir()):
        if NOT_SOURCES.fullmatch(path.name):
            continue
        if path.is_dir():
            yield from source_files(path)
        elif path.suffix in SUFFIXES:
            yield path


def module_files(
    folder: Path, modules: Iterable[str]
) -> dict[str, list[Path]]:
    """The files of each module, which bear its name."""
    names = {plain(module): module for module in modules}
    files: dict[str, list[Path]] = {module: [] for module in names.values()}
    for path in source_files(folder):
        if plain(path.stem) in names:
            files[names[plain(path.stem)]].append(path)
    return files
