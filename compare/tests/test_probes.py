"""Philox and the line: all ports answer as the contract's text does."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

from occgrid_parity.ports.declaration import Port

from .conftest import PORTS
from .probe_answers import Answers, answered, ask_ports

MASK = 0xFFFFFFFF

# SPEC section 3.3: the known answers published with Philox
KNOWN = [
    ("00000000 " * 6, "6627e8d5 e169c58d bc57ac4c 9b00dbd8"),
    ("ffffffff " * 6, "408f276d 41c83b0e a20bc7c6 6d5451fd"),
    (
        "243f6a88 85a308d3 13198a2e 03707344 a4093822 299f31d0",
        "d16cfe09 94fdcceb 5001e420 24126ea1",
    ),
]


def philox(words: list[int]) -> list[int]:
    """Philox4x32-10 as SPEC section 3.3 writes it."""
    c0, c1, c2, c3, k0, k1 = words
    for _ in range(10):
        left, right = 0xCD9E8D57 * c2, 0xD2511F53 * c0
        c0, c1, c2, c3 = (
            (left >> 32) ^ c1 ^ k0,
            left & MASK,
            (right >> 32) ^ c3 ^ k1,
            right & MASK,
        )
        k0, k1 = (k0 + 0x9E3779B9) & MASK, (k1 + 0xBB67AE85) & MASK
    return [c0, c1, c2, c3]


def philox_questions() -> tuple[list[str], list[str]]:
    """Words and answers: the known ones, counters as mapping uses them, random ones."""
    source = random.Random(11)
    asked = [words.strip() for words, _ in KNOWN]
    for _ in range(500):
        seed, scan = source.getrandbits(32), source.randrange(3000)
        beam = source.randrange(400)
        asked.append(
            f"{scan:08x} {beam:08x} 00000000 00000000 {seed:08x} 00000000"
        )
    for _ in range(5000):
        asked.append(
            " ".join(f"{source.getrandbits(32):08x}" for _ in range(6))
        )
    answers = []
    for line in asked:
        words = philox([int(word, 16) for word in line.split()])
        answers.append(" ".join(f"{word:08x}" for word in words))
    return asked, answers


def bresenham(gx0: int, gy0: int, gx1: int, gy1: int) -> list[tuple[int, int]]:
    """The line by its closed form (SPEC section 2.4), not by its loop."""
    dx, dy = abs(gx1 - gx0), abs(gy1 - gy0)
    sx = 1 if gx0 < gx1 else -1
    sy = 1 if gy0 < gy1 else -1
    a, b = max(dx, dy), min(dx, dy)
    cells = []
    for k in range(a + 1):
        minor = (2 * k * b + a - 1) // (2 * a) if a else 0
        along, across = (k, minor) if dx >= dy else (minor, k)
        cells.append((gx0 + sx * along, gy0 + sy * across))
    return cells


def bresenham_questions() -> tuple[list[str], list[str]]:
    """Lines and their cells: all short ones, then long ones, far from the origin too."""
    source = random.Random(12)
    lines = [(0, 0, x, y) for x in range(-9, 10) for y in range(-9, 10)]
    for _ in range(700):
        x, y = source.randint(-500, 500), source.randint(-500, 500)
        lines.append(
            (
                x,
                y,
                x + source.randint(-300, 300),
                y + source.randint(-300, 300),
            )
        )
    for _ in range(100):  # ties: the minor extent is half of the major one
        x, y, half = (source.randint(-100, 100) for _ in range(3))
        lines.append((x, y, x + 2 * half, y + source.choice((-half, half))))
    for _ in range(50):
        x, y = (source.randint(-(10**9), 10**9) for _ in range(2))
        lines.append(
            (x, y, x + source.randint(-50, 50), y + source.randint(-50, 50))
        )
    asked = [" ".join(map(str, line)) for line in lines]
    answers = [
        " ".join(f"{x}:{y}" for x, y in bresenham(*line)) for line in lines
    ]
    return asked, answers


QUESTIONS = {"philox": philox_questions, "bresenham": bresenham_questions}


@pytest.fixture(scope="session")
def questions() -> dict[str, tuple[list[str], list[str]]]:
    """Questions and right answers of both functions."""
    return {function: make() for function, make in QUESTIONS.items()}


@pytest.fixture(scope="session")
def answers(
    questions: dict[str, tuple[list[str], list[str]]],
    ready: list[Port],
    tmp_path_factory: pytest.TempPathFactory,
) -> Answers:
    """What each port's probe answers."""
    folder = tmp_path_factory.mktemp("probes")
    asked = {function: questions[function][0] for function in questions}
    return ask_ports(ready, asked, folder)


@pytest.mark.parametrize("function", QUESTIONS)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_answers_as_the_contract(
    questions: dict[str, tuple[list[str], list[str]]],
    answers: Answers,
    need: Callable[[str], Port],
    port: str,
    function: str,
) -> None:
    need(port)
    found = answered(answers, port, function)
    asked, right = questions[function]
    assert found
    for question, answer, expected in zip(
        asked[: len(found)], found, right[: len(found)], strict=True
    ):
        assert answer == expected, f"{port}: {function}({question})"


def test_the_known_answers_are_published_ones() -> None:
    asked, answers = philox_questions()
    for words, answer in KNOWN:
        assert answers[asked.index(words.strip())] == answer


def test_the_closed_form_is_the_loop() -> None:
    """SPEC section 2.4 gives both; the test above uses the one, most ports the other."""
    for line in bresenham_questions()[0]:
        gx, gy, gx1, gy1 = map(int, line.split())
        cells = bresenham(gx, gy, gx1, gy1)
        dx, dy = abs(gx1 - gx), abs(gy1 - gy)
        sx, sy = (1 if gx < gx1 else -1), (1 if gy < gy1 else -1)
        err = dx - dy
        walked = [(gx, gy)]
        while (gx, gy) != (gx1, gy1):
            e2 = 2 * err
            if e2 > -dy:
                err, gx = err - dy, gx + sx
            if e2 < dx:
                err, gy = err + dx, gy + sy
            walked.append((gx, gy))
        assert walked == cells
