"""A class on a Dask cluster of two workers on this machine, one of which is killed in the middle of the work."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from ..check_helpers import PROGRAMS

pytestmark = pytest.mark.long

distributed: Any = pytest.importorskip("distributed")

PYTHON = [sys.executable, "-m"]


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[Any]]]:
    """The address of a scheduler, and its two workers, each in a folder of its own."""
    file = tmp_path / "scheduler.json"
    command = [
        *PYTHON, "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
        "--scheduler-file", str(file),
    ]  # fmt: skip
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    started: list[Any] = [subprocess.Popen(command, **quiet)]  # type: ignore[call-overload]
    try:
        deadline = time.monotonic() + 90
        while not file.is_file() and time.monotonic() < deadline:
            time.sleep(0.1)
        address = json.loads(file.read_text())["address"]
        for number in range(2):
            place = tmp_path / f"worker-{number}"
            place.mkdir()
            command = [
                *PYTHON, "distributed.cli.dask_worker", address, "--no-nanny", "--nthreads", "1",
                "--no-dashboard", "--local-directory", str(place),
            ]  # fmt: skip
            started.append(subprocess.Popen(command, cwd=place, **quiet))  # type: ignore[call-overload]
        with distributed.Client(address, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=90)
        yield address, started[1:]
    finally:
        for process in started:
            process.kill()
            process.wait()


def check(folder: Path, out: str, *options: str) -> str:
    ended = subprocess.run(
        [*PYTHON, "occgrid_parity", "check", "--class", "in", "--out", out, "--scenario", "prior", "--timeout", "60",
         *options],
        cwd=folder,
        text=True,
        capture_output=True,
    )  # fmt: skip
    assert ended.returncode == 1, ended.stdout + ended.stderr
    return ended.stdout


def results(folder: Path, out: str) -> tuple[list[dict[str, str]], list[str]]:
    """The summary and the verdicts, without what a clock says."""
    with (folder / out / "summary.csv").open(newline="") as file:
        rows = [row | {"seconds": ""} for row in csv.DictReader(file)]
    texts = [
        re.sub(r'"seconds": [0-9.]+', "", path.read_text()).replace(
            f"{out}/submissions/", "OUT/"
        )
        for path in sorted(folder.glob(f"{out}/submissions/*/verdict.json"))
    ]
    return rows, texts


def test_a_killed_worker_changes_nothing(
    tmp_path: Path, cluster: tuple[str, list[Any]]
) -> None:
    address, workers = cluster
    for number in range(4):
        place = tmp_path / "in" / f"s{number}"
        place.mkdir(parents=True)
        program = PROGRAMS / "lesson.awk"
        (place / "lesson.awk").write_bytes(program.read_bytes())
        bug = "prior" if number == 1 else ""
        (place / "port.toml").write_text(
            f'run = ["sh", "-c", "sleep 3; exec awk -f $0 -v bug={bug} $1", "lesson.awk", "{{scenario}}"]\n'
        )
    lacking = tmp_path / "in" / "tool"
    lacking.mkdir()
    (lacking / "port.toml").write_text(
        'run = ["no-such-tool"]\n[[needs]]\ncommand = "no-such-tool"\ninstall = "a-tool"\n'
    )
    run = subprocess.Popen(
        [*PYTHON, "occgrid_parity", "check", "--class", "in", "--out", "there", "--scenario", "prior", "--timeout",
         "60", "--scheduler", address],
        cwd=tmp_path,
        text=True,
        stdout=subprocess.PIPE,
    )  # fmt: skip
    victim = psutil.Process(workers[0].pid)
    deadline = time.monotonic() + 90
    while not victim.children(recursive=True):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    victim.kill()
    printed, _ = run.communicate(timeout=240)
    assert run.returncode == 1, printed
    assert "dashboard: " in printed
    check(tmp_path, "here")
    assert results(tmp_path, "there") == results(tmp_path, "here")
    rows, _ = results(tmp_path, "there")
    words = {row["submission"]: row["word"] for row in rows}
    assert words == {
        "s0": "",
        "s1": "differs",
        "s2": "",
        "s3": "",
        "tool": "skipped",
    }
