"""Progress of a run: a bar on a terminal, plain lines elsewhere."""

from __future__ import annotations

import threading
import time
from types import TracebackType
from typing import Self

from rich.console import Console
from rich.markup import escape
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeRemainingColumn,
)
from rich.progress import TimeElapsedColumn as Elapsed


class ConsoleProgress:
    """Tells a console how far a run is; use it in a ``with`` statement."""

    def __init__(self, console: Console) -> None:
        self.console = console
        self.steps = 0
        self.done = 0
        self.worked = 0
        self.running: dict[str, float] = {}
        self.started = time.monotonic()
        self.lock = threading.Lock()
        self.bar: Progress | None = None
        if console.is_terminal:
            columns = (
                TextColumn("{task.description}"),
                BarColumn(),
                Elapsed(),
                TimeRemainingColumn(),
            )
            self.bar = Progress(
                *columns, MofNCompleteColumn(), console=console
            )
            self.task = self.bar.add_task("run", total=None)

    def __enter__(self) -> Self:
        if self.bar is not None:
            self.bar.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self.bar is not None:
            self.bar.stop()

    def total(self, steps: int) -> None:
        """How many steps there are."""
        self.steps = steps
        if self.bar is not None:
            self.bar.update(self.task, total=steps)

    def begin(self, name: str) -> None:
        """Work on something has begun."""
        with self.lock:
            self.running[name] = time.monotonic()
            self._describe()

    def end(self, name: str) -> None:
        """That work is over."""
        with self.lock:
            self.running.pop(name, None)
            self.worked += 1
            self._describe()

    def step(self, text: str) -> None:
        """One step is done."""
        with self.lock:
            self.done += 1
            if self.bar is not None:
                self.bar.console.print(text, markup=False, highlight=False)
                self.bar.advance(self.task)
            else:
                line = f"[{self.done}/{self.steps}{self._outlook()}] {text}"
                self.console.print(
                    line, markup=False, highlight=False, soft_wrap=True
                )

    def _describe(self) -> None:
        """On a terminal: the names of what is being worked on."""
        if self.bar is not None:
            names = escape(", ".join(self.running) or "run")
            self.bar.update(self.task, description=names)

    def _outlook(self) -> str:
        """Elsewhere: how long it will take, and what is being worked on; where that is known."""
        if not self.worked or self.done >= self.steps:
            return ""
        each = (time.monotonic() - self.started) / self.worked
        minutes = each * (self.steps - self.done) / 60
        left = f", about {minutes:.0f} min" if minutes >= 1 else ""
        names = ", ".join(self.running)
        return f"{left}, running {names}" if names else left
