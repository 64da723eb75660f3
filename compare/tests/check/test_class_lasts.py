"""What a class run has found is never lost: names, interruptions, second runs, builds without an end."""

from __future__ import annotations

import csv
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from occgrid_parity.check.verdict import from_json

from ..check_helpers import PROGRAMS

RIGHT = 'run = ["awk", "-f", "lesson.awk", "{scenario}"]\n'
COMMAND = [sys.executable, "-m", "occgrid_parity", "check", "--class", "in"]
QUICK = ["--scenario", "one-beam", "--timeout", "30"]


def submit(folder: Path, name: str, declaration: str = RIGHT) -> Path:
    """A submission with the mapper in awk beside its declaration."""
    place = folder / "in" / name
    place.mkdir(parents=True)
    (place / "lesson.awk").write_bytes((PROGRAMS / "lesson.awk").read_bytes())
    (place / "port.toml").write_text(declaration)
    return place


def check(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """A whole run over the class in ``folder``."""
    return subprocess.run(
        [*COMMAND, *QUICK, "--out", "out", *options],
        cwd=folder,
        text=True,
        capture_output=True,
    )


def rows(folder: Path) -> dict[str, dict[str, str]]:
    """The summary, by submission."""
    with (folder / "out" / "summary.csv").open(newline="") as file:
        return {row["submission"]: row for row in csv.DictReader(file)}


def test_no_name_reaches_the_results(tmp_path: Path) -> None:
    names = ["summary.csv", "mistakes.csv", "submissions", "index.html"]
    for name in [*names, "plain"]:
        submit(tmp_path, name)
    ended = check(tmp_path, "--report", "report")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert set(rows(tmp_path)) == {*names, "plain"}
    assert (tmp_path / "report" / "index.html").is_file()
    for name in names:
        page = tmp_path / "report" / "submissions" / name / "index.html"
        assert page.is_file()


def test_results_inside_the_class_are_no_submission(tmp_path: Path) -> None:
    submit(tmp_path, "one")
    for _ in range(2):
        subprocess.run(
            [*COMMAND[:-1], ".", *QUICK, "--out", "out", "--report", "pages"],
            cwd=tmp_path / "in",
            check=True,
            capture_output=True,
        )
    assert set(rows(tmp_path / "in")) == {"one"}


def begun(folder: Path, *options: str) -> subprocess.Popen[str]:
    """A check of the class that goes on, one submission at a time."""
    return subprocess.Popen(
        [*COMMAND, *QUICK[:2], "--out", "out", "--jobs", "1", *options],
        cwd=folder,
        text=True,
        stdout=subprocess.PIPE,
    )


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_stopped_and_taken_up(tmp_path: Path, number: signal.Signals) -> None:
    submit(tmp_path, "a-right")
    mark = f"10{os.getpid()}"
    submit(tmp_path, "b-hangs", f'run = ["sh", "-c", "setsid sleep {mark}"]\n')
    with begun(tmp_path, "--timeout", "600") as run:
        # on a busy machine the first submission alone takes a minute
        while not (asleep := sleeping(mark)) and run.poll() is None:
            time.sleep(0.05)
        assert asleep
        run.send_signal(number)
        printed, _ = run.communicate(timeout=300)
    assert run.returncode == 128 + number
    assert "stopped: 1 of 2 are checked and written to out" in printed
    assert "The same command again goes on from there." in printed
    assert not sleeping(mark)
    assert set(rows(tmp_path)) == {"a-right"}

    (tmp_path / "in" / "b-hangs" / "port.toml").write_text(RIGHT)
    again = check(tmp_path)
    assert again.returncode == 0, again.stdout
    # --timeout is another rule: nothing is taken over by it
    assert "taken over" not in again.stdout
    third = check(tmp_path)
    assert third.returncode == 0, third
    assert "2 of 2 have not changed and were taken over" in third.stdout


def sleeping(mark: str) -> bool:
    """Whether a process sleeps for just so long."""
    return any(
        one.info["cmdline"] == ["sleep", mark]
        for one in psutil.process_iter(["cmdline"])
    )


def test_only_what_has_changed_is_checked_again(tmp_path: Path) -> None:
    for name in "abc":
        submit(tmp_path, name)
    first = check(tmp_path)
    assert "taken over" not in first.stdout
    before = rows(tmp_path)
    with (tmp_path / "in" / "b" / "lesson.awk").open("a") as file:
        file.write("# one more line\n")
    (tmp_path / "out" / "submissions" / "c" / "verdict.txt").unlink()
    second = check(tmp_path)
    assert "1 of 3 have not changed and were taken over" in second.stdout
    after = rows(tmp_path)
    assert after["a"] == before["a"]
    assert set(after) == {"a", "b", "c"}
    (tmp_path / "in" / "class.toml").write_text("[points]\nruns = 2\n")
    third = check(tmp_path)
    assert "taken over" not in third.stdout


def test_a_build_that_sleeps_has_the_instructors_limit(tmp_path: Path) -> None:
    submit(
        tmp_path,
        "sleeper",
        RIGHT + 'build = [["sleep", "1000"]]\nbuild_timeout = 900\n',
    )
    started = time.monotonic()
    ended = check(tmp_path, "--build-timeout", "2")
    assert ended.returncode == 1
    assert time.monotonic() - started < 250  # without the option: 300 s
    row = rows(tmp_path)["sleeper"]
    assert row["word"] == "does not build"
    assert "no end after 2 s" in row["summary"]


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    submit(tmp_path, "victim")
    (tmp_path / "in" / "thief").symlink_to("victim")
    inside = submit(tmp_path, "inside")
    (inside / "theirs.awk").symlink_to("../victim/lesson.awk")
    check(tmp_path)
    found = rows(tmp_path)
    assert found["thief"]["word"] == "not readable"
    verdict = from_json(
        (
            tmp_path / "out" / "submissions" / "inside" / "verdict.json"
        ).read_text()
    )
    assert "not a file, left out: theirs.awk" in verdict.notes


def test_without_an_explanation_no_mistake_is_named(tmp_path: Path) -> None:
    declaration = RIGHT.replace('"{scen', '"-v", "bug=prior", "{scen')
    submit(tmp_path, "wrong", declaration)
    check(tmp_path, "--scenario", "prior", "--no-explain")
    assert rows(tmp_path)["wrong"]["word"] == "differs"
    assert rows(tmp_path)["wrong"]["cause"] == ""
    check(tmp_path, "--scenario", "prior")
    assert rows(tmp_path)["wrong"]["cause"] == "prior-not-subtracted"


@pytest.mark.skipif(
    sys.platform != "linux", reason="elsewhere each waits for its turn"
)
def test_others_are_checked_while_one_hangs(tmp_path: Path) -> None:
    submit(tmp_path, "a-hangs", 'run = ["sleep", "1000"]\n')
    for name in ("b", "c"):
        submit(tmp_path, name)
    with begun(tmp_path, "--timeout", "600") as run:
        assert run.stdout is not None
        before = [next(run.stdout) for _ in range(4)]
        run.send_signal(signal.SIGTERM)
        printed, _ = run.communicate(timeout=300)
    assert any(line.startswith("[2/3") for line in before), before
    assert run.returncode == 128 + signal.SIGTERM
    assert "stopped: 2 of 3 are checked" in printed
    assert set(rows(tmp_path)) == {"b", "c"}
