"""Progress of a run: a bar on a terminal, plain lines elsewhere."""

from __future__ import annotations

import threading
from types import TracebackType
from typing import Self

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
from rich.progress import TimeElapsedColumn as Elapsed


class ConsoleProgress:
    """Tells a console how far a run is; use it in a ``with`` statement."""

    def __init__(self, console: Console) -> None:
        self.console = console
        self.steps = 0
        self.done = 0
        self.lock = threading.Lock()
        self.bar: Progress | None = None
        if console.is_terminal:
            columns = (
                TextColumn("{task.description}"),
                BarColumn(),
                Elapsed(),
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

    def step(self, text: str) -> None:
        """One step is done."""
        with self.lock:
            self.done += 1
            if self.bar is not None:
                self.bar.console.print(text, markup=False, highlight=False)
                self.bar.advance(self.task)
            else:
                line = f"[{self.done}/{self.steps}] {text}"
                self.console.print(
                    line, markup=False, highlight=False, soft_wrap=True
                )
