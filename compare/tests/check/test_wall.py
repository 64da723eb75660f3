"""The wall: what hostile programs of a class try has no effect on anything but their own verdict.

Each of them first does what it is there for, and then draws a right map, so that it is not the map that stops it. The
same programs without a wall show that they do what they say.
"""

from __future__ import annotations

import csv
import socket
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from occgrid_parity.check.verdict import Verdict, from_json
from occgrid_parity.course.class_run import ClassPlan, ClassRun
from occgrid_parity.course.rules import NO_RULES
from occgrid_parity.course.submission_task import Wanted
from occgrid_parity.processes import wall
from occgrid_parity.processes.limits import Limits
from occgrid_parity.processes.progress import Silent
from occgrid_parity.processes.wall import NoWall, Sandbox, find_wall
from occgrid_parity.suite.cases import case, scenario_folder

from ..check_helpers import PROGRAMS
from ..conftest import ROOT, unavailable

MAP = 'exec awk -f "$(dirname "$0")/lesson.awk" "$1"\n'


def submit(folder: Path, name: str, script: str) -> Path:
    """A submission: a shell script that ends by drawing the right map."""
    place = folder / "in" / name
    place.mkdir(parents=True)
    (place / "lesson.awk").write_bytes((PROGRAMS / "lesson.awk").read_bytes())
    (place / "map.sh").write_text(script + "\n" + MAP)
    (place / "port.toml").write_text(
        'run = ["sh", "{port}/map.sh", "{scenario}"]\n'
    )
    return place


def check(folder: Path, sandbox: Sandbox = "require") -> dict[str, Verdict]:
    """The verdicts on a class, on one scenario."""
    if sandbox == "require" and not find_wall("auto").works:
        unavailable("bubblewrap")
    wanted = Wanted(
        NO_RULES, Limits(), 30, sandbox, timeout=100, cases=[case("one-beam")]
    )
    plan = ClassPlan(folder / "in", folder / "out", wanted, jobs=1)
    found = ClassRun(plan, Silent()).check()
    return {one.name: one.verdict for one in found}


