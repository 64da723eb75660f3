"""The levels about single functions: the shared vectors, put to the program's probe."""

from __future__ import annotations

from occgrid_parity.check.levels import probe_level
from occgrid_parity.check.verdict import Level
from occgrid_parity.check.wording import listed
from occgrid_parity.formats.plain_text import clean
from occgrid_parity.ports.probing import ProbeError
from occgrid_parity.programs.runner import Runner
from occgrid_parity.suite.vectors import read_vectors

# by the signs of dx and dy and whether |dx| >= |dy|, counterclockwise from the x axis
OCTANTS = {
    (True, True, True): "right, slightly up",
    (True, True, False): "up, slightly right",
    (False, True, False): "up, slightly left",
    (False, True, True): "left, slightly up",
    (False, False, True): "left, slightly down",
    (False, False, False): "down, slightly left",
    (True, False, False): "down, slightly right",
    (True, False, True): "right, slightly down",
}


def check_function(runner: Runner, function: str) -> Level:
    """Whether a function gives every result of its vectors."""
    name, title = probe_level(function), f"the function {function}"
    vectors = read_vectors(function)
    try:
        found = runner.probe(function, vectors.questions)
    except (ProbeError, OSError, ValueError) as error:
        return Level(name, title, "failed", "no answer", clean(str(error)))
    wrong = [
        (question, right, answer)
        for question, right, answer in zip(
            vectors.questions, vectors.answers, found, strict=True
        )
        if right != answer
    ]
    if not wrong:
        return Level(name, title, "passed")
    question, right, answer = wrong[0]
    first = (
        f"{function}({question}) is {right[:200]}, not {clean(answer)[:200]}"
    )
    how = f"your {function} is wrong for {len(wrong)} of {len(found)} arguments; the first: {first}"
    if function == "bresenham":
        how = _octants([question for question, _, _ in wrong], first) or how
    return Level(name, title, "failed", "wrong results", how)


def _octants(wrong: list[str], first: str) -> str:
    """In which octants lines are wrong; empty where all eight have wrong ones."""
    bad = {_octant(question) for question in wrong}
    if len(bad) == len(OCTANTS):
        return ""
    names = listed([name for key, name in OCTANTS.items() if key in bad])
    right = len(OCTANTS) - len(bad)
    return (
        f"your bresenham is right in {right} of 8 octants; lines are wrong that go {names}. The first wrong line: "
        f"{first}"
    )


def _octant(question: str) -> tuple[bool, bool, bool]:
    gx0, gy0, gx1, gy1 = map(int, question.split())
    dx, dy = gx1 - gx0, gy1 - gy0
    return dx >= 0, dy >= 0, abs(dx) >= abs(dy)
