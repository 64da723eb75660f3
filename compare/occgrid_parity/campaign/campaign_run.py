"""A campaign: many worlds in blocks, each block done somewhere, and what differs made as short as it gets."""

from __future__ import annotations

import platform
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from occgrid_parity.campaign.block_work import (
    Block,
    BlockFindings,
    Shortening,
    Subjects,
    map_block,
    shorten,
)
from occgrid_parity.campaign.campaign_record import (
    RECORD_FILE,
    SCHEMA,
    CampaignRecord,
    ProgramRecord,
    WorldDifference,
    to_json,
)
from occgrid_parity.campaign.judging import Finding
from occgrid_parity.campaign.numbered_worlds import blocks, mode_of, world
from occgrid_parity.campaign.random_scenarios import kind_of
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.processes.pool import side_by_side
from occgrid_parity.processes.progress import Progress
from occgrid_parity.suite.cases import Case

Do = Callable[[Callable[[Any], Any], Any, threading.Event], Any]
"""do(work, argument, stop): does a piece of work somewhere."""


@dataclass(frozen=True)
class CampaignPlan:
    """What a campaign is to do.

    ``programs`` are the records of the subjects as they begin, ``shorten`` how many differences of each are made short,
    ``again`` for each program the command that maps a world again, but for its number.
    """

    seed: int
    first: int
    worlds: int
    subjects: Subjects
    programs: Sequence[ProgramRecord]
    folder: Path
    again: Mapping[str, str]
    jobs: int = 2
    shorten: int = 5


class Campaign:
    """A campaign that is under way; ``record`` is what it has found so far."""

    def __init__(self, plan: CampaignPlan, progress: Progress) -> None:
        self.plan = plan
        self.progress = progress
        self.started = datetime.now(UTC)
        self.clock = time.monotonic()
        self.lock = threading.Lock()
        self.done = 0
        self.programs = {one.name: one for one in plan.programs}
        self.differences: list[WorldDifference] = []

    def run(self, do: Do) -> CampaignRecord:
        """Maps all worlds, then shortens what differs. Whatever ends this, what has been found is written."""
        plan = self.plan
        todo = blocks(plan.first, plan.worlds)
        self.progress.total(len(todo))

        def one_block(numbers: range, stop: threading.Event) -> None:
            block = Block(plan.seed, numbers, plan.subjects)
            self._take(numbers, do(map_block, block, stop))

        def one_difference(index: int, stop: threading.Event) -> None:
            found = self.differences[index]
            of = plan.subjects.only(found.program)
            task = Shortening(plan.seed, found.world, of, found.status)
            case: Case = do(shorten, task, stop)
            self.differences[index] = self._with_files(found, case)

        try:
            side_by_side(one_block, todo, plan.jobs)
            self.differences.sort(key=lambda one: (one.world, one.program))
            side_by_side(one_difference, self._to_shorten(), plan.jobs)
        finally:
            write_text(plan.folder / RECORD_FILE, to_json(self.record))
        return self.record

    @property
    def record(self) -> CampaignRecord:
        """What has been found so far."""
        plan = self.plan
        with self.lock:
            return CampaignRecord(
                schema=SCHEMA,
                started=self.started.isoformat(timespec="seconds"),
                seconds=round(time.monotonic() - self.clock, 3),
                machine=f"{platform.system()} {platform.machine()}",
                seed=plan.seed,
                first=plan.first,
                worlds=plan.worlds,
                done=self.done,
                programs=list(self.programs.values()),
                differences=list(self.differences),
            )

    def _take(self, numbers: range, block: BlockFindings) -> None:
        mode = mode_of(self.plan.seed, numbers[0])
        with self.lock:
            self.done += len(numbers)
            wrong = 0
            for name, findings in block.findings.items():
                self.programs[name] = _counted(self.programs[name], findings)
                for number, found in zip(numbers, findings, strict=True):
                    if found.is_wrong:
                        wrong += 1
                        self.differences.append(
                            WorldDifference(
                                name,
                                number,
                                kind_of(number),
                                mode.name,
                                found.status,
                                found.reason,
                                f"{self.plan.again[name]} --world {number}",
                            )
                        )
        said = f"{wrong} differences" if wrong != 1 else "1 difference"
        self.progress.step(
            f"worlds {numbers[0]} to {numbers[-1]}, {mode.name}: {said}"
        )

    def _to_shorten(self) -> list[int]:
        """The first differences of each program."""
        counts: dict[str, int] = {}
        chosen = []
        for index, one in enumerate(self.differences):
            counts[one.program] = counts.get(one.program, 0) + 1
            if counts[one.program] <= self.plan.shorten:
                chosen.append(index)
        return chosen

    def _with_files(
        self, found: WorldDifference, case: Case
    ) -> WorldDifference:
        """Writes the world and the shortened scenario."""
        place = self.plan.folder / found.program
        place.mkdir(parents=True, exist_ok=True)
        whole = place / f"world-{found.world}.log"
        whole.write_bytes(world(self.plan.seed, found.world).data)
        short = place / f"world-{found.world}.short.log"
        short.write_bytes(case.data)
        return replace(
            found,
            file=whole.relative_to(self.plan.folder).as_posix(),
            shortened=short.relative_to(self.plan.folder).as_posix(),
            text=case.data.decode("ascii"),
        )


def _counted(
    program: ProgramRecord, findings: Sequence[Finding]
) -> ProgramRecord:
    statuses = [one.status for one in findings]
    skipped = [one.reason for one in findings if one.status == "skipped"]
    return replace(
        program,
        identical=program.identical + statuses.count("identical"),
        different=program.different + sum(x.is_wrong for x in findings),
        left_out=program.left_out + statuses.count("left out"),
        skipped=program.skipped + len(skipped),
        problem=program.problem or (skipped[0] if skipped else ""),
    )
