"""class.toml for a class that does an exercise of a starter: how its folders are run, and what each level is worth."""

from __future__ import annotations

import textwrap

from occgrid_handouts.exercises import Exercise
from occgrid_handouts.languages import Language
from occgrid_handouts.starter_programs import DECLARATIONS


def rules_name(exercise: Exercise) -> str:
    """The file's name."""
    return f"exercise-{exercise.number}.class.toml"


def class_rules(language: Language, exercise: Exercise) -> str:
    """The file's text."""
    declaration = DECLARATIONS[language.id]
    about = (
        f"Exercise {exercise.number}, {exercise.title}, in {language.name}. Each submission is the folder "
        f"exercise-{exercise.number} of a student's starter: occgrid-parity check --class SUBMISSIONS --rules "
        f"{rules_name(exercise)}"
    )
    points = "".join(
        f"{level} = {points}\n" for level, points in exercise.points
    )
    return (
        f"{_comment(about)}\n"
        f'assignment = "Exercise {exercise.number}: {exercise.title}"\n'
        'sandbox = "require"\n\n'
        "[program]\n"
        f"{_comment(declaration.needs)}"
        f"{declaration.program}\n"
        f"[limits]\nseconds = {declaration.timeout}\nbuild_seconds = 300\n\n"
        "# What the function that is to be written decides. The other levels are checked, and are worth nothing.\n"
        f"[points]\n{points}"
    )


def _comment(text: str) -> str:
    """Lines that begin with #, or nothing."""
    lines = textwrap.wrap(text, 110, break_on_hyphens=False)
    return "".join(f"# {line}\n" for line in lines)
