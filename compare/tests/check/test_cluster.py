"""A class on a Dask cluster of two workers on this machine, one of which is killed in the middle of the work."""

from __future__ import annotations

import csv
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from ..check_helpers import PROGRAMS
from ..loopback_cluster import PYTHON, kill_at_work, loopback_cluster

pytestmark = pytest.mark.long


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[Any]]]:
    """The address of a scheduler, and its two workers."""
    with loopback_cluster(tmp_path) as found:
        yield found


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
    kill_at_work(workers[0])
    printed, _ = run.communicate(timeout=600)
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
