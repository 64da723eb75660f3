"""portable_math: all ports answer as Java's StrictMath does, bit for bit."""

from __future__ import annotations

import math
import random
import shutil
import struct
from collections.abc import Callable, Iterator
from fractions import Fraction

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import run_process

from .conftest import PORTS, ROOT, unavailable
from .probe_answers import Answers, answered, ask_ports

FUNCTIONS = ("sin", "cos", "exp", "log")
ARGUMENTS = 100_000
REFERENCE = ROOT / "compare" / "reference" / "StrictMathReference.java"
NAN = 0x7FF8000000000000
SIGN = 1 << 63

# enough for the multiples of pi/2 below, which go up to 2^200
PI_BITS = 400

# upper words at which fdlibm takes another branch, and at which 2/pi's digits run out
REDUCTION_WORDS = [0x3FE921FB, 0x3FF921FB, 0x4002D97C, 0x413921FB, 0x3E400000]
BRANCH_WORDS = {
    "sin": REDUCTION_WORDS,
    "cos": [*REDUCTION_WORDS, 0x3FD33333, 0x3FE90000],
    "exp": [
        0x3FD62E42,
        0x3FF0A2B2,
        0x3E300000,
        0x40862E42,
        0x40874910,
        0x4086232B,
    ],
    "log": [0x00100000, 0x3FF00000, 0x3FE00000, 0x7FE00000],
}


def bits_of(value: float) -> int:
    return int(struct.unpack("<Q", struct.pack("<d", value))[0])


def value_of(bits: int) -> float:
    return float(struct.unpack("<d", struct.pack("<Q", bits))[0])


def near(bits: int, steps: int) -> Iterator[int]:
    """The double and its neighbours, as bits, of both signs."""
    for step in range(-steps, steps + 1):
        word = (bits & ~SIGN) + step
        if 0 <= word < SIGN:
            yield word
            yield word | SIGN


def pi_fraction() -> Fraction:
    """pi to PI_BITS bits, by Machin's formula in integers."""
    one = 1 << (PI_BITS + 32)

    def arctan_of_one_by(n: int) -> int:
        total = term = one // n
        k = 1
        while term:
            term = -term // (n * n)
            k += 2
            total += term // k
        return total

    pi = 4 * (4 * arctan_of_one_by(5) - arctan_of_one_by(239))
    return Fraction(pi, one)


def multiples_of_half_pi(source: random.Random) -> Iterator[int]:
    """The doubles about n*pi/2: every small n, and some up to 2^200."""
    half_pi = pi_fraction() / 2
    small = range(1, 200)
    middle = [source.randrange(200, 2**20) for _ in range(1500)]
    edge = range(2**19 - 40, 2**19 + 40)
    large = [
        source.getrandbits(source.randint(20, 200)) + 1 for _ in range(1500)
    ]
    for n in [*small, *edge, *middle, *large]:
        yield from near(bits_of(float(n * half_pi)), 2)


def special(function: str, source: random.Random) -> Iterator[int]:
    """Every argument that has a reason, as bits."""
    yield from (0, SIGN)  # zeros
    for bits in (
        1,
        2,
        0x000FFFFFFFFFFFFF,
        0x0010000000000000,
        0x7FEFFFFFFFFFFFFF,
    ):
        yield from (bits, bits | SIGN)  # subnormal, smallest normal, largest
    for bits in (
        0x7FF0000000000000,
        NAN,
        0x7FF8000000000001,
        0x7FFFFFFFFFFFFFFF,
    ):
        yield from (bits, bits | SIGN)  # infinities, NaNs
    for word in BRANCH_WORDS[function]:
        for high in (word - 1, word, word + 1):
            for low in (0, 1, 0x7FFFFFFF, 0xFFFFFFFF, source.getrandbits(32)):
                yield from (high << 32 | low, SIGN | high << 32 | low)
    if function == "exp":
        for bits in (
            0x40862E42FEFA39EF,
            0xC0874910D52D3051,
            0x40862E42FEFA39EF,
        ):
            yield from near(bits, 5)  # overflow, underflow
        for value in (1022, 1021, 1020.5, 1074, 1075, 0.5, 1.5):
            yield from near(
                bits_of(value * math.log(2)), 5
            )  # subnormal results, k
    if function == "log":
        for exponent in (0x3FE, 0x3FF, 0x400, 0x001, 0x7FE, 0x3C0):
            for low_word in (
                0x6147A,
                0x6B851,
                0x6A09B,
                0x6A09C,
                0,
                1,
                2,
                0xFFFFD,
                0xFFFFF,
            ):
                yield from near((exponent << 20 | low_word) << 32, 2)
        yield from near(bits_of(1.0), 30)
        for k in range(-1074, 1024, 7):
            yield bits_of(2.0**k)
    if function in ("sin", "cos"):
        # the double that comes nearest to a multiple of pi/2 (Muller, Elementary Functions)
        yield from near(bits_of(math.ldexp(6381956970095103.0, 797)), 1)
        yield from multiples_of_half_pi(source)


