"""Work on many machines: a Dask cluster, which the extra ``cluster`` reaches."""

from __future__ import annotations

import importlib
import threading
from collections.abc import Callable
from concurrent.futures import CancelledError
from pathlib import Path
from typing import Any, TypeVar

from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.worker_slots import WorkerLost

T = TypeVar("T")
R = TypeVar("R")

LOOK = 0.2  # seconds between two looks whether to stop
CONNECT = 30.0


class NoCluster(ConnectionError):
    """There is no cluster at the address, or nothing to reach it with."""


def never(result: object) -> bool:
    """No result is worth a try on another machine."""
    return False


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
        """How many pieces of work the cluster does at a time, now."""
        threads: dict[str, int] = self.client.nthreads()
        return max(1, sum(threads.values()))

    def run(
        self,
        work: Callable[[T], R],
        argument: T,
        stop: threading.Event,
        elsewhere: Callable[[R], bool] = never,
    ) -> R:
        """Does a piece of work on some machine; on another one where that dies, or where ``elsewhere`` says so.

        Raises Stopped when ``stop`` is set meanwhile, and WorkerLost where no machine could finish it.
        """
        tried: list[str] = []
        others: list[str] | None = None
        while True:
            where, result = self._once(work, argument, stop, others)
            if not elsewhere(result):
                return result
            tried.append(where)
            others = [w for w in self.client.nthreads() if w not in tried]
            if not others:
                return result

    def _once(
        self,
        work: Callable[[T], R],
        argument: T,
        stop: threading.Event,
        where: list[str] | None,
    ) -> tuple[str, R]:
        from distributed import KilledWorker

        future = self.client.submit(
            work_there, work, argument, workers=where, pure=False
        )
        while not future.done():
            if stop.wait(LOOK):
                future.cancel()
                raise Stopped
            if where and not set(where) & set(self.client.nthreads()):
                future.cancel()  # all of these machines are gone
                return self._once(work, argument, stop, None)
        try:
            found: tuple[str, R] = future.result()
        except KilledWorker as error:
            raise WorkerLost(str(error)) from error
        except CancelledError as error:
            raise WorkerLost("the scheduler is gone") from error
        return found

    def close(self) -> None:
        """Takes leave of the scheduler."""
        self.client.close()


def work_there(work: Callable[[T], R], argument: T) -> tuple[str, R]:
    """On a machine of the cluster: its address, and what came of the work."""
    from distributed import get_worker

    return str(get_worker().address), work(argument)


def folder_here() -> Path:
    """On a machine of the cluster: a folder of its own, which lasts as long as the worker."""
    from distributed import get_worker

    return Path(get_worker().local_directory)
