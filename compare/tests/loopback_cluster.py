"""A Dask cluster on this machine: a scheduler and two workers, each in a folder of its own."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import distributed
import psutil

PYTHON = [sys.executable, "-m"]


@contextmanager
def loopback_cluster(folder: Path) -> Iterator[tuple[str, list[Any]]]:
    """The address of the scheduler, and the processes of the workers."""
    file = folder / "scheduler.json"
    command = [
        *PYTHON, "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
        "--scheduler-file", str(file),
    ]  # fmt: skip
    quiet: dict[str, Any] = {
        "stdout": subprocess.DEVNULL,
        "stderr": subprocess.DEVNULL,
    }
    started = [subprocess.Popen(command, **quiet)]
    try:
        address = written_address(file)
        for number in range(2):
            place = folder / f"worker-{number}"
            place.mkdir()
            command = [
                *PYTHON, "distributed.cli.dask_worker", address, "--no-nanny", "--nthreads", "1",
                "--no-dashboard", "--local-directory", str(place),
            ]  # fmt: skip
            started.append(subprocess.Popen(command, cwd=place, **quiet))
        connect: Any = distributed.Client
        with connect(address, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=300)
        yield address, started[1:]
    finally:
        for process in started:
            process.kill()
            process.wait()


def written_address(file: Path) -> str:
    """The scheduler's address, as soon as its file is written to the end."""
    deadline = time.monotonic() + 300
    while True:
        try:
            return str(json.loads(file.read_text())["address"])
        except (FileNotFoundError, json.JSONDecodeError):
            assert time.monotonic() < deadline, "the scheduler does not start"
            time.sleep(0.1)


def kill_at_work(worker: subprocess.Popen[bytes]) -> None:
    """Kills a worker as soon as a program runs in it."""
    victim = psutil.Process(worker.pid)
    deadline = time.monotonic() + 300
    while not victim.children(recursive=True):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    victim.kill()
