"""A run and a campaign on a Dask cluster, one of whose two workers is killed: the results are those of this machine."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from occgrid_parity.campaign import campaign_record
from occgrid_parity.compare import run_record

from .conftest import ROOT
from .loopback_cluster import PYTHON, kill_at_work, loopback_cluster

pytestmark = pytest.mark.long

SLOWLY = 'sleep 1; PYTHONPATH="$0" exec "$@"'
TOY = [
    *("sh", "-c", SLOWLY, "{port}", "{python}", "-m", "occgrid"),
    *("{mode}", "--out", "{out}", "{scenarios}"),
]
NAMES = ("one-beam", "octants", "prior")


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[Any]]]:
    """The address of a scheduler, and its two workers."""
    with loopback_cluster(tmp_path) as found:
        yield found


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """The Python port, a slow copy of it with a fault, and a port that no machine can run."""
    root = tmp_path / "repository"
    root.mkdir()
    shutil.copy(ROOT / "SPEC.md", root)
    shutil.copytree(ROOT / "scenarios", root / "scenarios")
    (root / "python").mkdir()
    shutil.copy(ROOT / "python/port.toml", root / "python")
    toy = root / "toy"
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "python/occgrid", toy / "occgrid", ignore=ignored)
    sensor = toy / "occgrid" / "sensor.py"
    text = sensor.read_text()
    sensor.write_text(text.replace("ranges < z_max", "ranges <= z_max"))
    (toy / "port.toml").write_text(
        f'name = "toy"\nlanguage = "slow"\nrun = {json.dumps(TOY)}\ntimeout = 60\nscenarios_at_once = 1\n'
        'build = [["sh", "-c", "echo built > {port}/note"]]\n'
    )
    lacking = root / "lacking"
    lacking.mkdir()
    (lacking / "port.toml").write_text(
        f'name = "lacking"\nlanguage = "none"\nrun = {json.dumps(TOY)}\ntimeout = 60\n'
        '[[needs]]\ncommand = "no-such-tool"\ninstall = "a-tool"\n'
    )
    return root


def start(root: Path, *options: str) -> subprocess.Popen[str]:
    """A command of the harness."""
    return subprocess.Popen(
        [*PYTHON, "occgrid_parity", *options],
        cwd=root,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )


def finish(running: subprocess.Popen[str], status: int) -> str:
    printed, _ = running.communicate(timeout=600)
    assert running.returncode == status, printed
    return printed


def results(folder: Path) -> list[run_record.Result]:
    """The results of a run, without the numbers of the processes."""
    record = run_record.from_json((folder / "run.json").read_text())
    return [replace(one, process=None) for one in record.results]


def test_a_run(
    repository: Path, tmp_path: Path, cluster: tuple[str, list[Any]]
) -> None:
    address, workers = cluster
    options = ["run", "--mode", "noise-free"]
    for name in NAMES:
        options += ["--scenario", name]
    there, here = tmp_path / "there", tmp_path / "here"
    running = start(
        repository, *options, "--scheduler", address, "--out", str(there)
    )
    kill_at_work(workers[0])
    assert "dashboard: " in finish(running, 1)
    assert not (repository / "toy" / "note").exists()  # it was built elsewhere
    finish(start(repository, *options, "--out", str(here)), 1)
    found = results(there)
    assert found == results(here)
    statuses = {(one.port, one.scenario): one.status for one in found}
    for name in NAMES:
        assert statuses["toy", name] == "identical"
        assert statuses["lacking", name] == "skipped"
        same = Path("toy", "noise-free", f"scenario-{name}", f"{name}.logodds")
        assert (there / same).read_bytes() == (here / same).read_bytes()


def test_a_campaign(
    repository: Path, tmp_path: Path, cluster: tuple[str, list[Any]]
) -> None:
    address, workers = cluster
    options = [
        *("campaign", "--port", "toy", "--worlds", "36", "--shorten", "1"),
    ]
    there, here = tmp_path / "there", tmp_path / "here"
    running = start(
        repository, *options, "--scheduler", address, "--out", str(there)
    )
    kill_at_work(workers[0])
    finish(running, 1)
    finish(start(repository, *options, "--out", str(here)), 1)
    found, expected = (
        campaign_record.from_json((place / "campaign.json").read_text())
        for place in (there, here)
    )
    assert found.differences == expected.differences
    assert found.differences[0].text
    for one, other in zip(found.programs, expected.programs, strict=True):
        assert replace(one, version="") == replace(other, version="")
