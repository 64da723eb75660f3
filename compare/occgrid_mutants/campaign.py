"""Every change in a process of its own, forked from one that has everything loaded; several side by side."""

from __future__ import annotations

import gc
import json
import os
import signal
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from types import CodeType

from occgrid_mutants import port_modules, readings
from occgrid_mutants.calls import Calls
from occgrid_mutants.port_tests import port_tests
from occgrid_mutants.readings import Readings
from occgrid_mutants.sites import Site, sites
from occgrid_mutants.trials import (
    Modules,
    Trial,
    scenario_files,
    scenario_trials,
    unit_trials,
)
from occgrid_mutants.watching import (
    Measured,
    TooLong,
    bound_memory,
    failure,
    measure,
    time_limit,
)

# A child that has not answered after so long is ended: what holds it does not let the time limit in.
LONGEST = 900.0
# Maps that take no longer than this in all are tried before the functions are asked again: most changes end there.
FIRST_SECONDS = 0.1
# How long it may take to ask the functions again, or to read every scenario.
ASKING_SECONDS = 15.0
# How the names of unit trials begin.
UNITS = ("vectors", "bad input", "lesson numbers", "unit tests")


@dataclass(frozen=True)
class Result:
    """What became of a change. ``seen_by`` is the first trial that fails, empty where none does."""

    site: Site
    seen_by: str
    how: str
    reached: bool  # a scenario runs its line

    @property
    def group(self) -> str:
        """``scenarios``, one of UNITS, or ``nothing``."""
        if not self.seen_by:
            return "nothing"
        for word in UNITS:
            if self.seen_by.startswith(word):
                return word
        return "scenarios"


def _asks_functions(trial: Trial) -> bool:
    """Whether it asks functions directly: all but those that read a file and map it."""
    return trial.name.startswith("vectors")


