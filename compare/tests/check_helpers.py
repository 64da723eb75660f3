"""What the tests of the check share: programs that run in this process, and commands."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from occgrid.scenario import ScenarioError
from occgrid.sensor import Scan
from occgrid_parity.check.check_options import Options
from occgrid_parity.check.program_check import check_program
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.check.whole_check import check
from occgrid_parity.model.arithmetic import PORTABLE, Arithmetic
from occgrid_parity.model.array_types import Cells
from occgrid_parity.model.mapper_steps import Ends, Mapper
from occgrid_parity.processes.limits import Limits
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.programs.program import program_from_command
from occgrid_parity.programs.runner import Outcome
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import NOISE_FREE, Mode

PROGRAMS = Path(__file__).parent / "check" / "programs"


class MapperRunner:
    """Runs a mapper of the catalogue, or one of a test, without a process."""

    def __init__(
        self,
        mapper: type[Mapper],
        log_odds: bool = True,
        numbers: Arithmetic = PORTABLE,
        reads_scenarios: bool = True,
        takes_seeds: bool = True,
    ) -> None:
        self.mapper = mapper
        self.log_odds = log_odds
        self.numbers = numbers
        self.name = self.words = mapper.name
        self.option = "--run x"
        self.reads_scenarios = reads_scenarios
        self.takes_seeds = takes_seeds
        self.plain_mode = NOISE_FREE
        self.functions: tuple[str, ...] = ()

    def probe(self, function: str, questions: Sequence[str]) -> list[str]:
        raise AssertionError("a mapper has no functions to ask for")

    def run(self, case: Case, mode: Mode) -> Outcome:
        try:
            mapper = self.mapper.of(case, mode.seed, self.numbers)
        except ScenarioError as error:
            said = f"exit status 1: {error}"
            return Outcome(
                0.0, None, "crash", said, status=1, printed=f"{error}\n"
            )
        drawn = mapper.draw()
        pixels = drawn.pixels.astype(np.uint16)
        log_odds = drawn.log_odds if self.log_odds else None
        return Outcome(0.0, Observed(pixels, log_odds, "the test's map"))


def check_mapper(mapper: type[Mapper], save: Path | None = None) -> Verdict:
    """The verdict on a mapper."""
    return check(MapperRunner(mapper), Options(save=save))


def check_words(
    words: str, options: Options | None = None, limits: Limits | None = None
) -> Verdict:
    """The verdict on a command, as ``occgrid-parity check --run`` makes it."""
    program = program_from_command(words, Path.cwd(), 60.0)
    return check_program(program, limits or Limits(), options or Options())


def python_program(folder: Path, code: str) -> str:
    """The command of a Python program that a test has written."""
    path = folder / "program.py"
    path.write_text(code)
    return shlex.join([sys.executable, str(path)])


def names(verdict: Verdict) -> list[str]:
    """The likely causes."""
    return (
        []
        if verdict.cause is None
        else [c.name for c in verdict.cause.candidates]
    )


def wrong_beam(x: float, y: float) -> type[Mapper]:
    """A program that marks the end of the beams that end at exactly this point as free."""

    class WrongBeam(Mapper):
        name = "wrong-beam"

        def ends(self, scan: Scan) -> tuple[Ends, Cells]:
            z, _, _ = self.read(scan.ranges)
            beam = self.beam(scan.pose.theta, scan.angles)
            ex, ey = self.endpoint(scan.pose, beam, z)
            wrong = (ex == x) & (ey == y)
            ends, beams = super().ends(scan)
            return ends._replace(hit=ends.hit & ~wrong[beams]), beams

    return WrongBeam
