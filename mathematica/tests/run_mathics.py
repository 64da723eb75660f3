"""Runs the package's unit tests on Mathics3, a second interpreter of the Wolfram Language, with contexts.

    build/mathics/bin/python mathematica/tests/run_mathics.py [NAME...]

NAME is a test file, as Grid for tests/Grid.wlt; without any: all that stand in TESTS. Needs Mathics3 (from PyPI).

The package is loaded by its name, Needs["OccupancyGrid`"]. Then no name may have come into the wrong context, and the
tests run one by one. What Mathics cannot do stands in mathematica/README.md, in the table below "What Mathics3 cannot
run", with the reason; a test that is in the table and passes is a failure too, so that the table stays right. Only
where the reason begins with "not tried" it is not run: it takes too long, or ends Mathics. Prints what failed,
then N passed, N failed, N cannot run; ends with status 1 where something failed.
"""

from __future__ import annotations

import fnmatch
import functools
import operator
import re
import signal
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType
from typing import Any

from mathics.core.load_builtin import import_and_load_builtins

import_and_load_builtins()

from mathics.core.atoms import Integer  # noqa: E402
from mathics.core.attributes import A_LISTABLE, A_PROTECTED  # noqa: E402
from mathics.core.builtin import Builtin  # noqa: E402
from mathics.core.parser import MathicsFileLineFeeder  # noqa: E402
from mathics.session import MathicsSession  # noqa: E402

HERE = Path(__file__).resolve().parent
PORT = HERE.parent
TESTS = [
    "Arguments", "Noise", "Grid", "Ray", "World", "Sensor", "Scenario", "Lesson", "Mapper", "Fast", "MapWriter",
    "PortableMath",
]  # fmt: skip
SECONDS = 120  # of processor time, for one test

# VerificationTest, which Mathics has not: whether the test passes.
SHIM = """
SetAttributes[VerificationTest, HoldFirst];
VerificationTest[input_, expected_, options___] := With[{actual = input},
  {TestID /. {options}, SameQ[actual, expected], ToString[actual, InputForm]}];
"""
# Capital names are public, or of the language: none may be private, and none of the package's global.
STRAY = (
    'Select[Names["OccupancyGrid`Private`*"], StringMatchQ[#,'
    ' RegularExpression["(.*`)?[$]?[A-Z].*"]] &]'
)


class BitXor(Builtin):
    """The function of the language that Mathics has not: without it there is no noise."""

    attributes = A_LISTABLE | A_PROTECTED

    def eval(self, words: Any, evaluation: Any) -> Integer:
        "BitXor[words__Integer]"
        values = [word.value for word in words.get_sequence()]
        return Integer(functools.reduce(operator.xor, values))


class TooSlow(Exception):
    """A test that takes longer than SECONDS."""


def ring(_signal: int, _frame: FrameType | None) -> None:
    raise TooSlow(f"more than {SECONDS} s")


def table() -> dict[str, str]:
    """The tests that Mathics cannot run, `FILE: TestID` with `*` for any text, and the reason."""
    text = (PORT / "README.md").read_text(encoding="utf-8")
    section = text.split("\n## What Mathics3 cannot run\n")[1].split("\n## ")[
        0
    ]
    rows = re.findall(r"^\| `([^`]+)` \| (.+) \|$", section, re.MULTILINE)
    return dict(rows)


