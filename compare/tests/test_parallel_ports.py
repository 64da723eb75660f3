"""The ports are one program in five languages: the same modules, the same snippets."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from .conftest import PORTS, ROOT

NAMES = ["python", "cpp", "java", "matlab", "mathematica"]
SOURCES = (".py", ".cpp", ".hpp", ".h", ".java", ".m", ".wl", ".wls")
NOT_SOURCES = re.compile(
    r"^(\..*|build.*|target|tests?|__pycache__|.*\.egg-info)$"
)
MARKER = re.compile(r"\[(/?)snippet(?::\s*([a-z0-9-]+))?\]")
MAX_COLUMNS = 79
ROOT_FOLDERS = [port.folder for port in PORTS]


def table(title: str) -> dict[str, str]:
    """The rows of the table below a heading of CONTRIBUTING.md: first column to second."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    section = text.split(f"\n## {title}\n")[1].split("\n## ")[0]
    rows = [line for line in section.splitlines() if line.startswith("|")]
    cells = [
        [cell.strip() for cell in row.strip("|").split("|")]
        for row in rows[2:]
    ]
    return {cell[0]: cell[1] for cell in cells}


MODULES = list(table("Modules"))
SNIPPETS = {
    module: re.findall(r"`([a-z0-9-]+)`", names)
    for module, names in table("Snippets").items()
}


def plain(name: str) -> str:
    """A name without the marks of its case: map_writer, mapWriter, MapWriter."""
    return name.lstrip("+@").replace("_", "").replace("-", "").lower()


def source_files(folder: Path) -> Iterator[Path]:
    """A port's own sources, by path; neither its tests nor what was built."""
    for path in sorted(folder.iterdir()):
        if NOT_SOURCES.match(path.name):
            continue
        if path.is_dir():
            yield from source_files(path)
        elif path.suffix in SOURCES:
            yield path


def modules_of(folder: Path) -> dict[str, list[Path]]:
    """The files of each module: of its name, or in a folder of its name."""
    files: dict[str, list[Path]] = {module: [] for module in MODULES}
    for path in source_files(folder):
        parts = [path.stem, *path.relative_to(folder).parent.parts]
        names = [plain(part) for part in parts]
        for module in MODULES:
            if plain(module) in names:
                files[module].append(path)
                break
    return files


def snippets_of(path: Path) -> dict[str, list[str]]:
    """The snippets of a file: name to lines. Fails the test where markers do not match."""
    found: dict[str, list[str]] = {}
    name, lines = "", []
    for number, line in enumerate(
        path.read_text(encoding="utf-8").splitlines(), 1
    ):
        marker = MARKER.search(line)
        place = f"{path.relative_to(ROOT)}:{number}"
        if marker is None:
            lines.append(line)
            continue
        assert (
            re.search(r"[A-Za-z0-9]", line.replace(marker[0], "")) is None
        ), f"{place}: a marker stands on a line of its own"
        if marker[1]:
            assert name, f"{place}: the end of no snippet"
            assert lines, f"{place}: an empty snippet {name}"
            found[name] = lines
            name, lines = "", []
        else:
            assert not name, f"{place}: within the snippet {name}"
            name, lines = marker[2], []
            assert name, f"{place}: a snippet without a name"
            assert name not in found, f"{place}: {name} again"
    assert not name, (
        f"{path.relative_to(ROOT)}: the snippet {name} does not end"
    )
    return found


def test_there_are_five_ports() -> None:
    assert sorted(port.name for port in PORTS) == sorted(NAMES)
    for port in PORTS:
        assert port.folder.name == port.name
        assert port.probe, f"{port.name}/port.toml has no probe"
        assert port.version, f"{port.name}/port.toml has no version"


def test_the_tables_are_read() -> None:
    assert len(MODULES) == 12
    assert (MODULES[0], MODULES[-1]) == ("portable_math", "main")
    assert SNIPPETS["portable_math"] == [
        "portable-sin",
        "portable-exp",
        "portable-log",
    ]
    assert sum(map(len, SNIPPETS.values())) > 20
    assert set(SNIPPETS) <= set(MODULES)


@pytest.mark.parametrize("module", MODULES)
@pytest.mark.parametrize(
    "folder", ROOT_FOLDERS, ids=lambda folder: folder.name
)
def test_has_the_module(folder: Path, module: str) -> None:
    assert modules_of(folder)[module], f"{folder.name} has no {module}"


@pytest.mark.parametrize("module", MODULES)
@pytest.mark.parametrize(
    "folder", ROOT_FOLDERS, ids=lambda folder: folder.name
)
def test_has_the_modules_snippets_in_order(folder: Path, module: str) -> None:
    """Where a module has several files, each has its own in order, and none twice."""
    expected = SNIPPETS.get(module, [])
    found: list[str] = []
    for path in modules_of(folder)[module]:
        names = list(snippets_of(path))
        order = [name for name in expected if name in names]
        assert names == order, (
            f"{path.relative_to(ROOT)}: not these in this order"
        )
        found += names
    assert sorted(found) == sorted(expected)


@pytest.mark.parametrize(
    "folder", ROOT_FOLDERS, ids=lambda folder: folder.name
)
def test_has_no_snippets_elsewhere(folder: Path) -> None:
    modules = [path for files in modules_of(folder).values() for path in files]
    for path in source_files(folder):
        if path not in modules:
            assert snippets_of(path) == {}, path.relative_to(ROOT)


@pytest.mark.parametrize(
    "folder", ROOT_FOLDERS, ids=lambda folder: folder.name
)
def test_snippets_fit_a_page(folder: Path) -> None:
    for path in source_files(folder):
        for name, lines in snippets_of(path).items():
            for line in lines:
                place = f"{path.relative_to(ROOT)}: {name}"
                assert len(line) <= MAX_COLUMNS, (
                    f"{place}: {len(line)} columns: {line}"
                )
                assert "\t" not in line, f"{place}: a tab: {line}"
