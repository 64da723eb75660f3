"""The students' edition of one language as a zip file that needs nothing else of the suite."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from occgrid_handouts.archives import zip_bytes
from occgrid_handouts.languages import Language
from occgrid_handouts.project import Edition

SCENARIO = "scenarios/one-beam.log"

# what of the repository a language's programs need
SOURCES: Mapping[str, tuple[str, ...]] = {
    "python": ("python/occgrid/*.py",),
    "cpp": (
        "cpp/CMakeLists.txt",
        "cpp/cmake/*",
        "cpp/include/**/*.hpp",
        "cpp/src/*.[ch]pp",
        "cpp/tests/probe.cpp",
        "cpp/tests/vector_functions.[ch]pp",
    ),
    "java": ("java/src/main/java/**/*.java",),
    "matlab": (
        "matlab/+occgrid/**/*.m",
        "matlab/occgrid_cli.m",
        "matlab/octave_is_up.m",
        "matlab/matlab.sh",
    ),
    "mathematica": (
        "mathematica/OccupancyGrid.wl",
        "mathematica/OccupancyGrid/*.wl",
        "mathematica/occgrid.wls",
        "mathematica/wolfram.sh",
    ),
}

# what is to be installed, and how to map the one beam
FIRST_STEPS: Mapping[str, tuple[str, str]] = {
    "python": (
        "Python 3.11 or later; pip install jupyter numpy matplotlib",
        "jupyter notebook python.ipynb",
    ),
    "cpp": (
        "a C++17 compiler, CMake 3.16 or later, Eigen 3 (Debian: g++ cmake libeigen3-dev)",
        "cmake -S cpp -B build && cmake --build build\n"
        "    build/occgrid --plain --out maps scenarios/one-beam.log",
    ),
    "java": (
        "a Java development kit, version 17 or later",
        "javac -d classes java/src/main/java/occgrid/*.java\n"
        "    java -cp classes occgrid.Main --plain --out maps scenarios/one-beam.log",
    ),
    "matlab": (
        "MATLAB, or GNU Octave 7 or later",
        "open matlab_handout.m and run its sections, or: octave-cli matlab_handout.m",
    ),
    "mathematica": (
        "Mathematica, or Wolfram Engine",
        "open mathematica.nb and evaluate its input cells",
    ),
}


def package_name(language: Language) -> str:
    """The name of the zip file, which is its folder's name, too."""
    return f"occupancy-grid-{language.id}"


def package_sources(root: Path, language: Language) -> dict[str, bytes]:
    """What the programs of the edition need, by its name in the repository and in the package."""
    paths = [root / SCENARIO]
    for pattern in SOURCES[language.id]:
        found = sorted(path for path in root.glob(pattern) if path.is_file())
        if not found:
            raise FileNotFoundError(f"nothing is named {pattern}")
        paths += found
    return {
        path.relative_to(root).as_posix(): path.read_bytes() for path in paths
    }


def make_package(
    root: Path,
    language: Language,
    edition: Edition,
    made: Mapping[str, bytes],
    extra: str | None,
    pages: Mapping[str, bytes],
) -> bytes:
    """The zip file.

    ``made`` are the files of the students' edition, ``extra`` names the notebook or script among them.
    """
    page = made[f"{language.id}.html"].decode()
    files = {
        "handout.pdf": made[f"{language.id}.pdf"],
        "handout.html": without_other_languages(page).encode(),
        **pages,
        **package_sources(root, language),
    }
    if extra is not None:
        files[extra] = made[extra]
    files["README.txt"] = readme(language, edition, sorted(pages)).encode()
    programs = frozenset(name for name in files if name.endswith(".sh"))
    return zip_bytes(package_name(language), files, programs, edition.seconds)


def without_other_languages(page: str) -> str:
    """The page without its links to the other languages' pages, which are not in the package."""
    return re.sub(r'<p class="others">.*?</p>', "", page, flags=re.DOTALL)


def readme(language: Language, edition: Edition, pages: list[str]) -> str:
    """Ten lines: what is in the package, and the first step."""
    install, command = FIRST_STEPS[language.id]
    listed = {
        "play.html": "play.html     the lesson to try out in a browser",
        "check.html": "check.html    compares a map from a file with the right map",
    }
    lines = [
        f"Occupancy grid mapping: {language.name}",
        "",
        "handout.pdf   the handout to print; handout.html is the same to read on a screen",
        *(listed[name] for name in pages),
        f"{language.folder + '/':13} the program that the handout explains",
        "",
        f"You need {install}.",
        f"Start here, in this folder:\n\n    {command}\n",
        f"occgrid {edition.version}, commit {edition.commit}",
    ]
    return "\n".join(lines) + "\n"
