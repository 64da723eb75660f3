"""Work in processes of its own, which can be ended at any time. One that dies costs nobody else."""

from __future__ import annotations

import multiprocessing
import os
import queue
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from types import FrameType
from typing import TypeVar

import psutil

from occgrid_parity.processes.process_group import Stopped
from occgrid_parity.processes.process_tree import kill_tree

if sys.platform != "win32":
    from occgrid_parity.processes.posix_limits import PR_SET_PDEATHSIG, prctl

T = TypeVar("T")
R = TypeVar("R")

LOOK = 0.1  # seconds between two looks whether to stop
GRACE = 8.0  # seconds that a process has to end its own children
TRIES = 2


class WorkerLost(Exception):
    """The process that did the work died, and so did the next that tried."""


class WorkerSlots:
    """Processes for so much work at a time. Each does one piece after the other, and keeps what it has read."""

    def __init__(self, jobs: int) -> None:
        # the one that has worked last is taken first: what it has read is there
        self.free: queue.LifoQueue[_Worker | None] = queue.LifoQueue()
        self.at_work: set[int] = set()
        for _ in range(jobs):
            self.free.put(None)

    def run(
        self, work: Callable[[T], R], argument: T, stop: threading.Event
    ) -> R:
        """Does the work in a free process.

        Raises Stopped when ``stop`` is set meanwhile, and WorkerLost where the process dies twice.
        """
        worker = self.free.get()
        try:
            for _ in range(TRIES):
                if stop.is_set():
                    raise Stopped
                try:
                    worker = worker or _Worker()
                    return self._do(worker, work, argument, stop)
                except (BrokenProcessPool, Stopped) as error:
                    if worker is not None:
                        worker.end()
                    worker = None
                    if isinstance(error, Stopped):
                        raise
            raise WorkerLost(f"the process that did it died {TRIES} times")
        finally:
            self.free.put(worker)

    def _do(
        self,
        worker: _Worker,
        work: Callable[[T], R],
        argument: T,
        stop: threading.Event,
    ) -> R:
        self.at_work.add(worker.process.pid)
        try:
            return worker.run(work, argument, stop)
        finally:
            self.at_work.discard(worker.process.pid)

    def working(self) -> list[int]:
        """The numbers of the processes that work now."""
        return list(self.at_work)

    def close(self) -> None:
        """Ends the processes."""
        while not self.free.empty():
            worker = self.free.get()
            try:
                if worker is not None:
                    worker.end()
            except BaseException:
                self.free.put(worker)  # a signal: the next close finds it
                raise


class _Worker:
    """One process."""

    def __init__(self) -> None:
        if sys.platform != "win32":  # Ctrl-C is for the parent
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        self.executor = ProcessPoolExecutor(
            1, multiprocessing.get_context("spawn"), initializer=_prepare
        )
        self.process = psutil.Process(self.executor.submit(os.getpid).result())

    def run(
        self, work: Callable[[T], R], argument: T, stop: threading.Event
    ) -> R:
        future = self.executor.submit(work, argument)
        while not future.done():
            wait([future], timeout=LOOK)
            if stop.is_set() and not future.done():
                self._stop()
                wait([future], timeout=GRACE)
                raise Stopped
        return future.result()

    def _stop(self) -> None:
        """Asks the process to end its work, and what it has started; Windows cannot ask."""
        if sys.platform == "win32":
            kill_tree(self.process)
        else:
            with suppress(psutil.NoSuchProcess):
                self.process.terminate()

    def end(self) -> None:
        """Ends the process and whatever it has started."""
        kill_tree(self.process)
        self.executor.shutdown(wait=True, cancel_futures=True)


def _prepare() -> None:
    """In the new process: SIGTERM ends the work at hand; the parent's death ends all."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _stop_work)
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def _stop_work(number: int, frame: FrameType | None) -> None:
    raise SystemExit(128 + number)
