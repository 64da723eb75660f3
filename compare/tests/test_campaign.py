"""Campaigns: a wrong port is found, a world's number is enough to see it again, and the shortened scenario shows it."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from occgrid_parity.campaign.campaign_record import (
    CampaignRecord,
    WorldDifference,
    from_json,
)
from occgrid_parity.campaign.numbered_worlds import (
    BLOCK,
    blocks,
    mode_of,
    world,
)
from occgrid_parity.model.worlds import world_of
from occgrid_parity.report.campaign_page import write_campaign_page

from .check_helpers import PROGRAMS
from .conftest import ROOT

RUN = ["env", "PYTHONPATH={port}", "{python}", "-m", "occgrid"]
WORLDS = 10


def toy(folder: Path, module: str, right: str, wrong: str) -> Path:
    """A copy of the Python port in which one line is another."""
    port = folder / "toy"
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "python/occgrid", port / "occgrid", ignore=ignored)
    file = port / "occgrid" / f"{module}.py"
    text = file.read_text()
    assert text.count(right) == 1
    file.write_text(text.replace(right, wrong))
    run = [*RUN, "{mode}", "--out", "{out}", "{scenarios}"]
    (port / "port.toml").write_text(
        f'name = "toy"\nlanguage = "a copy of the Python port"\nrun = {json.dumps(run)}\ntimeout = 60\n'
    )
    return port


class Ended(NamedTuple):
    """A command that has ended, and its record."""

    status: int
    printed: str
    record: CampaignRecord


def campaign(out: Path, *options: str) -> Ended:
    """``occgrid-parity campaign``."""
    ended = subprocess.run(
        [sys.executable, "-m", "occgrid_parity", "campaign", *options, "--jobs", "1", "--out", str(out)],
        cwd=ROOT,
        text=True,
        capture_output=True,
    )  # fmt: skip
    record = from_json((out / "campaign.json").read_text())
    return Ended(ended.returncode, ended.stdout, record)


def statuses(port: Path, scenario: Path, mode: str) -> tuple[int, str]:
    """What a run says of one scenario."""
    ended = subprocess.run(
        [sys.executable, "-m", "occgrid_parity", "run", "--port", str(port), "--scenario", str(scenario),
         "--mode", mode, "--out", str(port.parent / "run")],
        cwd=ROOT,
        text=True,
        capture_output=True,
    )  # fmt: skip
    return ended.returncode, ended.stdout


class Found(NamedTuple):
    """A wrong port and the campaign that found it."""

    port: Path
    out: Path
    ended: Ended

    @property
    def first(self) -> WorldDifference:
        """The first difference."""
        return self.ended.record.differences[0]


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> Found:
    """A port that takes a range of max_range - 1e-12 for a hit."""
    folder = tmp_path_factory.mktemp("campaign")
    port = toy(folder, "sensor", "ranges < z_max", "ranges <= z_max")
    out = folder / "out"
    options = ("--port", str(port), "--worlds", str(WORLDS), "--shorten", "1")
    return Found(port, out, campaign(out, *options))


def test_a_wrong_port_is_found(found: Found) -> None:
    status, printed, record = found.ended
    assert status == 1
    (wrong,) = record.programs
    assert wrong.different == len(record.differences) > 0
    assert wrong.identical == WORLDS - wrong.different > 0
    assert {one.program for one in record.differences} == {"toy"}
    for one in record.differences:
        assert f"toy, world {one.world} ({one.kind})" in printed


def test_its_number_shows_it_again(found: Found) -> None:
    """Alone in its campaign the world is the same, and differs in the same cells."""
    words = found.first.again.split()
    assert words[:2] == ["occgrid-parity", "campaign"]
    again = campaign(found.port.parent / "again", *words[2:], "--shorten", "0")
    assert again.status == 1
    (one,) = again.record.differences
    assert one.world == found.first.world
    assert (one.mode, one.reason) == (found.first.mode, found.first.reason)
    whole = found.out / found.first.file
    assert whole.read_bytes() == world(0, one.world).data


def test_the_shortened_scenario_still_shows_it(found: Found) -> None:
    """One beam of one scan is left, of the range that matters; a right copy of the port maps it well."""
    one = found.first
    short = found.out / one.shortened
    assert short.read_text() == one.text
    status, printed = statuses(found.port, short, one.mode)
    assert status == 1
    assert f"toy, {short.stem}, {one.mode}: differs" in printed
    lines = [line.split() for line in one.text.splitlines()]
    (scan,) = [line for line in lines if line[0] in ("FLASER", "ROBOTLASER1")]
    assert not [line for line in lines if line[0] in ("WALL", "POSE")]
    values = {line[1]: line[2] for line in lines if line[0] == "PARAM"}
    edge = float(values["occgrid_max_range"]) - 1e-12
    count, distance = scan[1:3] if scan[0] == "FLASER" else scan[8:10]
    assert (count, float(distance)) == ("1", edge)
    whole = world_of(world(0, one.world))
    assert len(whole.scans) > 1


def test_the_page_shows_it(found: Found, tmp_path: Path) -> None:
    page = write_campaign_page(found.ended.record, tmp_path).read_text()
    assert found.first.text.splitlines()[0] in page
    assert f"toy, world {found.first.world}" in page


def test_right_ports_do_not_differ(tmp_path: Path) -> None:
    ended = campaign(tmp_path / "out", "--port", "python", "--worlds", "6")
    assert ended.status == 0
    assert "0 differences" in ended.printed
    (one,) = ended.record.programs
    assert (one.identical, one.different) == (6, 0)


CRASHES = """
import sys
from pathlib import Path
from occgrid.main import main

