"""Mapping the scenarios with --plain runs every printed line: measured in Python, C++ and JavaScript, which have tools.

Module fast is no part of that program; a line of an error's exit and a comment are no part of mapping.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from occgrid_parity.ports.contributing import module_snippets, read_table
from occgrid_parity.ports.snippets import Snippet, parse_snippets
from occgrid_parity.ports.sources import module_files, plain
from occgrid_parity.suite.modes import DEFAULT_MODES

from .conftest import ROOT, unavailable

pytestmark = pytest.mark.long

PRINTED = [name for name in module_snippets(ROOT) if name != "fast"]
SCENARIOS = sorted((ROOT / "scenarios").glob("*.log"))
NOT_MAPPING = re.compile(r"\s*(raise|throw)\b|\W*$")
"""A line of an error's exit; a bracket alone, which gcov counts for what an error leaves behind."""

NOT_NEEDED = {
    name.strip("`"): function
    for name, function, _ in read_table(ROOT, "Printed, but not mapped with")
}
"""Snippets that mapping does not need, all of them, one function or one line."""

Lines = dict[Path, set[int]]
"""For each source file the lines that hold code and were not run."""


def command(*words: str | Path, **environment: str) -> str:
    """Runs a command and gives what it printed; fails the test where it fails."""
    done = subprocess.run(
        [str(word) for word in words],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        pytest.fail(f"{words}: {done.stdout}{done.stderr}", pytrace=False)
    return done.stdout


def map_all(folder: Path, *program: str | Path, **environment: str) -> None:
    """Maps all scenarios by the plain program, without noise and with it, and the built-in lesson."""
    for mode in DEFAULT_MODES:
        words = ["--plain", *mode.arguments, "--out", str(folder / "maps")]
        command(*program, *words, *SCENARIOS, **environment)
    command(*program, "--plain", "--out", folder / "maps", **environment)


def python_lines(folder: Path) -> Lines:
    data = {"COVERAGE_FILE": str(folder / "coverage")}
    tool = (sys.executable, "-m", "coverage")
    source = ROOT / "python/occgrid"
    map_all(
        folder,
        *(*tool, "run", "--append", "--source", str(source)),
        *("-m", "occgrid"),
        **data,
    )
    command(*tool, "json", "-o", folder / "coverage.json", **data)
    found = json.loads((folder / "coverage.json").read_text())["files"]
    return {
        Path(name).resolve(): set(one["missing_lines"])
        for name, one in found.items()
    }


def cpp_lines(folder: Path) -> Lines:
    for tool in ("cmake", "g++", "gcov"):
        if shutil.which(tool) is None:
            unavailable(f"no {tool}")
    build = folder / "build"
    command(
        *("cmake", "-S", ROOT / "cpp", "-B", build),
        *("-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_BUILD_TYPE=Debug"),
        "-DCMAKE_CXX_FLAGS=-O0 --coverage",
    )
    command("cmake", "--build", build, "--target", "occgrid")
    map_all(folder, build / "occgrid")
    counts: dict[Path, dict[int, int]] = {}
    for data in sorted(build.rglob("*.gcda")):
        printed = command("gcov", "--json-format", "--stdout", data)
        for line in printed.splitlines():
            for file in json.loads(line)["files"]:
                path = Path(file["file"]).resolve()
                of_file = counts.setdefault(path, {})
                for one in file["lines"]:
                    number = one["line_number"]
                    of_file[number] = of_file.get(number, 0) + one["count"]
    return {
        path: {number for number, count in of_file.items() if count == 0}
        for path, of_file in counts.items()
    }


def javascript_lines(folder: Path) -> Lines:
    if shutil.which("node") is None:
        unavailable("no node")
    records = folder / "records"
    map_all(
        folder, "node", ROOT / "web/cli.mjs", NODE_V8_COVERAGE=str(records)
    )
    runs: dict[Path, list[set[int]]] = {}
    for record in sorted(records.glob("*.json")):
        for script in json.loads(record.read_text())["result"]:
            if script["url"].startswith((ROOT / "web/src").as_uri()):
                path = Path(script["url"].removeprefix("file://"))
                text = path.read_text(encoding="utf-8")
                runs.setdefault(path, []).append(not_run(text, script))
    return {path: set.intersection(*several) for path, several in runs.items()}


def not_run(text: str, script: Any) -> set[int]:
    """The lines of a script whose first character of code was not run, by V8's nested ranges, the outer ones first."""
    counts = [1] * len(text)
    for function in script["functions"]:
        for span in function["ranges"]:
            start, end = span["startOffset"], span["endOffset"]
            counts[start:end] = [span["count"]] * (end - start)
    numbers, at = set(), 0
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        code = re.match(r"[\s{}();]*(?!//|/?\*)", line)
        if code and code.end() < len(line) and not counts[at + code.end()]:
            numbers.add(number)
        at += len(line)
    return numbers


LANGUAGES: dict[str, Callable[[Path], Lines]] = {
    "python": python_lines,
    "cpp": cpp_lines,
    "web": javascript_lines,
}


def unused(port: str, missing: Lines) -> Iterator[str]:
    """The printed lines of a port that no run has taken."""
    files = module_files(ROOT / port, PRINTED)
    for path in (path for paths in files.values() for path in paths):
        text = path.read_text(encoding="utf-8")
        file = path.relative_to(ROOT).as_posix()
        lines = text.splitlines()
        for snippet in parse_snippets(file, text):
            not_needed = set(lines_not_needed(snippet, lines))
            found = [
                number
                for number in range(snippet.first, snippet.last + 1)
                if number in missing.get(path.resolve(), ())
                and number not in not_needed
                and NOT_MAPPING.match(lines[number - 1]) is None
            ]
            if len(found) == 1 and NOT_NEEDED.get(snippet.name) == "one line":
                continue
            for number in found:
                line = lines[number - 1].strip()
                yield f"{file}:{number}: {snippet.name}: {line}"


def lines_not_needed(snippet: Snippet, lines: list[str]) -> range:
    """The lines of a snippet, or of a function in it up to the next blank line, that the table names."""
    function = NOT_NEEDED.get(snippet.name)
    if function in (None, "one line"):
        return range(0)
    if function == "all":
        return range(snippet.first, snippet.last + 1)
    wanted = plain(str(function).strip("`"))
    for first in range(snippet.first, snippet.last + 1):
        if re.search(rf"\b{wanted}\(", plain(lines[first - 1])):
            last = first
            while last <= snippet.last and lines[last - 1].strip():
                last += 1
            return range(first, last)
    return range(0)


@pytest.mark.parametrize("port", LANGUAGES)
def test_every_printed_line_is_run(port: str, tmp_path: Path) -> None:
    missing = LANGUAGES[port](tmp_path)
    assert missing, f"{port}: nothing was measured"
    found = list(unused(port, missing))
    assert not found, "\n".join(found)
