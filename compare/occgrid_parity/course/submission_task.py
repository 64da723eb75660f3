"""One submission from its archive to everything that is handed out about it: a piece of work for any process."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from occgrid import __file__ as port_file
from occgrid_parity.check.check_options import Options
from occgrid_parity.check.levels import (
    ADDED,
    FILE,
    LEVELS,
    ORIENTATION,
    ROUNDING,
    RUNS,
)
from occgrid_parity.check.program_check import broken
from occgrid_parity.check.program_maps import ComparedMap
from occgrid_parity.check.verdict import (
    Level,
    LevelStatus,
    Verdict,
    from_json,
    to_json,
)
from occgrid_parity.check.verdict_text import verdict_text
from occgrid_parity.check.whole_check import check
from occgrid_parity.course.points import results_json, score
from occgrid_parity.course.rules import Rules
from occgrid_parity.course.submitted_program import (
    ToolMissing,
    submitted_program,
)
from occgrid_parity.course.verdict_merging import (
    FIRST,
    for_student,
    merged,
    one_level,
)
from occgrid_parity.formats.archive import Archive, unpack
from occgrid_parity.ports.port_file import DECLARATION, PortError
from occgrid_parity.processes.limits import LOST, Limits
from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.wall import Sandbox, Wall, find_wall
from occgrid_parity.programs.program import Program
from occgrid_parity.programs.runner import CommandRunner
from occgrid_parity.report.check_page import write_check_page
from occgrid_parity.report.junit import verdict_junit_xml
from occgrid_parity.suite.cases import LESSON, TWIN, Case
from occgrid_parity.suite.cases import case as case_of_suite
from occgrid_parity.suite.modes import Mode

SUITE = (Path(port_file).parent, Path(__file__).resolve().parents[1])
"""The folders of the reference and of the harness."""

SAVED = "saved"
SUBMISSION = "submission"
TEMPORARY = "/tmp/occgrid-parity-check"
HIDDEN = "hidden scenario"
SEEDED = ("seeds", "noise of the instructor's seeds")
NOISY = ("asymmetric", TWIN, LESSON)
SKIPPED = "skipped"
NOT_ITS_FAULT = ("harness error", LOST, SKIPPED)
"""Words that say nothing about a submission: it is checked again the next time."""


@dataclass(frozen=True)
class Wanted:
    """What every submission of a class is checked by. ``hidden`` are scenarios that students do not see.

    ``gradescope`` and ``junit`` name files in these forms; ``out_of_sight`` are folders that no program sees behind its
    wall.
    """

    rules: Rules
    limits: Limits
    build_seconds: float
    sandbox: Sandbox
    timeout: float | None = None
    cases: Sequence[Case] = ()
    modes: Sequence[Mode] = ()
    own: Sequence[Case] = ()
    hidden: Sequence[Case] = ()
    explain: bool = True
    pages: bool = False
    gradescope: str = ""
    junit: str = ""
    out_of_sight: Sequence[Path] = ()


@dataclass(frozen=True)
class Task:
    """One submission to check: ``origin`` is its folder, ``kept`` where its files will lie."""

    name: str
    archive: Archive
    wanted: Wanted
    origin: Path
    kept: Path


@dataclass(frozen=True)
class Checked:
    """What came of a submission: the verdict, and files by their names."""

    name: str
    verdict: Verdict
    files: dict[str, bytes] = field(repr=False)
    page: bytes | None = field(default=None, repr=False)

    @property
    def word(self) -> str:
        """The word of the level that failed; empty without one."""
        level = self.verdict.failed_level
        return level.word if level else ""

    @property
    def is_final(self) -> bool:
        """Whether the verdict is about the submission, and not about the machine that checked it."""
        return all(x.word not in NOT_ITS_FAULT for x in self.verdict.levels)


def check_task(task: Task) -> Checked:
    """Checks a submission. Whatever goes wrong is its verdict.

    Raises occgrid_parity.processes.process_group.Stopped or SystemExit when the work is asked to stop.
    """
    with tempfile.TemporaryDirectory(
        prefix="occgrid-parity-check-", ignore_cleanup_errors=True
    ) as place:
        folder = Path(place)
        save = folder / SAVED
        maps: list[ComparedMap] = []
        try:
            verdict = _verdict(task, folder, save, maps)
        except Stopped:
            raise
        except (
            Exception
        ) as error:  # the harness's own fault must not end the class
            said = f"{type(error).__name__}: {error}"
            verdict = without_run(task.name, "harness error", said)
        return handed_out(task, verdict, maps, folder)


def needs_another_machine(checked: Checked) -> bool:
    """Whether the machine lacks what the submission needs."""
    return checked.word == SKIPPED


def handed_out_unrun(task: Task, word: str, message: str) -> Checked:
    """What is handed out about a submission that was not even unpacked."""
    with tempfile.TemporaryDirectory() as place:
        verdict = without_run(task.name, word, message)
        return handed_out(task, verdict, [], Path(place))


def without_run(name: str, word: str, message: str) -> Verdict:
    """The verdict on a submission that could not be run."""
    program = Program(name, ("?",), Path(name), words="")
    return broken(CommandRunner(program, Path(), Limits()), word, message)


def _verdict(
    task: Task, folder: Path, save: Path, maps: list[ComparedMap]
) -> Verdict:
    """Unpacks, builds and checks."""
    wanted = task.wanted
    place = folder / SUBMISSION / task.name
    unpack(task.archive.data, place)
    if wanted.rules.program.run is None and not (place / DECLARATION).exists():
        said = f"{task.name} has no {DECLARATION}"
        return without_run(task.name, "no port.toml", said)
    try:
        program, ignored = submitted_program(
            place, wanted.rules.program, wanted.timeout
        )
    except ToolMissing as missing:
        return without_run(task.name, SKIPPED, str(missing))
    except PortError as error:
        said = str(error).replace(f"{place}/", "")
        return without_run(task.name, "bad port.toml", said)
    wall = _wall(wanted)
    limits = replace(wanted.limits, seconds=program.timeout)
    program = replace(program, build_timeout=wanted.build_seconds)
    runner = CommandRunner(program, folder / "runs", limits, wall=wall)
    problem = runner.build()
    if problem is not None:
        verdict = broken(runner, problem.word, problem.message, problem.notes)
    else:
        verdict = _levels(runner, wanted, save, maps)
    notes = [
        *ignored,
        *(f"not a file, left out: {name}" for name in task.archive.left_out),
    ]
    if wanted.sandbox == "auto" and not wall.works:
        notes.append(f"it ran without a wall around it: {wall.reason}")
    return replace(verdict, notes=[*verdict.notes, *notes])


def _wall(wanted: Wanted) -> Wall:
    wall = find_wall(wanted.sandbox, [*SUITE, *wanted.out_of_sight])
    given = wanted.rules.program
    return replace(
        wall,
        readable=tuple(Path(place) for place in given.readable),
        environment=tuple(sorted(given.environment.items())),
    )


def _levels(
    runner: CommandRunner,
    wanted: Wanted,
    save: Path,
    maps: list[ComparedMap],
) -> Verdict:
    """The suite's levels, and then those of the instructor."""
    options = Options(
        wanted.cases, wanted.modes, wanted.explain, save, maps.append
    )
    if wanted.cases:
        return check(runner, options)
    quiet = replace(options, save=None, on_map=None, explain=False)
    others: list[tuple[Level, Verdict]] = []
    for case in wanted.own:
        verdict = check(runner, replace(options, cases=[case]))
        others.append((one_level(verdict, case.name, case.name), verdict))
    seeds = [Mode(seed) for seed in wanted.rules.check.seeds]
    if seeds and runner.reads_scenarios and runner.takes_seeds:
        noisy = [case_of_suite(name) for name in NOISY]
        verdict = check(runner, replace(options, cases=noisy, modes=seeds))
        others.append((one_level(verdict, *SEEDED), verdict))
    for number, case in enumerate(wanted.hidden, 1):
        secret = Case(f"scenario-{number}", case.data)
        verdict = check(runner, replace(quiet, cases=[secret]))
        title = f"{HIDDEN} {number}"
        others.append((one_level(verdict, case.name, title), verdict))
    if wanted.rules.check.suite:
        return merged(check(runner, options), others, HIDDEN)
    level, verdict = others[0]
    early = [
        x for x in verdict.levels if x.name in FIRST and x.status != "failed"
    ]
    start = replace(verdict, levels=[*early, level])
    return merged(start, others[1:], HIDDEN)


