"""The packages of the harness: imports only go down, and every name has one owner.

The order is that of the table in CONTRIBUTING.md, the highest package first.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from .conftest import ROOT

NAME = "occgrid_parity"
SOURCE = ROOT / "compare" / NAME
OWN = ("occgrid", NAME)
"""The packages of the wheel: their private names stay inside them."""


@dataclass(frozen=True)
class Import:
    """A module, a module that it imports, and the name that it takes from it (empty: the module)."""

    importer: tuple[str, ...]
    imported: tuple[str, ...]
    name: str
    line: int

    def __str__(self) -> str:
        what = ".".join(self.imported)
        name = f" ({self.name})" if self.name else ""
        return f"{'.'.join(self.importer)}:{self.line} imports {what}{name}"


def packages() -> list[str]:
    """The packages in the table of CONTRIBUTING.md, from the highest to the lowest."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    section = text.split("## The harness\n")[1].split("\n## ")[0]
    return re.findall(r"^\| `([a-z]+)/` \|", section, re.MULTILINE)


def modules(source: Path) -> dict[tuple[str, ...], Path]:
    """The modules of a package by their names, the package's own first."""
    found = {}
    for path in sorted(source.rglob("*.py")):
        name = path.relative_to(source.parent).with_suffix("").parts
        found[name[:-1] if name[-1] == "__init__" else name] = path
    return found


def imports(source: Path) -> Iterator[Import]:
    """Every import of one of our modules, in functions and under TYPE_CHECKING, too."""
    known = modules(source)
    for importer, path in known.items():
        folder = importer if path.name == "__init__.py" else importer[:-1]
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    parts = tuple(alias.name.split("."))
                    if parts[0] in OWN:
                        yield Import(importer, parts, "", node.lineno)
            elif isinstance(node, ast.ImportFrom):
                start = folder[: len(folder) - node.level + 1]
                named = tuple(node.module.split(".")) if node.module else ()
                parts = (*(start if node.level else ()), *named)
                if parts[0] not in OWN:
                    continue
                for alias in node.names:
                    if (*parts, alias.name) in known:
                        whole = (*parts, alias.name)
                        yield Import(importer, whole, "", node.lineno)
                    else:
                        yield Import(importer, parts, alias.name, node.lineno)


def upward(source: Path, order: Sequence[str]) -> list[str]:
    """Imports of a package that does not stand below the importer's own."""
    wrong = []
    for one in imports(source):
        if len(one.importer) < 2 or one.importer[1] not in order:
            continue
        if one.imported[0] != source.name:
            continue
        own = one.importer[1]
        other = one.imported[1] if len(one.imported) > 1 else ""
        if other == own:
            continue
        if other not in order or order.index(other) < order.index(own):
            wrong.append(str(one))
    return wrong


def circles(source: Path) -> list[str]:
    """Modules that import each other, whether at once or on a way round."""
    below: dict[tuple[str, ...], set[tuple[str, ...]]] = {}
    for one in imports(source):
        below.setdefault(one.importer, set()).add(one.imported)
    return sorted(
        ".".join(module)
        for module in below
        if module in reachable(module, below)
    )


def reachable(
    start: tuple[str, ...], below: dict[tuple[str, ...], set[tuple[str, ...]]]
) -> set[tuple[str, ...]]:
    """The modules that one imports, directly or not."""
    found: set[tuple[str, ...]] = set()
    new = below.get(start, set())
    while new:
        found |= new
        new = {b for module in new for b in below.get(module, ())} - found
    return found


def private(source: Path) -> list[str]:
    """Names and modules with a leading underscore that are taken from another package, or read as its attribute."""
    every = list(imports(source))
    wrong = [
        str(one)
        for one in every
        if one.importer[:2] != one.imported[:2]
        and any(is_private(part) for part in (*one.imported, one.name))
    ]
    for module, path in modules(source).items():
        taken = {
            one.imported[-1]
            for one in every
            if one.importer == module
            and not one.name
            and one.imported[:2] != module[:2]
        }
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if (
                isinstance(node, ast.Attribute)
                and is_private(node.attr)
                and isinstance(node.value, ast.Name)
                and node.value.id in taken
            ):
                what = f"{node.value.id}.{node.attr}"
                wrong.append(f"{'.'.join(module)}:{node.lineno} reads {what}")
    return wrong


def is_private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__")


def twins(source: Path) -> list[str]:
    """Names that two modules or packages of the harness have."""
    names = Counter(
        module[-1] for module in modules(source) if module[-1][:2] != "__"
    )
    return sorted(name for name, count in names.items() if count > 1)


def test_the_table_has_every_package() -> None:
    found = {path.parent.name for path in SOURCE.glob("*/__init__.py")}
    assert sorted(packages()) == sorted(found)


def test_imports_go_down() -> None:
    assert upward(SOURCE, packages()) == []


def test_no_circles() -> None:
    assert circles(SOURCE) == []


def test_private_names_stay_at_home() -> None:
    assert private(SOURCE) == []


def test_no_two_modules_have_one_name() -> None:
    assert twins(SOURCE) == []
    port = {path.stem for path in (ROOT / "python/occgrid").glob("[a-z]*.py")}
    own = {module[-1] for module in modules(SOURCE)}
    assert port & own == set()


# the same rules on a small tree, each broken once

SOUND = {
    "high/top.py": "from occgrid_parity.low.bottom import name",
    "low/bottom.py": "from occgrid_parity.low import beside",
    "low/beside.py": "name = _hidden = 1",
}


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A package of two packages, high above low, that keeps the rules."""
    source = tmp_path / NAME
    for folder in ("", "high/", "low/"):
        put(source, folder + "__init__.py", "")
    for file, text in SOUND.items():
        put(source, file, text)
    return source


def put(source: Path, file: str, text: str) -> None:
    path = source / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text + "\n")


def broken_rules(source: Path) -> list[str]:
    """Which of the rules a tree breaks."""
    found = {
        "up": upward(source, ["high", "low"]),
        "circle": circles(source),
        "private": private(source),
        "twin": twins(source),
    }
    return [rule for rule, wrong in found.items() if wrong]


def test_a_sound_tree(tree: Path) -> None:
    assert broken_rules(tree) == []


@pytest.mark.parametrize(
    ("file", "text", "rule"),
    [
        ("low/beside.py", "from occgrid_parity.high import top", "up circle"),
        ("low/beside.py", "from ..high.top import name", "up circle"),
        ("low/new.py", "import occgrid_parity.high.top", "up"),
        ("low/new.py", "def f():\n    from ..high import top", "up"),
        ("low/beside.py", "from occgrid_parity.low import bottom", "circle"),
        ("low/new.py", "from occgrid_parity.low.beside import _hidden", ""),
        ("high/new.py", "from ..low.beside import _hidden", "private"),
        ("high/new.py", "from ..low import beside\nbeside._hidden", "private"),
        ("high/new.py", "from occgrid.scenario import _WORDS", "private"),
        ("high/beside.py", "", "twin"),
        ("low/high.py", "", "twin"),
    ],
)
def test_a_broken_rule_is_seen(
    tree: Path, file: str, text: str, rule: str
) -> None:
    put(tree, file, text)
    assert broken_rules(tree) == rule.split()
