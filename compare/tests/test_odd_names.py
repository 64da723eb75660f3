"""A path may hold every byte but NUL; what a port cannot say, it refuses in one line (SPEC sections 6 to 8)."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from occgrid_parity.formats.map_files import SUFFIXES
from occgrid_parity.ports.declaration import Port

from .conftest import ROOT
from .map_loading import load_map
from .port_runs import each_port, files, run_port

SCENARIO = ROOT / "scenarios" / "one-beam.log"
GOLDEN = ROOT / "scenarios" / "golden" / "one-beam.seed-0.pgm"

NAMES = [
    "\\", "a\\nb", "~", "x~root", "*", "?", "[a]", "{a,b}", "$HOME", "$(touch PWNED)", "`touch PWNED`", "%d%s",
    "a;b", "'", '"', "it's", 'a", Run["touch PWNED"], "x', "'); system('touch PWNED'); ('", "a\nb", "a\rb", "\t",
    "\x01", "\x7f", " a ", "!touch PWNED", "|touch PWNED", "=a", "a=b", "@a", "é", "地図", "\N{GRINNING FACE}",
]  # fmt: skip


@each_port
def test_maps_scenarios_of_any_name(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """In folders of any name; nothing in a name is run, expanded or lost."""
    scenarios = []
    for i, odd in enumerate(NAMES):
        folder = tmp_path / f"d{i}" / odd
        folder.mkdir(parents=True)
        (folder / f"{odd}.log").write_bytes(SCENARIO.read_bytes())
        scenarios.append(f"d{i}/{odd}/{odd}.log")
    before = files(tmp_path)
    finished = run_port(
        need(name), tmp_path, "--out", "out * \\ 'o\"", *scenarios
    )
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    out = tmp_path / "out * \\ 'o\""
    assert files(out) == sorted(odd + s for odd in NAMES for s in SUFFIXES)
    for odd in NAMES:
        assert (out / f"{odd}.pgm").read_bytes() == GOLDEN.read_bytes()
    own = [out.name, f"{name}.stdout", f"{name}.stderr"]
    assert files(tmp_path) == sorted([*before, *own])


@each_port
def test_a_message_about_a_name_is_one_line(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    finished = run_port(need(name), tmp_path, "no\nsuch\x7f\x1b[1m.log")
    assert (finished.exit_status, finished.stderr.read_text()) == (
        1,
        "no?such??[1m.log:0: cannot be read\n",
    )


@each_port
def test_a_name_that_is_not_utf_8_is_mapped_or_refused(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    odd = os.fsdecode(b"a\xff\xfe")
    (tmp_path / f"{odd}.log").write_bytes(SCENARIO.read_bytes())
    finished = run_port(need(name), tmp_path, "--out", "o", f"{odd}.log")
    said = finished.stderr.read_bytes()
    if finished.exit_status == 0:
        assert said == b""
        assert files(tmp_path / "o") == sorted(odd + s for s in SUFFIXES)
        return
    assert finished.exit_status == 1
    assert said.startswith(b"a")
    assert said.endswith(b".log:0: cannot be read\n")
    assert said.count(b"\n") == 1
    assert not (tmp_path / "o").exists()


@each_port
def test_a_folder_that_the_locale_cannot_say_is_written_or_refused(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """With LC_ALL=C, where Java has no name for it."""
    finished = run_port(
        need(name),
        tmp_path,
        "--out",
        "ä",
        SCENARIO,
        environment={"LC_ALL": "C"},
    )
    said = finished.stderr.read_bytes()
    if finished.exit_status == 0:
        assert said == b""
        assert len(files(tmp_path / "ä")) == len(SUFFIXES)
        return
    assert finished.exit_status == 1
    assert said.endswith(b": cannot be written\n")
    assert said.count(b"\n") == 1


@each_port
def test_a_file_that_fails_while_it_is_read(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """Linux opens the file, and answers the first read with an error."""
    file = Path("/proc/self/mem")
    if not file.exists():
        pytest.skip("no /proc/self/mem: not Linux")
    finished = run_port(need(name), tmp_path, file)
    assert (finished.exit_status, finished.stderr.read_text()) == (
        1,
        f"{file}:0: cannot be read\n",
    )


QUOTED = [
    "run #2", "lab: monday", "[x]", "@x", "'q'", "%x", "*x", "- x", "-x", "x:", "x: y", "x #y", "{x}", "&x", "!x", "|",
    ">", '"q"', "a\\b", "a\nb", "\t", " x ", ", x", "? x", "`x`", "é", ".x", "..x",
]  # fmt: skip
WORDS = ["yes", "no", "null", "true", "1", "1e3", "0x1", "2001-01-01", "_"]


@each_port
def test_the_yaml_file_names_the_picture(
    need: Callable[[str], Port],
    tmp_path: Path,
    map_loader: Path,
    name: str,
) -> None:
    """For PyYAML and for yaml-cpp, with which map_server reads it; a name that reads as another kind of value too."""
    names = [*QUOTED, *WORDS]
    for odd in names:
        (tmp_path / f"{odd}.log").write_bytes(SCENARIO.read_bytes())
    finished = run_port(
        need(name),
        tmp_path,
        "--out",
        "o",
        *(tmp_path / f"{odd}.log" for odd in names),
    )
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    for odd in names:
        file = tmp_path / "o" / f"{odd}.yaml"
        text = file.read_text("utf-8")
        assert yaml.safe_load(text)["image"] == f"{odd}.pgm"
        assert text.startswith('image: "') == (odd in QUOTED)
        assert load_map(map_loader, file)[1].shape == (5, 8)
