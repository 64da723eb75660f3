"""Points in the forms that Moodle and Canvas import, by a roster that says who handed in what."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.course.class_summary import Submission, named_mistake
from occgrid_parity.course.points import score
from occgrid_parity.course.rules import Rules

MOODLE = "moodle.csv"
CANVAS = "canvas.csv"
KEY = "submission"
CANVAS_COLUMNS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")


class RosterError(ValueError):
    """A roster that cannot be used; the text names the file and the line."""


@dataclass(frozen=True)
class Roster:
    """Who handed in what: a line for each person, with the name of a submission's folder in column ``submission``."""

    columns: tuple[str, ...]
    people: tuple[dict[str, str], ...]

    def missing(self, submissions: Sequence[Submission]) -> list[str]:
        """Submissions that no line of the roster names."""
        known = {person[KEY] for person in self.people}
        return [one.name for one in submissions if one.name not in known]


def read_roster(path: Path) -> Roster:
    """The roster in a CSV file. Raises RosterError where it cannot be used."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise RosterError(f"{path}: {error}") from error
    reader = csv.DictReader(io.StringIO(text, newline=""))
    columns = tuple(reader.fieldnames or ())
    if KEY not in columns:
        raise RosterError(f"{path}:1: there is no column {KEY}")
    if len(set(columns)) < len(columns):
        raise RosterError(f"{path}:1: two columns have one name")
    people: list[dict[str, str]] = []
    for person in reader:
        if None in person or None in person.values():
            raise RosterError(
                f"{path}:{reader.line_num}: not as many columns as the first line has"
            )
        people.append(person)
    return Roster(columns, tuple(people))


def moodle_csv(
    submissions: Sequence[Submission], roster: Roster, rules: Rules
) -> str:
    """The roster's own columns, with points and feedback; in Moodle, map one of them to the user."""
    found = {one.name: one for one in submissions}
    columns = [name for name in roster.columns if name != KEY]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*columns, rules.assignment, "Feedback"])
    for person in roster.people:
        one = found.get(person[KEY])
        if one is not None:
            writer.writerow(
                [
                    *(person[name] for name in columns),
                    f"{score(one.verdict, rules).points:g}",
                    feedback_line(one),
                ]
            )
    return text.getvalue()


def canvas_csv(
    submissions: Sequence[Submission], roster: Roster, rules: Rules
) -> str:
    """Canvas's columns as far as the roster has them, and one for the assignment, with the points possible."""
    found = {one.name: one for one in submissions}
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*CANVAS_COLUMNS, rules.assignment])
    maximum = max(
        (score(one.verdict, rules).maximum for one in submissions), default=0.0
    )
    blanks = [""] * (len(CANVAS_COLUMNS) - 1)
    writer.writerow(["    Points Possible", *blanks, f"{maximum:g}"])
    for person in roster.people:
        one = found.get(person[KEY])
        if one is not None:
            points = score(one.verdict, rules).points
            own = [person.get(name, "") for name in CANVAS_COLUMNS]
            writer.writerow([*own, f"{points:g}"])
    return text.getvalue()


def feedback_line(one: Submission) -> str:
    """The verdict in a line: what it is, and the mistake where it has a name."""
    mistake = named_mistake(one.verdict)
    said = one.verdict.summary
    return f"{said} (mistake: {mistake})" if mistake else said