for word in sys.argv:
    if word.endswith(".log") and "\\nWALL" in Path(word).read_text():
        raise SystemExit(f"{word}: a wall")
main()
"""


def test_a_port_that_fails_is_found(tmp_path: Path) -> None:
    """It fails wherever there is a wall, and the least of such a world has one wall."""
    port = toy(tmp_path, "sensor", "ranges < z_max", "ranges < z_max")
    (port / "occgrid" / "__main__.py").write_text(CRASHES)
    ended = campaign(
        tmp_path / "out",
        *("--port", str(port), "--worlds", "3", "--shorten", "1"),
    )
    first = ended.record.differences[0]
    assert first.status == "error"
    assert "a wall" in first.reason
    words = [line.split()[0] for line in first.text.splitlines()]
    assert words.count("WALL") == 1
    assert len(words) - words.count("PARAM") <= 2


@pytest.fixture(scope="module")
def mapper(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A mapper in C, with the C library's own sines and logarithms."""
    program = tmp_path_factory.mktemp("mapper") / "mapper"
    source = PROGRAMS / "mapper.c"
    command = ["cc", "-O1", "-o", str(program), str(source), "-lm"]
    subprocess.run(command, check=True)
    return program


def test_rounding_of_a_program_is_no_difference(
    mapper: Path, tmp_path: Path
) -> None:
    ended = campaign(
        tmp_path / "out",
        *("--run", f"{mapper} none {{mode}} {{out}} {{scenario}}"),
        *("--worlds", "40"),
    )
    assert ended.status == 0, ended.printed
    assert ended.record.programs[0].identical == 40


def test_a_mistake_of_a_program_is_found(mapper: Path, tmp_path: Path) -> None:
    ended = campaign(
        tmp_path / "out",
        *("--run", f"{mapper} prior {{mode}} {{out}} {{scenario}}"),
        *("--worlds", "8", "--shorten", "1"),
    )
    assert ended.status == 1
    first = ended.record.differences[0]
    assert "occgrid_p0" in first.text
    assert first.text.count("\n") < 12
    folder = tmp_path / "program"
    folder.mkdir()
    shutil.copy(mapper, folder)
    (folder / "port.toml").write_text(
        'run = ["{port}/mapper", "prior", "{mode}", "{out}", "{scenario}"]\n'
    )
    again = campaign(
        tmp_path / "again",
        *("--port", str(folder), "--world", str(first.world)),
        *("--shorten", "0"),
    )
    assert again.record.differences[0].reason == first.reason


def test_blocks_cover_the_worlds() -> None:
    for first, count in ((0, 100), (5, 3), (31, 2), (64, 32)):
        found = blocks(first, count)
        assert [n for block in found for n in block] == [
            *range(first, first + count)
        ]
        for block in found:
            assert len({mode_of(7, number) for number in block}) == 1
    modes = {mode_of(7, number) for number in range(0, 8 * BLOCK, BLOCK)}
    assert {mode.plain for mode in modes} == {False, True}
    assert len({mode.seed for mode in modes}) > 3
    assert world(7, 3).data == world(7, 3).data != world(8, 3).data
