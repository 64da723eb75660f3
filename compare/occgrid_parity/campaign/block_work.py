"""The pieces of work of a campaign: each can be done in any process, on any machine."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from occgrid_parity.campaign.judging import (
    Finding,
    Judge,
    ProgramJudge,
    judge_ports,
)
from occgrid_parity.campaign.numbered_worlds import mode_of, world
from occgrid_parity.campaign.shortening import shortened
from occgrid_parity.ports.parcels import Traveller, port_of, ready
from occgrid_parity.processes.limits import Limits
from occgrid_parity.programs.program import Program
from occgrid_parity.suite.cases import Case


@dataclass(frozen=True)
class Subjects:
    """What is asked: ports, and a program that is none."""

    ports: tuple[Traveller, ...]
    program: Program | None = None
    limits: Limits = field(default_factory=Limits)

    def only(self, name: str) -> Subjects:
        """One program alone."""
        if self.program is not None and self.program.name == name:
            return replace(self, ports=())
        ports = [one for one in self.ports if port_of(one).name == name]
        return replace(self, ports=tuple(ports), program=None)


@dataclass(frozen=True)
class Block:
    """A piece of work: worlds that are mapped in one mode."""

    seed: int
    numbers: range
    subjects: Subjects


@dataclass(frozen=True)
class BlockFindings:
    """What came of a block, by the names of the programs and in the order of its worlds."""

    findings: dict[str, list[Finding]]

    @property
    def lacks_a_port(self) -> bool:
        """Whether this machine could not ask some port."""
        return any(
            one.status == "skipped"
            for some in self.findings.values()
            for one in some
        )


def map_block(block: Block) -> BlockFindings:
    """Maps the worlds of a block with every program."""
    numbers, subjects = block.numbers, block.subjects
    cases = [world(block.seed, number) for number in numbers]
    mode = mode_of(block.seed, numbers[0])
    found: dict[str, list[Finding]] = {}
    if subjects.ports:
        found = judge_ports(ready(subjects.ports), cases, mode)
    if subjects.program is not None:
        with tempfile.TemporaryDirectory(prefix="occgrid-campaign-") as place:
            judge = _judge_of(subjects, Path(place))
            found[subjects.program.name] = judge(cases, mode)
    return BlockFindings(found)


def _judge_of(subjects: Subjects, folder: Path) -> Judge:
    """The judge of the only program or port."""
    if subjects.program is not None:
        program = ProgramJudge(subjects.program, folder, subjects.limits)
        return program.judge
    built = ready(subjects.ports)
    name = built[0].port.name
    return lambda cases, mode: judge_ports(built, cases, mode)[name]


@dataclass(frozen=True)
class Shortening:
    """A piece of work: the least of a world that shows how the only program differs there."""

    seed: int
    number: int
    subjects: Subjects
    status: str


def shorten(task: Shortening) -> Case:
    """The shortened scenario; the whole one where the program does not do it again."""
    case = world(task.seed, task.number)
    mode = mode_of(task.seed, task.number)
    with tempfile.TemporaryDirectory(prefix="occgrid-campaign-") as place:
        judge = _judge_of(task.subjects, Path(place))

        def shows(cases: Sequence[Case]) -> list[bool]:
            named = [
                Case(f"part-{number}", one.data)
                for number, one in enumerate(cases)
            ]
            found = judge(named, mode) if named else []
            return [one.status == task.status for one in found]

        return shortened(case, shows)
