"""A run of which nobody knows how it ended is done again, and takes no marks from anybody."""

from __future__ import annotations

from pathlib import Path

import pytest

from occgrid_parity.check.bad_input import check_bad_input
from occgrid_parity.check.verdict import Level, Verdict
from occgrid_parity.course.submission_task import Checked, without_run
from occgrid_parity.processes.limits import LOST, Ended, Limits, run_limited
from occgrid_parity.programs import runner
from occgrid_parity.programs.program import program_from_command
from occgrid_parity.programs.runner import CommandRunner
from occgrid_parity.suite.cases import case
from occgrid_parity.suite.modes import NOISE_FREE


def lose(monkeypatch: pytest.MonkeyPatch, times: int) -> list[Path]:
    """The first runs are lost; what is given back names the folders of all."""
    real, folders = run_limited, []

    def some(*command: object, **options: object) -> Ended:
        folder = options["folder"]
        assert isinstance(folder, Path)
        folders.append(folder)
        ended: Ended = real(*command, **options)  # type: ignore[arg-type]
        if len(folders) > times:
            return ended
        return Ended(LOST, "who knows", 0.0, ended.stdout, ended.stderr)

    monkeypatch.setattr(runner, "run_limited", some)
    return folders


def program(folder: Path) -> CommandRunner:
    """A program that ends with an error that names a line."""
    words = "sh -c 'echo line 7 >&2; exit 1' {scenario}"
    return CommandRunner(
        program_from_command(words, folder, 30.0), folder / "runs", Limits()
    )


def test_a_lost_run_is_done_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folders = lose(monkeypatch, 1)
    outcome = program(tmp_path).run(case("one-beam"), NOISE_FREE)
    assert (outcome.word, outcome.status) == ("crash", 1)
    assert len(set(folders)) == 2


def test_what_is_lost_again_says_nothing_about_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lose(monkeypatch, 2)
    level, _ = check_bad_input(program(tmp_path))
    assert (level.status, level.word) == ("failed", LOST)


def with_levels(*levels: Level) -> Verdict:
    verdict = without_run("ada", "crash", "exit status 1")
    verdict.levels.extend(levels)
    return verdict


def test_a_verdict_with_a_lost_run_is_not_final() -> None:
    lost = Level("bad-input", "scenarios that break a rule", "failed", LOST)
    assert Checked("ada", with_levels(), {}).is_final
    assert not Checked("ada", with_levels(lost), {}).is_final
