"""Snippets: what is cut, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from occgrid_handouts.languages import LANGUAGES
from occgrid_handouts.snippets import read_snippets, require
from occgrid_parity.ports.snippets import SnippetError, parse_snippets


def test_missing_and_unknown_snippets_are_refused() -> None:
    (snippet,) = parse_snippets("f", "# [snippet: odd]\nx\n# [/snippet]\n")
    with pytest.raises(SnippetError, match="python: no snippet logit"):
        require(LANGUAGES[0], {"odd": snippet}, ["odd", "logit"])
    with pytest.raises(SnippetError, match="python: unknown snippet odd"):
        require(LANGUAGES[0], {"odd": snippet}, [])


def test_a_name_in_two_files_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "python" / "occgrid"
    folder.mkdir(parents=True)
    for file in ("a.py", "b.py"):
        (folder / file).write_text("# [snippet: odd]\nx\n# [/snippet]\n")
    with pytest.raises(SnippetError, match=r"b\.py:2: snippet odd is also in"):
        read_snippets(tmp_path, LANGUAGES[0])
