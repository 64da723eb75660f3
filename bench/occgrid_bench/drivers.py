"""A contestant's process: it waits between its turns, so that turns can be interleaved."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Self


class DriverError(Exception):
    """A contestant did not answer; its text is what it said on standard error."""


class Driver:
    """Answers requests by lines (see bench/cpp/driver.hpp). Use it in a ``with`` statement."""

    def __init__(self, command: Sequence[str], environment: dict[str, str]):
        self._errors = tempfile.TemporaryFile("w+")
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            text=True,
            env=environment,
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is not None:
            self._process.kill()
        assert self._process.stdin and self._process.stdout
        self._process.stdin.close()
        self._process.stdout.close()
        self._process.wait()
        self._errors.close()

    def map(self, times: int) -> list[float]:
        """Map the work so many times; the seconds of each."""
        return [float(word) for word in self._ask(f"map {times}").split()]

    def write(self, path: Path) -> None:
        """Write the log-odds of the last map."""
        self._ask(f"write {path}")

    def _ask(self, request: str) -> str:
        assert self._process.stdin and self._process.stdout
        try:
            print(request, file=self._process.stdin, flush=True)
            answer = self._process.stdout.readline()
        except BrokenPipeError:
            answer = ""
        if not answer.strip():
            self._errors.seek(0)
            raise DriverError(self._errors.read().strip() or "no answer")
        return answer


def run_once(command: Sequence[str], environment: dict[str, str]) -> float:
    """Run a contestant that maps once and prints its seconds."""
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        env=environment,
    )
    try:
        return float(done.stdout.split()[-1])
    except (ValueError, IndexError):
        said = (done.stdout + done.stderr).strip()
        raise DriverError(said or "no answer") from None
