"""A class on many machines: the tasks of the class on a Dask cluster."""

from __future__ import annotations

import importlib
import threading
from typing import Any

from occgrid_parity.course.submission_task import (
    SKIPPED,
    Checked,
    Task,
    check_task,
)
from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.worker_slots import WorkerLost

LOOK = 0.2  # seconds between two looks whether to stop
CONNECT = 30.0
RETRIES = 3


class NoCluster(Exception):
    """There is no cluster at the address, or nothing to reach it with."""


class Cluster:
    """The machines behind a scheduler. Each of them has this suite installed."""

    def __init__(self, address: str) -> None:
        try:
            distributed: Any = importlib.import_module("distributed")
        except ImportError as error:
            raise NoCluster(
                "--scheduler needs the package distributed: pip install 'occgrid-parity[cluster]'"
            ) from error
        try:
            self.client: Any = distributed.Client(
                address, timeout=CONNECT, set_as_default=False
            )
        except (OSError, ValueError, TimeoutError) as error:
            raise NoCluster(
                f"there is no scheduler at {address}: {error}"
            ) from error

    @property
    def dashboard(self) -> str:
        """The address of the page that shows the cluster at work."""
        return str(self.client.dashboard_link)

    @property
    def jobs(self) -> int:
        """How many tasks the cluster does at a time, now."""
        threads: dict[str, int] = self.client.nthreads()
        return max(1, sum(threads.values()))

    def run(self, task: Task, stop: threading.Event) -> Checked:
        """Does a task on some machine, on another one where that dies or lacks what the submission needs.

        Raises Stopped when ``stop`` is set meanwhile, and WorkerLost where no machine could finish it.
        """
        tried: list[str] = []
        for _ in range(RETRIES):
            others = [w for w in self.client.nthreads() if w not in tried]
            if tried and not others:
                break
            where, checked = self._once(task, stop, others if tried else None)
            tried.append(where)
            if checked.word != SKIPPED:
                break
        return checked

    def _once(
        self, task: Task, stop: threading.Event, where: list[str] | None
    ) -> tuple[str, Checked]:
        from distributed import KilledWorker

        future = self.client.submit(
            check_there, task, workers=where, pure=False
        )
        while not future.done():
            if stop.wait(LOOK):
                future.cancel()
                raise Stopped
        try:
            found: tuple[str, Checked] = future.result()
        except KilledWorker as error:
            raise WorkerLost(str(error)) from error
        return found

    def close(self) -> None:
        """Takes leave of the scheduler."""
        self.client.close()


def check_there(task: Task) -> tuple[str, Checked]:
    """On a machine of the cluster: its address, and what came of the task."""
    from distributed import get_worker

    return str(get_worker().address), check_task(task)
