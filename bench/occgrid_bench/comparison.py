"""Contestants at the same work, in turns: a round is one turn of each."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass

from occgrid_bench.contestants import Contestant
from occgrid_bench.drivers import Driver, DriverError, run_once
from occgrid_bench.folders import ROOT, WORK
from occgrid_bench.log_odds import Array, contract_map, differing
from occgrid_bench.record import Series
from occgrid_bench.work import Work

TURN = 0.05  # seconds that a turn should take at least, by 3 to 50 maps
SLOW = 3.0  # seconds of a map from which on a few rounds must do
SLOW_ROUNDS = 3

ENVIRONMENT = os.environ | {
    "PYTHONPATH": str(ROOT / "python"),
    "OMP_NUM_THREADS": "1",
}


@dataclass
class Effort:
    """How long to measure."""

    rounds: int
    budget: (
        float  # seconds that a contestant may take in a round, more or less
    )
    warm_up: float  # seconds of maps before the first turn, at most
    restart: bool  # a new process for each turn: some are luckier with their memory than others
    say: Callable[[str], None]


class _Player:
    """A contestant while it is measured."""

    def __init__(
        self, contestant: Contestant, work: Work, effort: Effort
    ) -> None:
        predicted = work.cells / contestant.speed
        every = 1
        while predicted / every > effort.budget and every < len(work.poses):
            every *= 2
        part = work.every(every)
        self.slow = predicted / every > SLOW
        self.contestant = contestant
        self.work = part
        self.rounds = (
            min(effort.rounds, SLOW_ROUNDS) if self.slow else effort.rounds
        )
        self.scale = len(work.poses) / len(part.poses)
        self.log_odds = WORK / f"{part.name}.{contestant.name}.logodds"
        files = {
            "work": str(part.write(WORK)),
            "log_odds": str(self.log_odds),
        }
        self.command = [word.format(**files) for word in contestant.command]
        self.restart = effort.restart or contestant.fresh
        self.warm_up = min(contestant.warm_up, effort.warm_up)
        self.driver: Driver | None = None
        self.times = 1
        self.series = Series(
            contestant.name,
            contestant.title,
            contestant.group,
            contestant.what,
            every=every,
        )

    def start(self, stack: ExitStack) -> None:
        """Start a process for all turns and let it warm up."""
        if not self.restart and not self.contestant.one_shot:
            driver = Driver(self.command, ENVIRONMENT)
            self.driver = stack.enter_context(driver)
            self._warm_up(driver)

    def _warm_up(self, driver: Driver) -> None:
        if self.contestant.fresh or self.slow:
            return
        taken = driver.map(1)
        while sum(taken) < self.warm_up:
            taken += driver.map(1)
        self.times = min(max(round(TURN / taken[-1]), 3), 50)

    def turn(self) -> None:
        """One round's value: the least of its maps, as what disturbs them only adds."""
        if self.contestant.one_shot:
            value = run_once(self.command, ENVIRONMENT)
        elif self.driver is None:
            with Driver(self.command, ENVIRONMENT) as driver:
                self._warm_up(driver)
                value = min(driver.map(self.times))
                self._write(driver)
        else:
            value = min(self.driver.map(self.times))
        self.series.seconds.append(value * self.scale)

    def _write(self, driver: Driver) -> None:
        if self.contestant.check != "none":
            driver.write(self.log_odds)

    def write(self) -> None:
        """Write the last map."""
        if self.driver is not None:
            self._write(self.driver)


def compare(
    work: Work, contestants: Sequence[Contestant], effort: Effort
) -> list[Series]:
    """Measure all that are there; those that are not, too, are in the answer."""
    WORK.mkdir(parents=True, exist_ok=True)
    series = []
    with ExitStack() as stack:
        players = []
        for contestant in contestants:
            player = _Player(contestant, work, effort)
            series.append(player.series)
            player.series.skipped = contestant.missing()
            if player.series.skipped:
                continue
            effort.say(f"{work.name}: {contestant.title}: warming up")
            try:
                player.start(stack)
                players.append(player)
            except DriverError as error:
                player.series.skipped = str(error)
        for number in range(effort.rounds):
            # another one begins each round
            shift = number % max(len(players), 1)
            for player in players[shift:] + players[:shift]:
                if number >= player.rounds or player.series.skipped:
                    continue
                title = player.series.title
                effort.say(
                    f"{work.name}: round {number + 1} of {effort.rounds}: {title}"
                )
                try:
                    player.turn()
                except DriverError as error:
                    player.series.skipped = str(error)
        for player in players:
            if not player.series.skipped:
                player.write()
    _check(players)
    return series


def _check(players: list[_Player]) -> None:
    """Count the cells that differ from the contract's map of the same scans."""
    expected: dict[str, Array] = {}
    for player in players:
        if player.contestant.check == "none" or player.series.skipped:
            continue
        name = player.work.name
        if name not in expected:
            expected[name] = contract_map(player.work)
        player.series.differing = differing(player.log_odds, expected[name])
