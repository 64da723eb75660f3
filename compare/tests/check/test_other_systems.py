"""What the check does where the system has less to offer than Linux: it says so, and holds programs to its limits."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from occgrid_parity.processes import limits, supervisor_server
from occgrid_parity.processes.limits import MEBI, Limits, not_held, run_limited
from occgrid_parity.programs.command_words import join_words, split_words

from ..like_windows import SUPERVISOR

LIKE_WINDOWS = Path(__file__).parents[1] / "like_windows.py"


def like_windows(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs a module as if it were on Windows."""
    return subprocess.run(
        [sys.executable, str(LIKE_WINDOWS), *arguments],
        capture_output=True,
        text=True,
        timeout=600,
    )


def test_nothing_that_only_posix_has_is_imported_at_the_top() -> None:
    ended = like_windows("all")
    assert (ended.returncode, ended.stderr) == (0, "")


def test_the_verdict_says_what_could_not_be_limited(tmp_path: Path) -> None:
    words = [sys.executable, "-m", "occgrid", "{mode}", "--out", "{out}", "{scenario}"]  # fmt: skip
    ended = like_windows(
        "occgrid_parity", "check", "--run", join_words(words),
        "--scenario", "one-beam", "--out", str(tmp_path / "check"),
    )  # fmt: skip
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "note: Windows sets no limits for a program" in ended.stdout
    record = json.loads((tmp_path / "check" / "verdict.json").read_text())
    assert record["overall"] == "identical"
    assert any("can stay unseen" in note for note in record["notes"])


@pytest.mark.parametrize(
    ("word", "code"),
    {
        "": "print(1)",
        "crash": "raise SystemExit(3)",
        "hang": "import time; time.sleep(1000)",
        "too much output": "while True: print('x' * 1000000)",
        "too much memory": "x = bytearray(b'x' * 200000000)\nimport time; time.sleep(1000)",
        "forks": "import os, time\nfor _ in range(40): os.fork() or time.sleep(1000)\ntime.sleep(1000)",
    }.items(),
)  # fmt: skip
def test_limits_that_the_system_does_not_set(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, word: str, code: str
) -> None:
    """What a program takes is looked at instead."""
    monkeypatch.setattr(limits, "SUPERVISOR", (str(LIKE_WINDOWS), SUPERVISOR))
    monkeypatch.setattr(supervisor_server, "WORKS", False)
    ended = run_limited(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        folder=tmp_path / "run",
        watch=tmp_path / "out",
        limits=Limits(100 if word != "hang" else 1, 4 * MEBI, 128 * MEBI, 8),
    )
    assert ended.word == word, ended.message


def test_limits_that_the_system_refuses_are_named() -> None:
    assert not_held() == ()
    assert not_held("memory") == (
        "this system refused to limit the program's memory",
    )


def test_a_command_is_split_as_its_shell_does() -> None:
    text = r'python "C:\My maps\map.py" {scenario} --box=[0,1]'
    words = ["python", r"C:\My maps\map.py", "{scenario}", "--box=[0,1]"]
    assert split_words(text, windows=True) == words
    assert split_words(join_words(words, True), True) == words
    assert split_words(join_words(words, False), False) == words