def handed_out(
    task: Task,
    verdict: Verdict,
    maps: Sequence[ComparedMap],
    folder: Path,
) -> Checked:
    """Every file about a submission. Paths that were temporary are those that the instructor knows."""
    wanted = task.wanted
    save, place = folder / SAVED, folder / SUBMISSION / task.name
    text = to_json(verdict)
    for temporary, lasting in (
        (save, task.kept),
        (place, task.origin),
        (folder, TEMPORARY),
    ):
        text = text.replace(str(temporary), str(lasting))
    verdict = with_every_level(from_json(text), wanted)
    shown = for_student(verdict, [case.name for case in wanted.hidden])
    files = {
        "verdict.json": text.encode(),
        "verdict.txt": marked_text(verdict, verdict, wanted.rules).encode(),
        "feedback.txt": marked_text(verdict, shown, wanted.rules).encode(),
    }
    if wanted.gradescope:
        results = results_json(verdict, shown, wanted.rules)
        files[wanted.gradescope] = results.encode()
    if wanted.junit:
        files[wanted.junit] = verdict_junit_xml(shown).encode()
    if save.is_dir():
        for path in sorted(save.iterdir()):
            if path.is_file():
                files[path.name] = path.read_bytes()
    page = None
    if wanted.pages:
        file = write_check_page(shown, list(maps), folder / "page")
        page = file.read_bytes()
    return Checked(task.name, verdict, files, page)


def with_every_level(verdict: Verdict, wanted: Wanted) -> Verdict:
    """The verdict with the levels that it has not reached, so that the maximum is the same for all."""
    levels = [RUNS, FILE, ORIENTATION, ADDED, ROUNDING]
    if wanted.cases:
        levels += [(case.name, case.name) for case in wanted.cases]
    else:
        if wanted.rules.check.suite:
            levels += [(plan.name, plan.title) for plan in LEVELS]
        levels += [(case.name, case.name) for case in wanted.own]
        levels += [SEEDED] * bool(wanted.rules.check.seeds)
        levels += [
            (case.name, f"{HIDDEN} {number}")
            for number, case in enumerate(wanted.hidden, 1)
        ]
    known = {level.name for level in verdict.levels}
    missing = [
        Level(name, title, _missing(name))
        for name, title in levels
        if name not in known
    ]
    return replace(verdict, levels=[*verdict.levels, *missing])


def _missing(name: str) -> LevelStatus:
    """Seeds are missing only where the program cannot be asked for noise, or could not be run."""
    return "not checked" if name == SEEDED[0] else "grey"


def marked_text(verdict: Verdict, shown: Verdict, rules: Rules) -> str:
    """The points by the rules, and of the verdict what is shown: for a student without what is hidden."""
    points, maximum = score(verdict, rules)
    return f"{points:g} of {maximum:g} points\n\n{verdict_text(shown, points=False)}"
