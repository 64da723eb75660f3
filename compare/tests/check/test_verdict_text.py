"""Words of a verdict that need no program: what stands above a cause."""

from __future__ import annotations

import pytest

from occgrid_parity.check.verdict_text import cause_title
from occgrid_parity.explain.findings import Cause, Likely


@pytest.mark.parametrize(
    ("names", "title"),
    [
        ([], "Cause"),
        (["off-by-one"], "Likely cause"),
        (["off-by-one", "index-rounded"], "Likely cause: one of these 2"),
    ],
)
def test_the_title_says_of_how_many_mistakes_it_is_one(
    names: list[str], title: str
) -> None:
    likely = [Likely(name, "its title", "the lesson", "1") for name in names]
    assert cause_title(Cause(likely, ["one-beam, noise-free"], 90)) == title
