"""The parser of snippets: what is cut, and what is refused."""

from __future__ import annotations

import re

import pytest

from occgrid_parity.ports.snippets import SnippetError, parse_snippets


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
        ("# [snippet: a]\n\tx\n# [/snippet]\n", "f:2: a tab in snippet a"),
        (
            "# [snippet: a]\nx\n# [/snippet]\n# [snippet: a]\n",
            "f:4: snippet a a second time",
        ),
        ("x = 1  # [snippet: a]\n", "f:1: a marker is a comment on a line"),
        ("# [snippet: ]\n", "f:1: a marker is a comment on a line"),
        ("# [snippet: A b]\n", "f:1: a marker is a comment on a line"),
        ("# [snippet a]\n", "f:1: a marker is a comment on a line"),
    ],
)
def test_marker_that_cannot_be_used(text: str, reason: str) -> None:
    with pytest.raises(SnippetError, match=re.escape(reason)):
        parse_snippets("f", text)
