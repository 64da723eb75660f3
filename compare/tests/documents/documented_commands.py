"""The commands that the documents print, and what is not run of them, with the reason."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from markdown_it import MarkdownIt

# Each document, and the folder in which its commands are typed.
DOCUMENTS = {
    "README.md": ".",
    "bench/README.md": ".",
    "compare/README.md": "compare",
    "cpp/README.md": ".",
    "docs/checking.md": ".",
    "docs/class.md": ".",
    "docs/cluster.md": ".",
    "docs/mutants.md": ".",
    "docs/real-logs.md": ".",
    "java/README.md": "java",
    "mathematica/README.md": ".",
    "matlab/README.md": ".",
    "python/README.md": "python",
    "scenarios/bad/README.md": ".",
    "scenarios/vectors/README.md": ".",
    "web/README.md": "web",
}

# What a line of a code block begins with, where it is a command.
HEADS = (
    "./occgrid",
    "cmake",
    "cp",
    "cpp/build/",
    "ctest",
    "dask",
    "for",
    "g++",
    "java",
    "make",
    "matlab",
    "mh_lint",
    "mh_style",
    "mkdir",
    "mvn",
    "node",
    "npm",
    "npx",
    "occgrid-parity",
    "octave-cli",
    "pip",
    "python3",
    "sh",
    "sudo",
    "wolframscript",
)
COMMAND = re.compile(
    rf"(?:(?:\.\./)?\.venv/bin/|(?:{'|'.join(map(re.escape, HEADS))})(?:\s|(?<=/)))"
)
COMMENT = re.compile(r"\s+# .*|\s{3,}#.*")

# What is not run, by the beginning of the command; every reason is one of these.
LONG = (
    "takes many minutes; `make all`, `make test` and `make test-long` run it"
)
INSTALLS = "installs software on this machine"
ELSEWHERE = "its own test runs it"
STRANGER = "needs a program, a file or machines that are not in the repository"
NOT_RUN = {
    "make": LONG,
    ".venv/bin/pytest": LONG,
    "../.venv/bin/pytest": LONG,
    ".venv/bin/python bench/run.py": LONG,
    "cmake": LONG,
    "ctest": LONG,
    "mvn": LONG,
    "sudo apt-get": INSTALLS,
    "pip install": INSTALLS,
    "python3 -m venv .venv": INSTALLS,
    "npm ci": INSTALLS,
    "g++ -std=c++17": ELSEWHERE,  # cpp/tests: build_consumer
    "java -cp target/occgrid.jar TwoMaps.java": ELSEWHERE,  # java: ReadmeTest
    "sh mathematica/tests/": ELSEWHERE,
    "octave-cli --no-history --norc --quiet matlab/tests/run_tests.m": ELSEWHERE,
    ".venv/bin/mh_style": ELSEWHERE,
    "node --test": ELSEWHERE,
    "for file in *.log": ELSEWHERE,  # compare/tests/test_bad_input.py
    # compare/tests/test_shared_data.py
    ".venv/bin/python scenarios/bad/generate.py": ELSEWHERE,
    ".venv/bin/python scenarios/vectors/generate.py": ELSEWHERE,
    "matlab -batch": STRANGER,
    "wolframscript": STRANGER,
    "occgrid-parity check --run 'java -cp {port} Chapter9_Lesson1'": STRANGER,
    "occgrid-parity scenario drive.bag": ELSEWHERE,  # compare/tests/test_bags.py
    "mkdir -p /tmp/class": STRANGER,  # in Gradescope's container
    "occgrid-parity check --class class --rules /autograder": STRANGER,
    "cp occgrid-parity-check/": STRANGER,
    "dask": STRANGER,
    "occgrid-parity check --class submissions --scheduler": STRANGER,
    "occgrid-parity run --scheduler": STRANGER,
    "occgrid-parity campaign --worlds 1000000 --scheduler": STRANGER,
    # thousands of worlds; compare/tests has campaigns of a few
    ".venv/bin/occgrid-parity campaign --worlds 10000": LONG,
    "../.venv/bin/occgrid-parity campaign --worlds": LONG,
    "../.venv/bin/occgrid-parity campaign --port cpp --port java": LONG,
    "../.venv/bin/occgrid-parity campaign --run": LONG,
    "sh mathematica/wolfram.sh mathematica/tests/run_tests.wls": ELSEWHERE,
    # every scenario by an interpreter
    "sh mathematica/wolfram.sh mathematica/occgrid.wls --noise-free --out maps scenarios/*.log": LONG,
    "sh mathematica/wolfram.sh mathematica/occgrid.wls --plain": LONG,
}
# Whole lines: the same command with a scenario or a port is run.
NOT_RUN_WHOLE = {
    ".venv/bin/occgrid-parity run": LONG,
    "../.venv/bin/occgrid-parity run": LONG,
    "../.venv/bin/occgrid-parity run --report page": LONG,
    "../.venv/bin/occgrid-parity run --timeout 600": LONG,
}


@dataclass(frozen=True)
class Documented:
    """A command of a document, in one line, and the text that the document shows as its output."""

    document: str
    line: int
    command: str
    output: str = ""

    @property
    def reason(self) -> str:
        """Why it is not run; empty where it is."""
        whole = NOT_RUN_WHOLE.get(self.command, "")
        return whole or next(
            (
                why
                for start, why in NOT_RUN.items()
                if self.command.startswith(start)
            ),
            "",
        )


def documented(root: Path, document: str) -> list[Documented]:
    """The commands of a document, in their order."""
    text = (root / document).read_text(encoding="utf-8")
    found: list[Documented] = []
    for token in MarkdownIt().parse(text):
        if token.type not in ("fence", "code_block"):
            continue
        first = (token.map or [0])[0] + 1 + (token.type == "fence")
        if token.info == "text" and found:
            last = found[-1]
            found[-1] = Documented(
                document, last.line, last.command, token.content
            )
            continue
        if token.info in ("", "sh"):
            found += [
                Documented(document, first + number, command)
                for number, command in _commands(token.content)
            ]
    return found


def _commands(block: str) -> Iterator[tuple[int, str]]:
    """The commands of a block with the numbers of their lines; other lines are texts, files or output."""
    waiting, started = "", 0
    for number, line in enumerate(block.splitlines()):
        whole = waiting + (line.lstrip() if waiting else line)
        if line.endswith("\\"):
            started = started if waiting else number
            waiting = whole[:-1].rstrip() + " "
            continue
        number, waiting = (started if waiting else number), ""
        if COMMAND.match(whole):
            yield number, COMMENT.sub("", whole).rstrip()
