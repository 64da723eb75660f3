"""A class: every submission gets its verdict, whatever the others do."""

from __future__ import annotations

import csv
import json
import os
import sys
from pathlib import Path

import pytest
from rich.console import Console

from occgrid_parity.check.verdict import from_json
from occgrid_parity.commands.console_progress import ConsoleProgress
from occgrid_parity.course.class_run import ClassPlan, ClassRun
from occgrid_parity.course.class_store import SUBMISSIONS as PLACES
from occgrid_parity.course.class_summary import SUMMARY
from occgrid_parity.course.rules import NO_RULES
from occgrid_parity.course.submission_task import Wanted
from occgrid_parity.processes.limits import MEBI, Limits
from occgrid_parity.suite.cases import case

from ..check_helpers import PROGRAMS

MAP = 'awk -f "$0" "$1"'
"""A mapper in awk, which a submission has beside its script."""

LONG = f"10{os.getpid()}"
"""Seconds of sleep that no other test has: so a process that is left is known to come from here."""

# what each submission's shell script does: $0 is the mapper, $1 the scenario, the working folder is the empty one
SUBMISSIONS = {
    "right": (MAP, "identical", ""),
    "hangs": (f"sleep {LONG}", "failed", "hang"),
    "crashes": ("kill -SEGV $$", "failed", "crash"),
    "fails": ("echo 'no such luck' >&2; exit 3", "failed", "crash"),
    "prints-a-gigabyte": ("yes", "failed", "too much output"),
    "half-a-file": (f"{MAP} | head -c 60", "failed", "half a file"),
    "floats": ("printf 'P2\\n8 5\\n255\\n'; yes '0.5' | head -n 40", "failed", "floats instead of integers"),
    "wrong-size": ("printf 'P2\\n4 5\\n255\\n'; yes 128 | head -n 20", "failed", "wrong size"),
    "wrong-magic": ("printf 'P1\\n8 5\\n'; yes 1 | head -n 40", "failed", "wrong magic"),
    "forks": (f"while :; do sleep {LONG} & done", "failed", "forks"),
    "missing-file": ("cat /nowhere/settings", "failed", "missing file"),
    "writes-nothing": ("true", "failed", "no map"),
    "writes-into-the-scenario": (
        f'{MAP}; chmod u+w "$1" 2>/dev/null; echo x 2>/dev/null >> "$1"',
        "identical",
        "",
    ),
}  # fmt: skip


def declare(folder: Path, script: str) -> None:
    folder.mkdir(parents=True)
    (folder / "lesson.awk").write_bytes((PROGRAMS / "lesson.awk").read_bytes())
    (folder / "port.toml").write_text(
        f'run = ["sh", "-c", {json.dumps(script)}, "lesson.awk", "{{scenario}}"]\n'
    )


@pytest.fixture(scope="module")
def checked(
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[Path, list[dict[str, str]], str]:
    """The folder, the rows of the summary, and what was printed."""
    folder = tmp_path_factory.mktemp("class")
    for name, (script, _, _) in SUBMISSIONS.items():
        declare(folder / "in" / name, script)
    (folder / "in" / "empty").mkdir()
    (folder / "in" / "bad-declaration").mkdir()
    (folder / "in" / "bad-declaration" / "port.toml").write_text("run = 7\n")
    (folder / "in" / "not-executable").mkdir()
    (folder / "in" / "not-executable" / "map").write_text("")
    (folder / "in" / "not-executable" / "port.toml").write_text(
        'run = ["./map", "{scenario}"]\n'
    )
    (folder / "in" / "does-not-build").mkdir()
    (folder / "in" / "does-not-build" / "port.toml").write_text(
        'run = ["./map", "{scenario}"]\nbuild = [["sh", "-c", "echo syntax error >&2; exit 1"]]\n'
    )
    (folder / "in" / "a-file").write_text("not a submission")
    limits = Limits(
        seconds=5, output=2 * MEBI, memory=256 * MEBI, processes=24
    )
    console = Console(
        file=(folder / "printed").open("w"), force_terminal=False
    )
    with ConsoleProgress(console) as progress:
        # without a wall, so that processes that are left and a scenario that is changed would show
        wanted = Wanted(
            NO_RULES, limits, 60, "none", timeout=10, cases=[case("one-beam")]
        )
        plan = ClassPlan(folder / "in", folder / "out", wanted)
        ClassRun(plan, progress).check()
    console.file.close()
    with (folder / "out" / SUMMARY).open() as file:
        rows = list(csv.DictReader(file))
    return folder, rows, (folder / "printed").read_text()


def test_each_has_its_own_word(
    checked: tuple[Path, list[dict[str, str]], str],
) -> None:
    _, rows, _ = checked
    found = {row["submission"]: (row["verdict"], row["word"]) for row in rows}
    expected = {
        name: (verdict, word)
        for name, (_, verdict, word) in SUBMISSIONS.items()
    }
    expected |= {
        "empty": ("failed", "no port.toml"),
        "bad-declaration": ("failed", "bad port.toml"),
        "not-executable": ("failed", "not executable"),
        "does-not-build": ("failed", "does not build"),
    }
    assert found == expected


def test_each_has_a_record_and_a_text(
    checked: tuple[Path, list[dict[str, str]], str],
) -> None:
    folder, rows, printed = checked
    for row in rows:
        place = folder / "out" / PLACES / row["submission"]
        verdict = from_json((place / "verdict.json").read_text())
        assert verdict.summary == row["summary"]
        assert row["summary"] in (place / "verdict.txt").read_text().replace(
            "\n", " "
        )
        assert f"{row['submission']}: {row['summary']}" in printed
    floats = folder / "out" / PLACES / "floats" / "verdict.json"
    assert json.loads(floats.read_text())["overall"] == "failed"


def test_one_that_writes_into_the_scenario_is_told(
    checked: tuple[Path, list[dict[str, str]], str],
) -> None:
    folder, _, _ = checked
    verdict = from_json(
        (
            folder
            / "out"
            / PLACES
            / "writes-into-the-scenario"
            / "verdict.json"
        ).read_text()
    )
    assert "it changed its copy of the scenario file" in verdict.notes


def test_nothing_of_them_is_left(
    checked: tuple[Path, list[dict[str, str]], str],
) -> None:
    folder, _, _ = checked
    if not sys.platform.startswith("linux"):
        pytest.skip("there is no /proc")
    left = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            command = (process / "cmdline").read_bytes()
            place = (process / "cwd").readlink()
        except OSError:
            continue
        if command.startswith(
            f"sleep\0{LONG}".encode()
        ) and "occgrid-parity-check-" in str(place):
            left.append(command)
    assert left == []
    assert folder.exists()
