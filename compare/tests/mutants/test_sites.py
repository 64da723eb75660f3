"""The changes: each is what it says, and alone."""

from __future__ import annotations

import ast
from collections import Counter
from pathlib import Path

import pytest

from occgrid_mutants import port_modules
from occgrid_mutants.sites import sites
from occgrid_mutants.trials import Trial
from occgrid_mutants.watching import Measured, failure

ROOT = Path(__file__).resolve().parents[3]

SOURCE = '''
"""A module."""
WORDS = "3FE5555555555593 3FD999999997FA04"

def f(a: int, b: int = 2) -> int:
    """Not this."""
    if a < b:
        a += 1
    return g(a, b) if not a else -a
'''


def changed() -> dict[str, str]:
    """Each change of SOURCE by name, with the source that it makes."""
    found = {}
    for i in range(len(sites("m", ast.parse(SOURCE)))):
        tree = ast.parse(SOURCE)
        site = sites("m", tree)[i]
        site.change()
        found[site.name] = ast.unparse(tree)
    return found


def test_every_kind_is_made() -> None:
    kinds = Counter(site.kind for site in sites("m", ast.parse(SOURCE)))
    assert kinds == {
        "operator": 5,
        "constant": 6,
        "branch": 4,
        "argument": 1,
        "statement": 2,
    }


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("m.f: a < b -> a <= b", "    if a <= b:"),
        ("m.f: a < b -> True", "    if True:"),
        ("m.f: a += 1 -> a -= 1", "        a -= 1"),
        ("m.f: a += 1 -> pass", "        pass"),
        ("m.f: g(a, b) -> g(b, a)", "    return g(b, a) if not a else -a"),
        ("m.f: -a -> a", "    return g(a, b) if not a else a"),
        ("m.f: 2 -> 3", "def f(a: int, b: int=3) -> int:"),
        (
            "m.WORDS: 3FD999999997FA04 -> 3FD999999997FA05",
            "WORDS = '3FE5555555555593 3FD999999997FA05'",
        ),
    ],
)
def test_a_change_is_what_its_name_says(name: str, line: str) -> None:
    lines = ast.unparse(ast.parse(SOURCE)).splitlines()
    altered = changed()[name].splitlines()
    assert line in altered
    assert len(set(altered) - set(lines)) == 1


def test_no_change_leaves_the_source_as_it_is() -> None:
    same = ast.unparse(ast.parse(SOURCE))
    assert same not in changed().values()


@pytest.mark.parametrize("module", port_modules.CHANGED)
def test_changes_of_the_port_compile(module: str) -> None:
    path = port_modules.sources(ROOT)[module]
    tree = port_modules.parse(path)
    found = sites(module, tree)
    assert len(found) > 5
    for site in found[::80]:
        fresh = port_modules.parse(path)
        again = sites(module, fresh)[found.index(site)]
        again.change()
        compile(fresh, str(path), "exec")


def test_a_changed_port_stands_in_for_the_port_for_a_while() -> None:
    import occgrid.grid

    code = port_modules.compiled(ROOT)
    tree = port_modules.parse(port_modules.sources(ROOT)["grid"])
    (change,) = (
        site
        for site in sites("grid", tree)
        if site.name == "grid.logit: q / (1.0 - q) -> q * (1.0 - q)"
    )
    change.change()
    code["grid"] = compile(tree, "grid.py", "exec")
    with port_modules.loaded(code) as modules:
        assert modules["scenario"].logit is modules["grid"].logit
        assert modules["grid"].logit(0.5) != 0.0
    assert occgrid.grid.logit(0.5) == 0.0


def forever(modules: object) -> bool:
    while True:
        pass


def broken(modules: object) -> bool:
    raise KeyError("x")


@pytest.mark.parametrize(
    ("right", "how"),
    [
        (lambda modules: True, None),
        (lambda modules: False, "differs"),
        (broken, "KeyError"),
        (forever, "does not end"),
    ],
)
def test_a_failure_is_told_apart(right: object, how: str | None) -> None:
    trial = Trial("a trial", right)  # type: ignore[arg-type]
    measured = Measured(trial, frozenset(), -0.095)
    assert failure(measured, {}) == how
