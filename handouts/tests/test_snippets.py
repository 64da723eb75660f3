"""Snippets: what is cut, and what is refused."""

from __future__ import annotations

import re

import pytest

from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.project import ROOT
from occgrid_handouts.snippets import (
    NAMES,
    SnippetError,
    parse_snippets,
    require,
)


@pytest.mark.parametrize(
    ("begin", "end"),
    [
        ("# [snippet: a-b]", "# [/snippet]"),
        ("  // [snippet: a-b]", "  // [/snippet]"),
        ("    % [snippet: a-b]", "    % [/snippet]"),
        ("(* [snippet: a-b] *)", "(* [/snippet] *)"),
    ],
)
def test_comment_of_every_language(begin: str, end: str) -> None:
    text = f"x\n{begin}\n\n    one\n      two\n\n{end}\ny\n"
    (snippet,) = parse_snippets("f", text)
    assert (snippet.name, snippet.first, snippet.last) == ("a-b", 4, 5)
    assert snippet.code == "one\n  two"


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("# [snippet: a]\n# [snippet: b]\n", "f:2: a is still open"),
        ("# [snippet: a]\nx\n", "f:1: a is never closed"),
        ("# [/snippet]\n", "f:1: no snippet is open"),
        ("# [snippet: a]\n\n# [/snippet]\n", "f:1: snippet a is empty"),
        (
            "# [snippet: a]\n" + "x" * 80 + "\n# [/snippet]\n",
            "f:2: 80 columns in snippet a, 79 fit",
        ),
    ],
)
def test_marker_that_cannot_be_used(text: str, reason: str) -> None:
    with pytest.raises(SnippetError, match=re.escape(reason)):
        parse_snippets("f", text)


def test_missing_and_unknown_snippets_are_refused() -> None:
    (snippet,) = parse_snippets("f", "# [snippet: odd]\nx\n# [/snippet]\n")
    with pytest.raises(SnippetError, match="python: no snippet logit"):
        require(LANGUAGES[0], {"odd": snippet}, ["logit"])
    with pytest.raises(SnippetError, match="python: unknown snippet odd"):
        require(LANGUAGES[0], {"odd": snippet}, ["odd"])


def test_names_are_those_of_the_ports() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = text.split("## Snippets")[1].split("## ")[0]
    listed = re.findall(
        r"`([a-z-]+)`", table.split("| module | snippets |")[1]
    )
    assert list(NAMES) == [n for n in listed if n != "portable_math"]
