"""The ports are one program: the same modules, functions, parameters and snippets.

CONTRIBUTING.md says which, and where a language must differ. What a port defines is read from its sources.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

from occgrid_parity.ports.contributing import (
    Signature,
    module_functions,
    module_snippets,
    parameter_names,
    read_table,
    signatures,
    snippet_names,
)
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.snippets import parse_snippets
from occgrid_parity.ports.sources import module_files, plain, source_files

from .conftest import PORTS, ROOT
from .port_signatures import read_signatures

MODULES = module_functions(ROOT)
FUNCTIONS = {one.name: one for sigs in MODULES.values() for one in sigs}
SNIPPETS = module_snippets(ROOT)
BY_NAME = {port.name: port for port in PORTS}

THERE = re.compile(r"(?:`(?P<signature>[^`]+)`)? ?(?:in `(?P<file>[^`]+)`)?")

Definitions = list[tuple[str, ...]]
"""The parameters of each definition of a name, without case and underscores; an overloaded name has several."""


@dataclass(frozen=True)
class Difference:
    """One port's entry for one name in the table "Differences between the ports".

    ``there`` is None where the port has no such name, ``file`` the end of the file's path (without suffix) where it
    is not in its module.
    """

    port: str
    name: str
    there: Signature | None
    file: str = ""


def allowed_differences() -> Iterator[Difference]:
    for ports, names, there, _ in read_table(
        ROOT, "Differences between the ports"
    ):
        for port in ports.split(", "):
            for one in signatures(names):
                yield difference(port, one.name, there)


def difference(port: str, name: str, there: str) -> Difference:
    """Reads the column "there" for one name."""
    if there == "none":
        return Difference(port, name, None)
    usual = FUNCTIONS[name]
    match = THERE.fullmatch(there)
    if match is None:
        raise ValueError(f"differences: cannot be read: {there}")
    quoted, file = match["signature"] or "...", match["file"] or ""
    new_name, bracket, rest = quoted.partition("(")
    parameters = usual.parameters
    if bracket:
        words: list[str] = []
        for word in parameter_names(rest.rstrip(")")) or ():
            words += (usual.parameters or ()) if word == "..." else [word]
        parameters = tuple(words)
    return Difference(
        port,
        name,
        Signature(new_name.replace("...", name), parameters),
        file,
    )


DIFFERENCES = {(one.port, one.name): one for one in allowed_differences()}


def defined(paths: list[Path]) -> dict[str, Definitions]:
    """What the files define, names and parameters without case and underscores."""
    found: dict[str, Definitions] = {}
    for path in paths:
        for name, several in read_signatures(path).items():
            found.setdefault(plain(name), []).extend(
                tuple(map(plain, parameters)) for parameters in several
            )
    return found


def fits(wanted: Signature, found: dict[str, Definitions]) -> bool:
    several = found.get(plain(wanted.name), [])
    if wanted.parameters is None:
        return bool(several)
    return tuple(map(plain, wanted.parameters)) in several


def as_found(name: str, found: dict[str, Definitions]) -> str:
    several = found.get(plain(name), [])
    texts = [f"{name}({', '.join(parameters)})" for parameters in several]
    return " and ".join(texts) or f"no {name}"


def own_file(port: Port, end: str) -> list[Path]:
    """The port's source file whose path ends so."""
    return [
        path
        for path in source_files(port.folder)
        if path.with_suffix("").as_posix().endswith(f"/{end}")
    ]


def wrong_functions(
    port: Port,
    module: str,
    differences: Mapping[tuple[str, str], Difference] = DIFFERENCES,
) -> Iterator[str]:
    """What is not as the tables say it."""
    usual = defined(module_files(port.folder, MODULES)[module])
    for signature in MODULES[module]:
        found, wanted = usual, signature
        entry = differences.get((port.name, signature.name))
        if entry and fits(signature, usual):
            yield f"{signature} is as everywhere: its row among the differences goes"
            continue
        if entry and entry.there is None:
            if plain(signature.name) in usual:
                yield f"{as_found(signature.name, usual)}, where none is allowed"
            continue
        if entry and entry.there:
            wanted = entry.there
            if entry.file:
                found = defined(own_file(port, entry.file))
        if not fits(wanted, found):
            yield f"{wanted} is {as_found(wanted.name, found)}"


def test_the_tables_are_read() -> None:
    assert (next(iter(MODULES)), [*MODULES][-1]) == ("portable_math", "main")
    assert len(MODULES) == 12
    assert len(FUNCTIONS) == sum(map(len, MODULES.values())) > 40
    assert str(FUNCTIONS["bresenham"]) == "bresenham(gx0, gy0, gx1, gy1)"
    assert set(SNIPPETS) <= set(MODULES)
    assert len(set(snippet_names(ROOT))) == len(snippet_names(ROOT)) > 20
    assert str(difference("web", "logit", "`P...(grid, ..., k)`").there) == (
        "Plogit(grid, p, k)"
    )
    for port, name in DIFFERENCES:
        assert port in BY_NAME, f"differences: no port {port}"
        assert name in FUNCTIONS, f"differences: no function {name}"


@pytest.mark.parametrize("port", PORTS, ids=lambda port: port.name)
def test_a_port_has_a_probe_and_a_version(port: Port) -> None:
    assert port.folder.name == port.name
    assert port.probe, f"{port.name}/port.toml has no probe"
    assert port.version, f"{port.name}/port.toml has no version"


@pytest.mark.parametrize("module", MODULES)
@pytest.mark.parametrize("port", PORTS, ids=lambda port: port.name)
def test_has_the_module(port: Port, module: str) -> None:
    assert module_files(port.folder, MODULES)[module], (
        f"{port.name} has no {module}"
    )


@pytest.mark.parametrize(
    "module", [module for module, functions in MODULES.items() if functions]
)
@pytest.mark.parametrize("port", PORTS, ids=lambda port: port.name)
def test_has_the_modules_functions(port: Port, module: str) -> None:
    wrong = list(wrong_functions(port, module))
    assert not wrong, "\n".join([f"{port.name}, {module}:", *wrong])


@pytest.mark.parametrize("module", MODULES)
@pytest.mark.parametrize("port", PORTS, ids=lambda port: port.name)
def test_has_the_modules_snippets_in_order(port: Port, module: str) -> None:
    """Where a module has several files, each has its own in order, and none twice."""
    expected = SNIPPETS.get(module, [])
    found: list[str] = []
    for path in module_files(port.folder, MODULES)[module]:
        names = snippets_of(path)
        order = [name for name in expected if name in names]
        assert names == order, (
            f"{path.relative_to(ROOT)}: not these in this order"
        )
        found += names
    assert sorted(found) == sorted(expected)


@pytest.mark.parametrize("port", PORTS, ids=lambda port: port.name)
def test_has_no_snippets_elsewhere(port: Port) -> None:
    files = module_files(port.folder, MODULES)
    modules = [path for paths in files.values() for path in paths]
    for path in source_files(port.folder):
        if path not in modules:
            assert snippets_of(path) == [], path.relative_to(ROOT)


def snippets_of(path: Path) -> list[str]:
    """The names of a file's snippets, in its order."""
    file = path.relative_to(ROOT).as_posix()
    text = path.read_text(encoding="utf-8")
    return [snippet.name for snippet in parse_snippets(file, text)]
