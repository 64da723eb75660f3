"""The recipes of CONTRIBUTING.md name what is there, and what they ask for is done."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from .conftest import ROOT

PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
RECIPES = dict(
    part.split("\n", 1)
    for part in PAGE.split("\n## Recipes\n")[1].split("\n## ")[0].split("\n### ")[1:]
)  # fmt: skip
WORDS = re.compile(r"`([^`]+)`")
PLACE = re.compile(r"(?:[\w.-]+/)+[\w.*-]*|[\w-]+\.(?:md|toml)")
NAME_IN_FILE = re.compile(r"`([\w-]+)` (?:of|in) `([\w./-]+\.\w+)`")


def places(recipe: str) -> list[str]:
    """The files and folders that a recipe names, but for what is still to be made."""
    found = [
        match[0]
        for words in WORDS.findall(RECIPES[recipe])
        for match in PLACE.finditer(words)
    ]
    return [place for place in found if "NAME" not in place]


@pytest.mark.parametrize("recipe", RECIPES)
def test_a_recipe_names_files_that_are_there(recipe: str) -> None:
    folders = [ROOT, ROOT / "compare" / "occgrid_parity", ROOT / "handouts"]
    assert places(recipe)
    for place in places(recipe):
        assert any((folder / place).exists() for folder in folders), place


@pytest.mark.parametrize("recipe", RECIPES)
def test_a_recipe_names_what_stands_in_those_files(recipe: str) -> None:
    text = " ".join(RECIPES[recipe].split())
    for name, place in NAME_IN_FILE.findall(text):
        source = (ROOT / place).read_text(encoding="utf-8")
        assert re.search(rf"\b{re.escape(name)}\b", source), (name, place)


def test_the_recipes_are_found() -> None:
    pairs = NAME_IN_FILE.findall(" ".join(PAGE.split()))
    assert len(RECIPES) == 5
    assert len(pairs) >= 6
    assert sum(len(places(recipe)) for recipe in RECIPES) >= 25


def test_every_scenario_has_a_row_in_the_table() -> None:
    table = (ROOT / "scenarios" / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`[^|]*\.log`) \|", table, flags=re.MULTILINE)
    listed = [name for row in rows for name in WORDS.findall(row)]
    files = sorted(
        Path(path).name for path in (ROOT / "scenarios").glob("*.log")
    )
    assert sorted(listed) == files
