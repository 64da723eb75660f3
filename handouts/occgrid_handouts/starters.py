"""Starters: a port in which the functions of one exercise are missing, and the patch that puts them back."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_handouts.archives import zip_bytes
from occgrid_handouts.exercises import (
    EXERCISES,
    Exercise,
    Function,
    native_name,
    not_written,
)
from occgrid_handouts.function_bodies import has_function, without_body
from occgrid_handouts.languages import Language
from occgrid_handouts.packages import SOURCES
from occgrid_handouts.project import Edition
from occgrid_handouts.snippets import read_snippets
from occgrid_handouts.starter_programs import DECLARATIONS
from occgrid_parity.ports.snippets import Snippet

# what answers the shared vectors: the port's probe
PROBES: Mapping[str, tuple[str, ...]] = {
    "python": ("python/tests/probe.py",),
    "cpp": (),  # among its sources
    "java": ("java/src/test/java/occgrid/Probe.java",),
    "matlab": (
        "matlab/tests/run_probe.m",
        "matlab/tests/probe.m",
        "matlab/tests/probe_answers.m",
        "matlab/tests/vector_columns.m",
        "matlab/tests/read_file.m",
        "matlab/tests/write_file.m",
    ),
    "mathematica": (
        "mathematica/tests/probe.wls",
        "mathematica/tests/answers.wl",
    ),
}

NOT_WRITTEN_HPP = """\
// What a program says that comes to a function that is not written yet.
#pragma once

#include <cstdlib>
#include <iostream>

namespace occgrid {

[[noreturn]] inline void not_written(const char* text) {
  std::cerr << text << std::endl;
  std::_Exit(1);
}

}  // namespace occgrid
"""

NOT_WRITTEN_JAVA = """\
package occgrid;

/** What a program says that comes to a function that is not written yet. */
final class NotWritten {
    private NotWritten() {
    }

    /**
     * Says it and ends the program.
     *
     * @param text what is missing
     * @return never; so that the compiler sees where the method ends
     */
    static RuntimeException yet(String text) {
        System.err.println(text);
        System.exit(1);
        return new IllegalStateException(text);
    }
}
"""

NOT_WRITTEN_WL = """\
(* What a program says that comes to a function that is not written yet. A
   notebook stops the evaluation, a script ends. *)

Begin["OccupancyGrid`Private`"];

notWritten[text_] := (
  WriteString["stderr", text <> "\\n"];
  If[TrueQ[$Notebooks], Abort[], Exit[1]]);

End[];
"""

RUN_PY = """\
\"\"\"python run.py --plain --out FOLDER SCENARIO: the program of this folder.\"\"\"

from occgrid.main import main

raise SystemExit(main())
"""


@dataclass(frozen=True)
class Stage:
    """The files of one exercise's project, and the patch with its solution (for patch -p1 in the project's folder)."""

    exercise: Exercise
    files: Mapping[str, bytes]
    patch: str


def make_stages(root: Path, language: Language) -> list[Stage]:
    """The five stages of a language."""
    snippets = read_snippets(root, language)
    sources = _sources(root, language)
    return [
        _stage(language, snippets, sources, exercise) for exercise in EXERCISES
    ]


def starter_functions(
    language: Language, snippets: Mapping[str, Snippet], exercise: Exercise
) -> list[Function]:
    """The functions of an exercise that the port has."""
    return [
        function
        for function in exercise.functions
        if has_function(
            language.id,
            snippets[function.snippet].code,
            native_name(language.id, function.name),
        )
    ]


def _sources(root: Path, language: Language) -> dict[str, str]:
    """The port and its probe, by their names in a stage's folder."""
    patterns = [*SOURCES[language.id], *PROBES[language.id]]
    paths = sorted(
        path
        for pattern in patterns
        for path in root.glob(pattern)
        if path.is_file()
    )
    files = {
        path.relative_to(root / language.folder).as_posix(): path.read_text(
            encoding="utf-8"
        )
        for path in paths
    }
    return _prepared(language.id, files)