class Kernel:
    """One session, with the package."""

    def __init__(self) -> None:
        self.session = MathicsSession(add_builtin=True, catch_interrupt=False)
        BitXor(expression=False).contribute(self.session.definitions)
        sys.setrecursionlimit(20000)

    def run(self, code: str) -> Any:
        return self.session.evaluate(code)

    def run_all(self, code: str) -> None:
        for statement in code.strip().split(";\n"):
            self.run(statement)

    def load(self) -> list[str]:
        """Load the package and what tests share; returns what went wrong."""
        wrong = []
        # Mathics counts the steps of a whole session against it.
        self.run("$IterationLimit = Infinity")
        self.run(f'$Path = Prepend[$Path, "{PORT}"]')
        self.run('Needs["OccupancyGrid`"]')
        wrong += [f"message while loading: {text}" for text in self.messages()]
        stray = str(self.run(STRAY))
        if stray != "{}":
            wrong.append(f"names in the wrong context: {stray}")
        for name in ("UpdateGridFromScan", "MapScenario", "OccgridMain"):
            context = str(self.run(f"Context[{name}]"))
            if context != '"OccupancyGrid`"':
                wrong.append(f"{name} is in the context {context}")
        self.run(
            '$ContextPath = Prepend[$ContextPath, "OccupancyGrid`Private`"]'
        )
        self.run(f'here = "{HERE}"')
        for shared in ("answers", "shared"):
            self.run(f'Get["{HERE / shared}.wl"]')
        self.run_all(SHIM)
        return wrong

    def messages(self) -> list[str]:
        return [
            str(getattr(out, "text", out))
            for out in self.session.evaluation.out
        ]

    def tests(
        self, file: Path, slow: Callable[[str], bool]
    ) -> Iterator[tuple[str, bool, str]]:
        """The tests of a file: TestID, whether it passes, what came out."""
        unread = re.findall(r'TestID -> "(.*)"\]', file.read_text("utf-8"))
        with file.open(encoding="utf-8") as lines:
            feeder = MathicsFileLineFeeder(lines)
            while not feeder.empty():
                query = self.session.evaluation.parse_feeder(feeder)
                if query is None:
                    continue
                name = test_id(query)
                if name in unread:
                    unread.remove(name)
                if name is not None and slow(name):
                    yield name, False, "not tried"
                    continue
                passes, text = self.one(query)
                if name is not None:
                    yield name, passes, text
        for name in unread:
            yield name, False, "Mathics does not read it"

    def one(self, query: Any) -> tuple[bool, str]:
        """Evaluate; an interpreter's crash is a test that does not pass."""
        signal.signal(signal.SIGPROF, ring)
        signal.setitimer(signal.ITIMER_PROF, SECONDS)
        try:
            self.session.evaluation.out.clear()
            self.session.evaluation.iteration_count = 0
            self.session.evaluation.recursion_depth = 0
            result = query.evaluate(self.session.evaluation)
            elements = getattr(result, "elements", ())
            if len(elements) == 3:
                return str(elements[1]) == "System`True", str(elements[2])[
                    :300
                ]
            return False, str(result)[:300]
        except Exception as error:
            return False, f"{type(error).__name__}: {error}"[:300]
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)


def test_id(query: Any) -> str | None:
    """The TestID of a VerificationTest, None for another expression."""
    if not str(getattr(query, "head", "")).endswith("VerificationTest"):
        return None
    return str(query.elements[2].elements[1]).strip('"')


def main(names: list[str]) -> int:
    kernel = Kernel()
    failures = [f"FAILED {text}" for text in kernel.load()]
    cannot = table()
    used: set[str] = set()
    passed = listed = 0

    def entries_of(key: str) -> list[str]:
        return [p for p in cannot if fnmatch.fnmatchcase(key, p)]

    for name in names or TESTS:
        started = time.process_time()

        def slow(test: str, name: str = name) -> bool:
            found = entries_of(f"{name}: {test}")
            return any(cannot[p].startswith("not tried") for p in found)

        for test, passes, text in kernel.tests(HERE / f"{name}.wlt", slow):
            key = f"{name}: {test}"
            entries = entries_of(key)
            used.update(entries)
            if passes and entries:
                failures.append(
                    f"FAILED {key}\n  runs, and stands in README.md's table as {entries[0]}"
                )
            elif passes:
                passed += 1
            elif entries:
                listed += 1
            else:
                failures.append(f"FAILED {key}\n  {text}")
            seconds = time.process_time() - started
            started = time.process_time()
            print(
                f"{'ok  ' if passes else '    '} {seconds:5.1f} s  {key}",
                file=sys.stderr,
                flush=True,
            )
    if not names:
        failures += [
            f"FAILED no test is {entry}"
            for entry in cannot
            if entry not in used
        ]
    print("\n".join(failures)) if failures else None
    print(f"{passed} passed, {len(failures)} failed, {listed} cannot run")
    return 1 if failures or not passed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
