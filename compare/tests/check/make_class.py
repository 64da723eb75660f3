"""Makes a class of made-up submissions, right and wrong ones: python make_class.py FOLDER [COUNT]

The submissions are mappers in awk and Perl with a number in a comment, so that no two are the same.
"""

from __future__ import annotations

import sys
from pathlib import Path

PROGRAMS = Path(__file__).parent / "programs"
AWK = 'run = ["awk", "-f", "{port}/lesson.awk"%s, "{scenario}"]\n'
PERL = 'run = ["perl", "{port}/lesson.pl"%s, "{mode}", "--out", "{out}", "{scenario}"]\n'
SHELL = 'run = ["sh", "-c", "%s", "map", "{scenario}"]\n'

KINDS = (
    PERL % "",
    AWK % "",
    AWK % ', "-v", "bug=prior"',
    PERL % ', "--bug", "flipped"',
    AWK % ', "-v", "bug=rounded"',
    PERL % "",
    PERL % ', "--bug", "heading"',
    AWK % ', "-v", "bug=last"',
    PERL % ', "--bug", "truncation"',
    SHELL % "kill -SEGV $$",
    AWK % "",
    SHELL % "sleep 1000",
    PERL % ', "--bug", "maxrange"',
    SHELL % "echo no map",
    PERL % ', "--bug", "alsofree"',
)


def make_class(folder: Path, count: int) -> None:
    """Writes ``count`` submissions, s001 and so on, of all kinds in turns."""
    for number in range(1, count + 1):
        place = folder / f"s{number:03d}"
        place.mkdir(parents=True)
        declaration = KINDS[(number - 1) % len(KINDS)]
        (place / "port.toml").write_text(declaration)
        for name in ("lesson.awk", "lesson.pl"):
            if name in declaration:
                text = (PROGRAMS / name).read_text()
                (place / name).write_text(f"{text}# {number}\n")


if __name__ == "__main__":
    make_class(Path(sys.argv[1]), int((sys.argv[2:] or ["150"])[0]))
