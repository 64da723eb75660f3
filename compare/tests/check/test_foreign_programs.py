"""Programs in languages that are no ports, checked from an installed wheel.

Right ones are never wrong; planted mistakes are found, in the right scan and beam, and named.
"""

from __future__ import annotations

import json
import shlex
import shutil
import sys
from pathlib import Path

import pytest

from ..check_helpers import PROGRAMS, check_words, names
from .conftest import Installed

pytestmark = pytest.mark.long

PERL, AWK = shutil.which("perl"), shutil.which("awk")
NEEDS_PERL = pytest.mark.skipif(PERL is None, reason="install perl")
NEEDS_AWK = pytest.mark.skipif(AWK is None, reason="install awk")


def perl(bug: str = "none") -> str:
    return f"perl {{port}}/programs/lesson.pl --bug {bug} {{mode}} --out {{out}} {{scenario}}"


def awk(bug: str = "none") -> str:
    return f"awk -v bug={bug} -f {{port}}/programs/lesson.awk {{scenario}}"


def test_the_wheel_needs_no_repository(installed: Installed) -> None:
    said = "import occgrid, occgrid_parity as p; print(p.__file__, occgrid.__file__)"
    ended = installed.run("python", "-I", "-c", said)
    assert ended.stderr == ""
    packages = installed.bin.parent / "lib"
    assert all(Path(p).is_relative_to(packages) for p in ended.stdout.split())


def test_the_wheel_has_the_lesson_and_the_ports_command(
    installed: Installed, tmp_path: Path
) -> None:
    ended = installed.run("occgrid", "--noise-free", "--out", str(tmp_path))
    assert (ended.returncode, ended.stderr) == (0, "")
    golden = "scenarios/golden/lesson.noise-free.pgm"
    (expected,) = (installed.bin.parent / "lib").glob(
        f"python*/site-packages/occgrid_parity/{golden}"
    )
    assert (tmp_path / "lesson.pgm").read_bytes() == expected.read_bytes()


@NEEDS_PERL
def test_a_right_perl_program(installed: Installed, tmp_path: Path) -> None:
    verdict = installed.check(perl(), tmp_path)
    assert (verdict.overall, verdict.exit_status) == ("edges", 0)
    assert verdict.summary.startswith(
        "identical on the well-conditioned scenario; on the lesson it differs only at cell edges"
    )
    assert verdict.compared == "pixels only"
    assert any(
        "this machine's own sin, cos, exp and log" in note
        for note in verdict.notes
    )


@NEEDS_AWK
def test_a_right_awk_program(installed: Installed, tmp_path: Path) -> None:
    """It prints its picture, and knows no noise."""
    verdict = installed.check(awk(), tmp_path)
    assert (verdict.overall, verdict.exit_status) == ("edges", 0)
    assert verdict.summary.startswith(
        "identical on the well-conditioned scenario; on the lesson it differs only at cell edges"
    )
    assert [said for said in verdict.not_checked if "seeded noise" in said]
    assert {x.name for x in verdict.levels if x.status == "not checked"} == {
        "noise"
    }


# the bug, its name in the catalogue, the level that finds it, and where it is first seen there
PERL_BUGS = [
    ("truncation", "truncation", "no-return", (2, 4)),
    ("ties", "ties-with-equality-in-y", "one-beam", (0, 0)),
    ("maxrange", "max-range-occupied", "no-return", (0, 1)),
    ("alsofree", "hit-also-free", "one-beam", (0, 0)),
    ("heading", "heading-ignored", "no-return", (0, 0)),
    (
        "clamp",
        "no-clamp",
        "clamping",
        (0, 2),
    ),  # three times -0.847 is below -1.7
    ("flipped", "y-flipped", "orientation", (0, 0)),
]
AWK_BUGS = [
    ("rounded", "index-rounded", "one-beam", (0, 0)),
    ("last", "last-cell-missed", "one-beam", (0, 0)),
    ("prior", "prior-not-subtracted", "prior", (0, 0)),
]
BUGS = [
    *(
        pytest.param(perl(bug), *rest, id=f"perl-{bug}", marks=NEEDS_PERL)
        for bug, *rest in PERL_BUGS
    ),
    *(
        pytest.param(awk(bug), *rest, id=f"awk-{bug}", marks=NEEDS_AWK)
        for bug, *rest in AWK_BUGS
    ),
]


@pytest.mark.parametrize(("words", "name", "level", "where"), BUGS)
def test_a_planted_mistake(
    installed: Installed,
    words: str,
    name: str,
    level: str,
    where: tuple[int, int],
    tmp_path: Path,
) -> None:
    verdict = installed.check(words, tmp_path / "first")
    assert (verdict.overall, verdict.exit_status) == ("differs", 1)
    failed = verdict.failed_level
    assert failed is not None and failed.name == level
    assert name in names(verdict)
    assert set(names(verdict)) <= {name, "y-axis-down"}
    difference = verdict.first_difference
    assert difference is not None and difference.how == "runs"
    assert (difference.scan, difference.beam) == where
    # the command that is printed shows the mistake again
    command = shlex.split(difference.command)
    options = ["--no-explain", "--out", str(tmp_path / "again")]
    ended = installed.run(*command, *options)
    assert ended.returncode == 1
    again = json.loads((tmp_path / "again" / "verdict.json").read_text())
    assert again["overall"] == "differs"


@NEEDS_PERL
def test_noise_of_another_beam(installed: Installed, tmp_path: Path) -> None:
    """Only on the quick scenario, with the seeds that the check uses."""
    options = ["--scenario", "asymmetric", "--mode", "seed-0"]
    verdict = installed.check(
        perl("noise"), tmp_path, *options, "--mode", "seed-1"
    )
    assert names(verdict) == ["noise-of-next-beam"]
    difference = verdict.first_difference
    assert difference is not None
    assert (difference.scan, difference.beam) == (0, None)


@pytest.mark.parametrize("mistake", ["robot-cell-not-freed", "no-lower-clamp"])
def test_a_mistake_of_the_catalogue_as_a_program(mistake: str) -> None:
    """With log-odds, in a process of its own."""
    script = shlex.join(
        [sys.executable, str(PROGRAMS / "mistaken.py"), mistake]
    )
    verdict = check_words(script + " {mode} {out} {scenario}")
    assert names(verdict) == [mistake]
    assert verdict.compared == "pixels, and every bit of the log-odds"
