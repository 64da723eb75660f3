"""The five languages that the course teaches in: where their sources lie and how they are called."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Language:
    """One port.

    ``sources`` are patterns of its tested sources below the repository's root, ``syntax`` the name of its highlighting.
    """

    id: str
    name: str
    folder: str
    sources: tuple[str, ...]
    syntax: str


LANGUAGES = (
    Language(
        "python",
        "Python with NumPy",
        "python",
        ("python/occgrid/*.py",),
        "python",
    ),
    Language(
        "cpp",
        "C++ with Eigen",
        "cpp",
        ("cpp/include/occgrid/*.hpp", "cpp/src/*.hpp", "cpp/src/*.cpp"),
        "cpp",
    ),
    Language(
        "java",
        "Java",
        "java",
        ("java/src/main/java/**/*.java",),
        "java",
    ),
    Language(
        "matlab",
        "MATLAB and GNU Octave",
        "matlab",
        ("matlab/*.m", "matlab/+occgrid/**/*.m"),
        "matlab",
    ),
    Language(
        "mathematica",
        "Wolfram Language",
        "mathematica",
        ("mathematica/*.wl*", "mathematica/OccupancyGrid/**/*.wl"),
        "wolfram",
    ),
)

BY_ID = {language.id: language for language in LANGUAGES}