class Campaign:
    """The port as it is: its code, its trials with the lines that they run, and all changes."""

    def __init__(self, root: Path, say: Callable[[str], None]) -> None:
        self.code = port_modules.compiled(root)
        self.files = port_modules.sources(root)
        self.trees = {
            name: port_modules.parse(self.files[name])
            for name in port_modules.CHANGED
        }
        self.sites = [
            site
            for name, tree in self.trees.items()
            for site in sites(name, tree)
        ]
        start = time.monotonic()
        self.calls = Calls()
        with port_modules.loaded(self.code) as modules:
            self.scenarios = [
                self._measured(trial, modules)
                for trial in scenario_trials(root)
            ]
            self.units = [
                self._measured(trial, modules) for trial in unit_trials(root)
            ]
            self.readings = Readings(scenario_files(root), modules)
        self.tests = port_tests(root)
        say(
            f"{len(self.sites)} changes; {len(self.scenarios)} maps, which ask {len(self.calls)} questions of the "
            f"functions, and {len(self.units)} unit trials, measured in {time.monotonic() - start:.0f} s"
        )
        self.kills: dict[str, Counter[str]] = {}

    def run(
        self,
        chosen: Iterable[Site],
        jobs: int,
        done: Callable[[Result], None],
        until: float | None = None,
    ) -> None:
        """Puts the changes to their trials; begins none after ``until`` (time.monotonic)."""
        waiting = iter(chosen)
        running: dict[int, tuple[Site, int, float]] = {}
        more = True
        gc.freeze()  # what is shared with the children stays shared
        while more or running:
            while more and len(running) < jobs:
                site = next(waiting, None)
                more = site is not None and (
                    until is None or time.monotonic() < until
                )
                if site is not None and more:
                    pid, pipe = self._start(site)
                    running[pid] = (site, pipe, time.monotonic())
            for pid in list(running):
                site, pipe, started = running[pid]
                ended, _ = os.waitpid(pid, os.WNOHANG)
                if not ended and time.monotonic() - started > LONGEST:
                    os.kill(pid, signal.SIGKILL)
                    os.waitpid(pid, 0)
                    ended = pid
                if ended:
                    del running[pid]
                    result = self._read(site, pipe)
                    self.learn(result)
                    done(result)
            time.sleep(0.005)
        gc.unfreeze()

    def learn(self, result: Result) -> None:
        """What has seen a change in a function is tried first on the next one there."""
        if result.seen_by:
            place = f"{result.site.module}.{result.site.function}"
            self.kills.setdefault(place, Counter())[result.seen_by] += 1

    def trials(self, site: Site) -> tuple[list[Measured], list[Measured]]:
        """The scenarios and the unit trials that run the line of a change, the most promising first."""
        file = str(self.files[site.module])
        lines = {(file, n) for n in range(site.lines[0], site.lines[1] + 1)}
        found = self.kills.get(f"{site.module}.{site.function}", Counter())

        def meant(trials: Sequence[Measured]) -> list[Measured]:
            chosen = [
                t
                for t in trials
                if site.at_import or not lines.isdisjoint(t.lines)
            ]
            return sorted(
                chosen, key=lambda t: (-found[t.trial.name], t.seconds)
            )

        return meant(self.scenarios), meant(self.units)

    def _measured(self, trial: Trial, modules: Modules) -> Measured:
        direct = _asks_functions(trial)
        with (
            nullcontext()
            if direct
            else self.calls.recorded(modules, trial.name)
        ):
            return measure(trial, modules)

    def _start(self, site: Site) -> tuple[int, int]:
        scenarios, units = self.trials(site)
        pipe, end = os.pipe()
        pid = os.fork()
        if pid:
            os.close(end)
            return pid, pipe
        status = 1
        try:
            null = os.open(os.devnull, os.O_WRONLY)
            os.dup2(null, 1)
            os.dup2(null, 2)
            answer = self._try(site, scenarios, units)
            os.write(end, json.dumps(answer).encode())
            status = 0
        finally:
            os._exit(status)

    def _try(
        self,
        site: Site,
        scenarios: Sequence[Measured],
        units: Sequence[Measured],
    ) -> tuple[str, str]:
        """The first trial that a change fails, and how. Runs in a process of its own: it alters the tree."""
        bound_memory()
        site.change()
        file = self.files[site.module]
        code: dict[str, CodeType] = {
            **self.code,
            site.module: compile(self.trees[site.module], str(file), "exec"),
        }
        try:
            with time_limit(20.0):
                room = port_modules.loaded(code)
                modules = room.__enter__()
        except TooLong:
            return "scenarios: the import", "does not end"
        except Exception as error:
            return "scenarios: the import", type(error).__name__
        if site.module == "fast":
            scenarios = [_from_scans(t) for t in scenarios]
        first = _within(scenarios, FIRST_SECONDS)
        for measured in first:
            how = failure(measured, modules)
            if how is not None:
                return measured.trial.name, how
        rest = [*scenarios[len(first) :], *units]
        if rest:
            rest = self._that_may_differ(rest, site, modules)
        tests = Measured(self.tests[site.module], frozenset(), 10.0)
        for measured in [*rest, tests]:
            how = failure(measured, modules)
            if how is not None:
                return measured.trial.name, how
        return "", ""

    def _that_may_differ(
        self, trials: Sequence[Measured], site: Site, modules: Modules
    ) -> list[Measured]:
        """These trials without those to which the changed port gives the same answers as the port as it is."""
        try:
            with time_limit(ASKING_SECONDS):
                if readings.tells(site):
                    read = self.readings.differing(modules)
                    return [
                        t
                        for t in trials
                        if not t.trial.scenario or t.trial.scenario in read
                    ]
                asking = self.calls.differing(
                    site,
                    self.trees[site.module],
                    {t.trial.name for t in trials},
                    modules,
                )
        except TooLong:
            asking = None
        return [
            t
            for t in trials
            if asking is None
            or _asks_functions(t.trial)
            or t.trial.name in asking
        ]

    def _read(self, site: Site, pipe: int) -> Result:
        with os.fdopen(pipe, "rb") as stream:
            text = stream.read()
        reached = bool(self.trials(site)[0])
        if not text:
            return Result(site, "scenarios", "ends the program", reached)
        seen_by, how = json.loads(text)
        return Result(site, seen_by, how, reached)


def _from_scans(measured: Measured) -> Measured:
    trial = measured.trial
    return replace(
        measured, trial=replace(trial, right=trial.from_scans or trial.right)
    )


def _within(trials: Sequence[Measured], seconds: float) -> list[Measured]:
    """The first trials, as many as take so long in all, but at least one."""
    chosen = list(trials[:1])
    for trial in trials[1:]:
        seconds -= trial.seconds
        if seconds < 0.0:
            break
        chosen.append(trial)
    return chosen
