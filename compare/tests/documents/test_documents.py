"""Every command that a document prints is run as it is printed, or has a reason why not; its output is as shown."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port

from ..conftest import PORTS, ROOT, unavailable
from .documented_commands import (
    DOCUMENTS,
    NOT_RUN,
    NOT_RUN_WHOLE,
    Documented,
    documented,
)
from .stand_ins import BUILT_THERE, lay_out

COMMANDS = {name: documented(ROOT, name) for name in DOCUMENTS}
# A check's levels and their noise take an interpreter minutes.
SECONDS = 1200
RUN = [
    name
    for name, commands in COMMANDS.items()
    if any(not c.reason for c in commands)
]


def test_every_document_with_commands_is_known() -> None:
    tracked = subprocess.run(
        ["git", "ls-files", "*.md"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.split()
    for name in tracked:
        assert name in DOCUMENTS or not documented(ROOT, name), (
            f"{name} prints commands: name it in DOCUMENTS of documented_commands.py"
        )


def test_every_reason_is_needed() -> None:
    """What is not run is still printed somewhere."""
    printed = [c.command for one in COMMANDS.values() for c in one]
    assert [c for c in NOT_RUN_WHOLE if c not in printed] == []
    for start in NOT_RUN:
        assert any(c.startswith(start) for c in printed), start


def test_lines_of_a_block_are_told_apart(tmp_path: Path) -> None:
    (tmp_path / "a.md").write_text(
        "Text\n\n"
        "    make all     # everything\n"
        "    sh run.sh --plain \\\n        --out maps\n\n"
        "- item\n\n      .venv/bin/occgrid\n\n"
        "```text\nshown\n```\n\n"
        "```toml\nrun = 1\n```\n\n"
        "    submissions/\n"
    )
    assert documented(tmp_path, "a.md") == [
        Documented("a.md", 3, "make all"),
        Documented("a.md", 4, "sh run.sh --plain --out maps"),
        Documented("a.md", 9, ".venv/bin/occgrid", "shown\n"),
    ]


def needed_ports(commands: list[Documented]) -> list[Port]:
    """The ports whose programs they start."""
    texts = [f"{c.document} {c.command}" for c in commands]
    return [port for port in PORTS if any(f"{port.name}/" in t for t in texts)]


@pytest.mark.long
@pytest.mark.parametrize("document", RUN)
def test_commands_run_as_they_are_printed(
    document: str, tmp_path: Path
) -> None:
    """In a copy of the repository, in the order of the document; what they leave behind is ignored by git."""
    commands = [c for c in COMMANDS[document] if not c.reason]
    for port in needed_ports(commands):
        missing = [need.install for need in port.needs if need.is_missing()]
        if missing:
            unavailable(f"{port.name}: install {', '.join(missing)}")
    copy = lay_out(ROOT, tmp_path / "copy")
    environment = {
        **os.environ,
        "PATH": f"{ROOT}/.venv/bin{os.pathsep}{os.environ['PATH']}",
    }
    for port in needed_ports(commands):
        if port.name in BUILT_THERE:
            build = ["occgrid-parity", "build", port.name]
            subprocess.run(build, cwd=copy, env=environment, check=True)
    shown: list[str] = []
    for one in commands:
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", one.command],
            cwd=copy / DOCUMENTS[document],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=SECONDS,
        )
        said = (done.stdout[-4000:] + done.stderr[-4000:]).decode(
            errors="replace"
        )
        where = f"{document}:{one.line}: {one.command}\n{said}"
        assert done.returncode == 0, where
        shown += (
            (done.stdout + done.stderr).decode(errors="replace").splitlines()
        )
        for line in one.output.splitlines():
            assert line in shown, (
                f"{line!r} is not in what was printed: {where}"
            )
    left = subprocess.run(
        ["git", "status", "--porcelain", "--untracked-files=all"],
        cwd=copy,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert left == "", f"{document} leaves behind\n{left}"
