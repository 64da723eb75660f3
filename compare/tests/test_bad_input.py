"""Bad input: every port refuses it with the same status, line and reason, and writes nothing.

The files are those of scenarios/bad. Each is a process for each port, since the first error ends a run: all of them are
run by ``pytest -m long``, one of EVERY otherwise. The unit tests of the ports read all of them.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import run_process

from .bad_files import bad_files, check_refused, give, map_into
from .conftest import PORTS, unavailable

FILES = {file.stem: (file, line, reason) for file, line, reason in bad_files()}
EVERY = 8
GOOD = """PARAM occgrid_width 4
PARAM occgrid_height 3
PARAM occgrid_resolution 1
PARAM occgrid_origin_x 0
PARAM occgrid_origin_y 0
PARAM occgrid_max_range 10
# a comment
POSE 0.5 0.5 0
"""
DROP_PRIVILEGE = [
    "setpriv",
    "--bounding-set=-dac_override,-dac_read_search",
    "--inh-caps=-all",
]


CASES = [
    pytest.param(
        port.name, name, marks=[pytest.mark.long] if number % EVERY else []
    )
    for port in PORTS
    for number, name in enumerate(FILES)
]


@pytest.mark.parametrize(("port", "name"), CASES)
def test_refuses(
    need: Callable[[str], Port], tmp_path: Path, port: str, name: str
) -> None:
    answer = give(need(port), FILES[name][0], tmp_path)
    check_refused(answer, *FILES[name])


@pytest.mark.parametrize("kind", ["missing", "folder", "in-a-file"])
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_refuses_what_cannot_be_read(
    need: Callable[[str], Port], tmp_path: Path, port: str, kind: str
) -> None:
    file = tmp_path / "scenario.log"
    if kind == "folder":
        file.mkdir()
    if kind == "in-a-file":
        file.write_text(GOOD)
        file = file / "scenario.log"
    answer = give(need(port), file, tmp_path / "work")
    check_refused(answer, file, 0, "cannot be read")


def obeying_permissions() -> list[str]:
    """What to put before a command so that permissions bind it, root or not."""
    if os.geteuid() != 0:
        return []
    if shutil.which("setpriv") is None:
        unavailable(
            "root obeys no permissions without setpriv: install util-linux"
        )
    return DROP_PRIVILEGE


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_refuses_what_it_may_not_read(
    need: Callable[[str], Port], tmp_path: Path, port: str
) -> None:
    ready = need(port)
    file = tmp_path / "scenario.log"
    file.write_text(GOOD)
    file.chmod(0)
    answer = give(ready, file, tmp_path / "work", obeying_permissions())
    check_refused(answer, file, 0, "cannot be read")


@pytest.mark.parametrize(
    "kind", ["no-permission", "no-permission-above", "a-file", "in-a-file"]
)
@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_says_that_the_folder_cannot_be_written(
    need: Callable[[str], Port], tmp_path: Path, port: str, kind: str
) -> None:
    ready = need(port)
    file = tmp_path / "good.log"
    file.write_text(GOOD)
    out = tmp_path / "out"
    prefix: list[str] = []
    if kind.startswith("no-permission"):
        prefix = obeying_permissions()
        out.mkdir()
        out.chmod(0o555)
    if kind in ("a-file", "in-a-file"):
        out.write_text("here already")
    if kind in ("no-permission-above", "in-a-file"):
        out = out / "below"
    finished = map_into(ready, file, out, tmp_path, prefix)
    said = finished.stderr.read_text()
    paths = [
        out,
        *(out / f"good{suffix}" for suffix in (".pgm", ".yaml", ".logodds")),
    ]
    # PATH is DIR or the file (SPEC section 8); a folder that is not there is DIR
    allowed = [f"{path}: cannot be written\n" for path in paths]
    if kind != "no-permission":
        allowed = allowed[:1]
    assert (finished.exit_status, finished.stdout.read_bytes()) == (1, b"")
    assert said in allowed
    if out.is_dir():
        assert list(out.iterdir()) == []
    if kind == "a-file":
        assert out.read_text() == "here already"


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_keeps_the_maps_before_the_error(
    need: Callable[[str], Port], tmp_path: Path, port: str
) -> None:
    """What earlier scenarios wrote stays; of the bad one and those after it nothing is there."""
    ready = need(port)
    files = [tmp_path / f"{name}.log" for name in ("first", "second", "third")]
    for file in files:
        file.write_text(GOOD)
    files[1].write_text(GOOD + "POSE 0 0 x\n")
    if not ready.takes_many:
        pytest.skip(f"{port} takes one scenario at a time")
    out = tmp_path / "out"
    run = ready.command(
        ready.run, mode=["--seed", "3"], out=out, scenarios=files
    )
    finished = run_process(
        run,
        cwd=ready.folder,
        stdout=tmp_path / "stdout",
        stderr=tmp_path / "stderr",
        time_limit=ready.timeout,
    )
    assert finished.exit_status == 1
    assert (
        finished.stderr.read_text()
        == f"{files[1]}:9: theta 'x' is not a number\n"
    )
    names = ["first.logodds", "first.pgm", "first.yaml"]
    assert sorted(path.name for path in out.iterdir()) == names
