"""A copy of the repository in which documents' commands find what they speak of."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

# What builds and set-up have made: shared with the copy.
MADE = (
    ".venv",
    "java/target",
    "web/node_modules",
)
# The ports that are built in the copy: CMake's folder works in one place only.
BUILT_THERE = ("cpp",)
GIT = ("git", "-c", "user.name=copy", "-c", "user.email=copy@localhost")


def lay_out(root: Path, copy: Path) -> Path:
    """The repository's files as they are now, committed in a repository of their own, and what a user brings along."""
    listed = subprocess.run(
        [
            "git",
            "ls-files",
            "-z",
            "--cached",
            "--others",
            "--exclude-standard",
        ],
        cwd=root,
        capture_output=True,
        check=True,
    ).stdout.decode()
    for name in filter(None, listed.split("\0")):
        if (root / name).is_file():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, copy / name)
    _bring(copy)
    for command in (
        ["git", "init", "-q"],
        ["git", "add", "--all"],
        [*GIT, "commit", "-q", "-m", "as it is"],
    ):
        subprocess.run(command, cwd=copy, check=True)
    exclude = copy / ".git" / "info" / "exclude"
    # the class is the course's own folder
    exclude.write_text("".join(f"/{name}\n" for name in (*MADE, "class/")))
    for name in MADE:
        if (root / name).exists():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            (copy / name).symlink_to(root / name)
    return copy


def _bring(copy: Path) -> None:
    """A student's program, a class, a log: what documents take for granted."""
    run = [sys.executable, "-m", "occgrid", "--noise-free"]
    for folder in (copy, copy / "compare"):
        program = folder / "my_program"
        program.write_text(
            "#!/bin/sh\n"
            f"if [ $# -eq 0 ]; then exec {' '.join(run)}; fi\n"
            f'exec {" ".join(run)} --out "$2" "$1"\n'
        )
        program.chmod(0o755)
    command = f'["{sys.executable}", "-m", "occgrid", "{{mode}}", "--out", "{{out}}", "{{scenario}}"]'
    for name in ("submissions/team-a", "submitted/ada/mapping"):
        (copy / name).mkdir(parents=True)
        (copy / name / "port.toml").write_text(f"run = {command}\n")
    rules = 'sandbox = "none"\n[check]\nsuite = false\nscenarios = ["course.log"]\n'
    scenarios = copy / "scenarios"
    for folder in (copy, copy / "submissions"):
        (folder / "class.toml").write_text(rules)
        shutil.copy(scenarios / "one-beam.log", folder / "course.log")
    (copy / "port.toml").write_text(f"run = {command}\n")
    (copy / "roster.csv").write_text(
        'submission,Student,ID,SIS Login ID,Section,Email address\nteam-a,"Doe, Jane",101,jdoe,1,jdoe@example.org\n'
    )
    shutil.copy(scenarios / "flaser.log", copy / "intel.gfs.log")
    # a robot's log has none of the lines that make it a scenario
    lines = (scenarios / "flaser.log").read_text().splitlines(keepends=True)
    log = [line for line in lines if line.startswith("FLASER ")]
    (copy / "compare" / "robot.clf").write_text("".join(log))
