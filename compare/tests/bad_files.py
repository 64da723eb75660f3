"""What the tests of bad input share: the files of scenarios/bad, and a run of a port on one file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import Finished, run_process

from .conftest import ROOT

BAD = ROOT / "scenarios" / "bad"


def bad_files() -> list[tuple[Path, int, str]]:
    """Each file of scenarios/bad with the line and the reason of its error."""
    found = []
    for text in (BAD / "expected.txt").read_text("ascii").splitlines():
        name, line, reason = text.split(":", 2)
        found.append((BAD / name, int(line), reason.removeprefix(" ")))
    return found


@dataclass(frozen=True)
class Answer:
    """How a port ended, what it said and what it left in the folder for its maps."""

    finished: Finished
    stdout: bytes
    stderr: bytes
    maps: dict[str, bytes]


def map_into(
    port: Port, file: Path, out: Path, work: Path, prefix: Sequence[str] = ()
) -> Finished:
    """Runs a port on a scenario, noise-free; what it says goes to files in ``work``."""
    run = port.command(
        port.run,
        mode=["--noise-free"],
        out=out,
        scenario=[file],
        scenarios=[file],
    )
    return run_process(
        [*prefix, *run],
        cwd=port.folder,
        stdout=work / "stdout",
        stderr=work / "stderr",
        time_limit=port.timeout,
    )


def give(
    port: Port, file: Path, work: Path, prefix: Sequence[str] = ()
) -> Answer:
    """Runs a port on a scenario, noise-free, with an empty folder to write into."""
    out = work / "out"
    out.mkdir(parents=True)
    finished = map_into(port, file, out, work, prefix)
    return Answer(
        finished,
        finished.stdout.read_bytes(),
        finished.stderr.read_bytes(),
        {path.name: path.read_bytes() for path in sorted(out.iterdir())},
    )


def check_refused(answer: Answer, file: Path, line: int, reason: str) -> None:
    """Fails the test without status 1 and exactly one line on standard error, or with anything else anywhere."""
    expected = f"{file}:{line}: {reason}\n".encode("latin-1")
    found = (
        answer.finished.exit_status,
        answer.stderr,
        answer.stdout,
        list(answer.maps),
    )
    if found != (1, expected, b"", []):
        status, stderr, stdout, maps = found
        pytest.fail(
            f"{file}\nexpected: status 1, {expected!r}\n"
            f"found: status {status}, {stderr[:1000]!r}, on standard output {stdout[:100]!r}, maps {maps}",
            pytrace=False,
        )
