"""Several pieces of work side by side, stopped together."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from concurrent.futures import (
    FIRST_EXCEPTION,
    Future,
    ThreadPoolExecutor,
    wait,
)
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")


def side_by_side(
    work: Callable[[T, threading.Event], R], items: Sequence[T], jobs: int
) -> list[R]:
    """Does the work on each item, ``jobs`` at a time; the results are in order.

    Where one raises or the user interrupts, the event is set, which stops the others;
    what has not begun does not begin.
    """
    stop = threading.Event()
    pool = ThreadPoolExecutor(jobs)
    try:
        futures: list[Future[R]] = [
            pool.submit(work, item, stop) for item in items
        ]
        wait(futures, return_when=FIRST_EXCEPTION)
        return [future.result() for future in futures]
    except BaseException:
        stop.set()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
