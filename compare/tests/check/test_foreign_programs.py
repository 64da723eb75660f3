"""Programs in languages that are no ports, checked from an installed wheel: the whole check, as its users have it.

More programs, and more mistakes, are in test_programs_in_c.py and test_programs_elsewhere.py.
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
    (lesson,) = (x for x in verdict.levels if x.name == "lesson")
    assert "sine and cosine: this machine's" in lesson.cases[0].message


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
        "log-odds",
        "noise",
        "mixed-noise",
        "yaml",
    }
    assert verdict.score == verdict.maximum


@NEEDS_AWK
def test_a_planted_mistake(installed: Installed, tmp_path: Path) -> None:
    """It costs one level, and the command that is printed shows it again."""
    verdict = installed.check(awk("prior"), tmp_path / "first")
    assert (verdict.overall, verdict.exit_status) == ("differs", 1)
    failed = verdict.failed_level
    assert failed is not None and failed.name == "prior"
    assert verdict.maximum - verdict.score == 1
    assert names(verdict) == ["prior-not-subtracted"]
    difference = verdict.first_difference
    assert difference is not None and difference.how == "runs"
    assert (difference.scan, difference.beam) == (0, 0)
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