def _prepared(language: str, files: dict[str, str]) -> dict[str, str]:
    """With what says that a function is missing, and where Python looks for the port."""
    if language == "python":
        files["ask.py"] = files.pop("tests/probe.py")
        files["run.py"] = RUN_PY
    elif language == "cpp":
        files["include/occgrid/not_written.hpp"] = NOT_WRITTEN_HPP
    elif language == "java":
        files["src/main/java/occgrid/NotWritten.java"] = NOT_WRITTEN_JAVA
    elif language == "mathematica":
        files["OccupancyGrid/NotWritten.wl"] = NOT_WRITTEN_WL
        package = files["OccupancyGrid.wl"]
        files["OccupancyGrid.wl"] = package.replace(
            '{"Usage", ', '{"Usage", "NotWritten", '
        )
    return files


def _stage(
    language: Language,
    snippets: Mapping[str, Snippet],
    sources: Mapping[str, str],
    exercise: Exercise,
) -> Stage:
    files = dict(sources)
    functions = starter_functions(language, snippets, exercise)
    changed = set()
    for function in functions:
        snippet = snippets[function.snippet]
        file = Path(snippet.file).relative_to(language.folder).as_posix()
        changed.add(file)
        name = native_name(language.id, function.name)
        files[file] = without_body(
            language.id,
            files[file],
            name,
            task_text(language.id, function.task),
            not_written(exercise, name),
        )
    if language.id == "cpp":
        for file in changed:
            header = '#include "occgrid/not_written.hpp"\n'
            files[file] = header + files[file]
    patch = "".join(
        _difference(file, files[file], sources[file])
        for file in sorted(changed)
    )
    files["port.toml"] = (
        f'name = "exercise-{exercise.number}"\nlanguage = "{language.name}"\n'
        + DECLARATIONS[language.id].toml()
    )
    files["starter.toml"] = starter_toml(language, exercise, functions)
    files["README.txt"] = readme(language, exercise, functions)
    return Stage(
        exercise, {name: text.encode() for name, text in files.items()}, patch
    )


def _difference(file: str, stub: str, solved: str) -> str:
    return "".join(
        difflib.unified_diff(
            stub.splitlines(keepends=True),
            solved.splitlines(keepends=True),
            f"a/{file}",
            f"b/{file}",
        )
    )


def task_text(language: str, task: str) -> str:
    """The task with its names in the language's own case."""
    if language not in ("java", "mathematica"):
        return task
    return re.sub(r"_([a-z])", lambda match: match[1].upper(), task)


def starter_toml(
    language: Language, exercise: Exercise, functions: Sequence[Function]
) -> str:
    """What ``occgrid-parity check`` reads: the exercise's functions, and the vectors of each."""
    parts = [
        f"exercise = {exercise.number}\n",
        f'title = "{exercise.title}"\n',
        f'scenario = "{exercise.scenario}"\n',
    ]
    for function in functions:
        name = native_name(language.id, function.name)
        vectors = function.name if function.vectors else ""
        parts.append(
            f'\n[[functions]]\nname = "{name}"\nvectors = "{vectors}"\n'
        )
    return "".join(parts)


def readme(
    language: Language, exercise: Exercise, functions: Sequence[Function]
) -> str:
    """What is to be done in this folder."""
    names = [native_name(language.id, f.name) for f in functions]
    lines = [
        f"Exercise {exercise.number}: {exercise.title} ({language.name})",
        "",
        f"To be written: {', '.join(names)}.",
        'Each is marked with the words "To be written". All other code is complete and tested.',
        "",
        "Check your work, as often as you like:",
        "",
        "    occgrid-parity check --port port.toml",
        "",
        "It names the functions that are missing, and for a wrong one its first wrong answer.",
        "Then it compares whole maps. The handout says how the command is installed.",
    ]
    return "\n".join(lines) + "\n"


def starter_zip(
    language: Language, stages: Sequence[Stage], edition: Edition
) -> bytes:
    """All stages in one zip file, a folder each."""
    files = {
        f"exercise-{stage.exercise.number}/{name}": content
        for stage in stages
        for name, content in stage.files.items()
    }
    programs = frozenset(name for name in files if name.endswith(".sh"))
    return zip_bytes(
        f"starter-{language.id}", files, programs, edition.seconds
    )