def random_arguments(function: str, source: random.Random) -> Iterator[int]:
    """Arguments without end: random bits, subnormals, uniform in several ranges."""
    spans = [1.0, math.pi, 10.0, 100.0, 750.0, 1e6, 1e15, 1e300]
    while True:
        yield source.getrandbits(64)
        yield source.getrandbits(52) | source.getrandbits(1) << 63
        yield (0x41 << 4 | source.getrandbits(9)) << 52 | source.getrandbits(
            52
        )  # huge
        yield bits_of(2.0 ** source.uniform(-1070, 1020))
        yield bits_of(
            1.0 + source.uniform(-1, 1) * 2.0 ** -source.randint(1, 40)
        )
        for span in spans:
            yield bits_of(source.uniform(-span, span))
            if function == "log":
                yield bits_of(source.uniform(0.0, span))


def arguments(function: str, source: random.Random) -> Iterator[int]:
    """All arguments that have a reason, mixed with random ones, and random ones."""
    first = list(special(function, source))
    rest = first[300:]
    source.shuffle(rest)
    randoms = random_arguments(function, source)
    yield from first[:300]
    for one in rest:
        yield one
        yield next(randoms)
    yield from randoms


@pytest.fixture(scope="session")
def questions() -> dict[str, list[str]]:
    """The arguments of each function, as lines; a slow port is asked the first of them."""
    asked = {}
    for seed, function in enumerate(FUNCTIONS):
        lines: dict[str, None] = {}
        source = arguments(function, random.Random(seed))
        while len(lines) < ARGUMENTS:
            lines[f"{next(source):016x}"] = None
        asked[function] = list(lines)
    return asked


@pytest.fixture(scope="session")
def expected(
    questions: dict[str, list[str]], tmp_path_factory: pytest.TempPathFactory
) -> dict[str, list[str]]:
    """What Java's StrictMath answers."""
    if shutil.which("java") is None:
        unavailable(
            "java, whose StrictMath is the reference: install openjdk-17-jdk"
        )
    folder = tmp_path_factory.mktemp("strict-math")
    words = []
    for function, lines in questions.items():
        (folder / function).write_text("".join(f"{line}\n" for line in lines))
        words += [
            function,
            str(folder / function),
            str(folder / f"{function}.out"),
        ]
    finished = run_process(
        ["java", str(REFERENCE), *words],
        cwd=folder,
        stdout=folder / "stdout",
        stderr=folder / "stderr",
        time_limit=120,
    )
    assert finished.succeeded, finished.failure()
    return {
        f: (folder / f"{f}.out").read_text().splitlines() for f in FUNCTIONS
    }


@pytest.fixture(scope="session")
def answers(
    questions: dict[str, list[str]],
    ready: list[Port],
    tmp_path_factory: pytest.TempPathFactory,
) -> Answers:
    """What each port's probe answers to each function."""
    return ask_ports(ready, questions, tmp_path_factory.mktemp("probes"))


def shown(line: str) -> str:
    return f"{line} ({value_of(int(line, 16))!r})"


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_answers_as_strict_math(
    questions: dict[str, list[str]],
    expected: dict[str, list[str]],
    answers: Answers,
    need: Callable[[str], Port],
    port: str,
    function: str,
) -> None:
    limit = need(port).probe_lines
    found = answered(answers, port, function)
    asked, right = questions[function], expected[function]
    assert len(asked) >= ARGUMENTS
    assert len(right) == len(asked)
    assert len(found) == min(len(asked), limit or len(asked))
    wrong = [i for i, answer in enumerate(found) if answer != right[i]]
    lines = [
        f"{port}: {len(wrong)} of {len(found)} answers of {function} are not StrictMath's"
    ]
    for i in wrong[:5]:
        lines.append(f"  {function}({shown(asked[i])})")
        lines.append(f"    found    {found[i]}")
        lines.append(f"    expected {shown(right[i])}")
    if wrong:
        pytest.fail("\n".join(lines), pytrace=False)


@pytest.mark.parametrize("function", FUNCTIONS)
def test_the_arguments_reach_every_corner(
    questions: dict[str, list[str]], function: str
) -> None:
    """Also those that a slow port is asked: the first 2,000."""
    for asked in (questions[function], questions[function][:2000]):
        values = [value_of(int(line, 16)) for line in asked]
        assert len(set(asked)) == len(asked)
        assert {"0000000000000000", "8000000000000000"} <= set(asked)
        assert any(map(math.isnan, values))
        assert math.inf in values
        assert -math.inf in values
        assert sum(0 < abs(v) < 2.0**-1022 for v in values) > 20
        assert sum(1e20 < abs(v) < math.inf for v in values) > 20
        assert sum(abs(v) < 10 for v in values) > 200


def test_the_reference_answers_known_values(
    questions: dict[str, list[str]], expected: dict[str, list[str]]
) -> None:
    one = f"{bits_of(1.0):016x}"
    zero = "0" * 16
    for function, argument, answer in [
        ("sin", zero, zero),
        ("cos", zero, one),
        ("exp", zero, one),
        ("log", one, zero),
        ("log", zero, f"{bits_of(-math.inf):016x}"),
        ("sin", f"{bits_of(math.inf):016x}", f"{NAN:016x}"),
    ]:
        assert (
            expected[function][questions[function].index(argument)] == answer
        )
    # the sine of the double nearest to pi is what pi lacks: 1.2246467991473532e-16
    index = questions["sin"].index(f"{bits_of(math.pi):016x}")
    assert expected["sin"][index] == f"{bits_of(1.2246467991473532e-16):016x}"