def everything_in(folder: Path) -> dict[str, bytes]:
    return {
        str(path): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


GOLDEN = scenario_folder() / "golden" / "one-beam.noise-free.pgm"
STEALS = {
    "reads-the-golden-result": (f"cat {GOLDEN} >&2 && exit 9", 9),
    "reads-another": ("cat {folder}/in/victim/map.sh >&2 && exit 9", 9),
    "reads-the-verdicts": ("ls {folder}/out/submissions >&2 && exit 9", 9),
    "reads-settings": ("cat /etc/hostname >&2 && exit 9", 9),
    "sees-the-harness": (
        f"ls {ROOT}/compare/occgrid_parity/check >&2 && exit 9",
        9,
    ),
    "sees-other-processes": (
        "grep -sqa occgrid_parity /proc/[0-9]*/cmdline && exit 9",
        9,
    ),
}


@pytest.mark.parametrize("name", STEALS)
def test_what_must_not_be_seen(tmp_path: Path, name: str) -> None:
    script, status = STEALS[name]
    submit(tmp_path, "victim", "true")
    submit(tmp_path, name, script.replace("{folder}", str(tmp_path)))
    assert check(tmp_path)[name].overall == "identical"
    open_ = check(tmp_path, "none")[name]
    assert open_.overall == "failed"
    assert f"exit status {status}" in open_.summary


def test_a_copied_picture_is_no_map(tmp_path: Path) -> None:
    """The golden picture gives full marks only where there is no wall."""
    place = submit(tmp_path, "copies", "true")
    (place / "port.toml").write_text(
        f'run = ["sh", "-c", "cat {GOLDEN} # $0", "{{scenario}}"]\n'
    )
    verdict = check(tmp_path)["copies"]
    assert verdict.overall == "failed"
    assert verdict.score < verdict.maximum
    assert check(tmp_path, "none")["copies"].overall == "identical"


WRITES = {
    "overwrites-another": "echo 'run = 7' > {folder}/in/victim/port.toml",
    "overwrites-results": "test -d {folder}/out && echo 7 > {folder}/out/stolen",
    "patches-what-is-beside-it": 'echo >> "$(dirname "$0")/lesson.awk"',
}


@pytest.mark.parametrize("name", WRITES)
def test_what_must_not_be_written(tmp_path: Path, name: str) -> None:
    script = "(" + WRITES[name].replace("{folder}", str(tmp_path)) + ")"
    submit(tmp_path, "a", script + " 2>/dev/null && exit 9")
    submit(tmp_path, "victim", "true")
    before = everything_in(tmp_path / "in")
    found = check(tmp_path)
    assert {v.overall for v in found.values()} == {"identical"}
    assert everything_in(tmp_path / "in") == before
    assert not (tmp_path / "out" / "stolen").exists()
    assert check(tmp_path, "none")["a"].overall == "failed"


def test_a_patch_of_the_harness_is_not_made(tmp_path: Path) -> None:
    """The file that it would patch is one of the test's, in the place where the harness lies."""
    place = ROOT / "build" / "wall-test"
    place.mkdir(parents=True, exist_ok=True)
    target = place / "harness.py"
    target.write_text("sound\n")
    submit(tmp_path, "patch", f"echo patched 2>/dev/null > {target}")
    try:
        check(tmp_path)
        assert target.read_text() == "sound\n"
        check(tmp_path, "none")
        assert target.read_text() == "patched\n"
    finally:
        target.unlink()


def test_the_reference_cannot_be_imported(tmp_path: Path) -> None:
    place = submit(tmp_path, "reference", "true")
    (place / "port.toml").write_text(
        'run = ["{python}", "-m", "occgrid", "{mode}", "--out", "{out}", "{scenario}"]\n'
    )
    verdict = check(tmp_path)["reference"]
    assert verdict.overall == "failed"
    assert "No module named occgrid" in verdict.summary
    assert check(tmp_path, "none")["reference"].overall == "identical"


def test_killing_its_parent_harms_nobody(tmp_path: Path) -> None:
    submit(tmp_path, "a-killer", "kill -9 $PPID; kill -9 -1; true")
    submit(tmp_path, "b-victim", "true")
    found = check(tmp_path)
    assert found["b-victim"].overall == "identical"
    assert found["a-killer"].overall == "failed"


def test_a_daemon_is_ended_and_named(tmp_path: Path) -> None:
    submit(tmp_path, "daemon", "setsid sleep 1000 >/dev/null 2>&1 &")
    notes = check(tmp_path)["daemon"].notes
    assert any("left a process running" in note for note in notes)


@pytest.fixture
def server() -> Iterator[tuple[int, list[str]]]:
    """A port of this machine, and who called there."""
    calls: list[str] = []
    with socket.create_server(("127.0.0.1", 0)) as listening:

        def answer() -> None:
            while True:
                try:
                    connection, caller = listening.accept()
                except OSError:
                    return
                calls.append(str(caller))
                connection.close()

        threading.Thread(target=answer, daemon=True).start()
        yield listening.getsockname()[1], calls


def test_no_connection(tmp_path: Path, server: tuple[int, list[str]]) -> None:
    number, calls = server
    code = f'use IO::Socket; exit(IO::Socket::INET->new("127.0.0.1:{number}") ? 0 : 1)'
    submit(tmp_path, "calls", f"perl -e '{code}' && exit 9")
    assert check(tmp_path)["calls"].overall == "identical"
    assert calls == []
    assert check(tmp_path, "none")["calls"].overall == "failed"
    deadline = time.monotonic() + 60
    while not calls and time.monotonic() < deadline:
        time.sleep(0.02)  # the thread of the server may be late
    assert len(calls) == 1


def test_building_is_behind_the_wall_and_in_a_copy(tmp_path: Path) -> None:
    place = submit(tmp_path, "builds", "test -f built || exit 9")
    (place / "map.sh").write_text(
        'test -f "$(dirname "$0")/built" || exit 9\n' + MAP
    )
    (place / "port.toml").write_text(
        'run = ["sh", "{port}/map.sh", "{scenario}"]\n'
        f'build = [["sh", "-c", "touch built; ! cat {GOLDEN}"]]\n'
    )
    assert check(tmp_path)["builds"].overall == "identical"
    assert not (place / "built").exists()
    assert check(tmp_path, "none")["builds"].failed_level is not None


def test_signals_and_names_are_told_as_without_a_wall(tmp_path: Path) -> None:
    submit(tmp_path, "crash", "kill -SEGV $$")
    absent = submit(tmp_path, "absent", "true")
    (absent / "port.toml").write_text('run = ["nowhere", "{scenario}"]\n')
    submit(tmp_path, "forks", "while :; do sleep 1000 & done")
    for sandbox in ("require", "none"):
        found = check(tmp_path, sandbox)
        words = {
            name: verdict.failed_level.word
            for name, verdict in found.items()
            if verdict.failed_level
        }
        assert words == {
            "crash": "crash",
            "absent": "not found",
            "forks": "forks",
        }
        assert "SIGSEGV" in found["crash"].summary


def test_without_bubblewrap(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(wall, "BUBBLEWRAP", "no-such-command")
    wall._problem.cache_clear()
    try:
        with pytest.raises(NoWall, match="install the package bubblewrap"):
            find_wall("require")
        found = find_wall("auto")
        assert not found.works
        assert found.reason == "install the package bubblewrap"
    finally:
        monkeypatch.undo()
        wall._problem.cache_clear()


def test_the_summary_has_the_points(tmp_path: Path) -> None:
    submit(tmp_path, "right", "true")
    check(tmp_path)
    with (tmp_path / "out" / "summary.csv").open(newline="") as file:
        row = next(csv.DictReader(file))
    assert (row["points"], row["maximum"]) == ("6", "6")
    text = tmp_path / "out" / "submissions" / "right" / "verdict.json"
    assert from_json(text.read_text()).overall == "identical"
