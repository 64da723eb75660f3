"""The command line is the same for every port (SPEC section 6)."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.formats.map_files import SUFFIXES
from occgrid_parity.ports.declaration import Port
from occgrid_parity.processes.process_group import search_path

from .conftest import ROOT, unavailable
from .port_runs import command_line, each_port, files, run_port, shell

GOOD = ROOT / "scenarios" / "asymmetric.log"
OTHER = ROOT / "scenarios" / "one-beam.log"


@each_port
def test_without_options_it_prints_the_map_with_seed_0(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    finished = run_port(need(name), tmp_path, GOOD)
    golden = ROOT / "scenarios" / "golden"
    seed_0 = (golden / f"{GOOD.stem}.seed-0.pgm").read_bytes()
    noise_free = (golden / f"{GOOD.stem}.noise-free.pgm").read_bytes()
    assert seed_0 != noise_free, "this scenario does not tell the modes apart"
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    assert finished.stdout.read_bytes() == seed_0
    assert files(tmp_path) == [f"{name}.stderr", f"{name}.stdout"]


@each_port
def test_options_and_scenarios_stand_in_any_order_and_the_last_counts(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    port = need(name)
    first, last = tmp_path / "first", tmp_path / "new" / "last"
    words: list[str | Path] = [
        GOOD,
        "--seed",
        "1",
        "--out",
        first,
        OTHER,
        "--seed",
        "7",
        "--out",
        last,
    ]
    finished = run_port(port, tmp_path, *words)
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    assert finished.stdout.read_bytes() == b""
    assert not first.exists()
    names = [GOOD.stem, OTHER.stem]
    assert files(last) == sorted(
        n + suffix for n in names for suffix in SUFFIXES
    )
    plain = tmp_path / "plain"
    assert run_port(
        port, tmp_path, "--out", plain, "--seed", "7", GOOD
    ).succeeded
    for suffix in SUFFIXES:
        file = f"{GOOD.stem}{suffix}"
        assert (last / file).read_bytes() == (plain / file).read_bytes()


@each_port
def test_replaces_files_and_names_maps_as_the_contract_says(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """A relative path, a blank and dots in the name; a map of that name is there already."""
    scenario = tmp_path / "the last.one.log"
    scenario.write_bytes(OTHER.read_bytes())
    out = tmp_path / "out put"
    out.mkdir()
    (out / "the last.one.pgm").write_text("of yesterday")
    finished = run_port(
        need(name), tmp_path, "--out", "out put", scenario.name
    )
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    assert files(out) == sorted("the last.one" + suffix for suffix in SUFFIXES)
    assert (out / "the last.one.pgm").read_text().startswith("P2\n")
    assert (
        (out / "the last.one.yaml")
        .read_text()
        .startswith('image: "the last.one.pgm"\n')
    )


@each_port
def test_a_name_may_be_in_any_letters(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    port = need(name)
    scenario = tmp_path / "Örebro åäö 地図.log"
    scenario.write_bytes(OTHER.read_bytes())
    finished = run_port(
        port,
        tmp_path,
        "--out",
        "out",
        scenario,
        environment={"LC_ALL": "C.UTF-8"},
    )
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    out = tmp_path / "out"
    assert files(out) == sorted(scenario.stem + suffix for suffix in SUFFIXES)
    yaml = (out / f"{scenario.stem}.yaml").read_text(encoding="utf-8")
    assert yaml.startswith('image: "Örebro åäö 地図.pgm"\n')


@each_port
def test_a_locale_that_cannot_say_a_name_takes_it_or_says_so(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """Under LC_ALL=C the map has its right name, or the scenario cannot be read (Java)."""
    port = need(name)
    scenario = tmp_path / "Örebro åäö 地図.log"
    scenario.write_bytes(OTHER.read_bytes())
    out = tmp_path / "out"
    finished = run_port(
        port,
        tmp_path,
        "--out",
        "out",
        scenario,
        environment={"LC_ALL": "C"},
    )
    said = finished.stderr.read_text(errors="replace")
    if name == "java":
        assert finished.exit_status == 1
        assert said.startswith(f"{tmp_path}/")
        assert said.endswith(".log:0: cannot be read\n")
        assert said.count("\n") == 1
        assert not out.exists()
    else:
        assert (finished.exit_status, said) == (0, "")
        assert files(out) == sorted(scenario.stem + s for s in SUFFIXES)
        yaml = (out / f"{scenario.stem}.yaml").read_text(encoding="utf-8")
        assert yaml.startswith('image: "Örebro åäö 地図.pgm"\n')


@pytest.mark.parametrize("redirection", [">", ">>"])
@each_port
def test_shares_standard_output_with_others(
    need: Callable[[str], Port], tmp_path: Path, name: str, redirection: str
) -> None:
    """What was written before stays, and what is written after comes after it."""
    port = need(name)
    shared = tmp_path / "shared"
    shared.write_text("of yesterday\n" if redirection == ">>" else "")
    script = (
        'f="$1"; shift; { echo before; "$@"; echo after; } '
        f'{redirection} "$f"'
    )
    finished = run_port(
        port, tmp_path, OTHER, within=shell(script, str(shared))
    )
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    golden = ROOT / "scenarios" / "golden" / f"{OTHER.stem}.seed-0.pgm"
    yesterday = b"of yesterday\n" if redirection == ">>" else b""
    assert shared.read_bytes() == (
        yesterday + b"before\n" + golden.read_bytes() + b"after\n"
    )


@each_port
def test_says_that_the_disk_is_full(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """No file can be longer than 512 bytes, as the picture and the log-odds are."""
    port = need(name)
    scenario = ROOT / "scenarios" / "saturate.log"
    script = "trap '' XFSZ; ulimit -f 1; exec \"$@\""
    finished = run_port(
        port, tmp_path, "--out", "out", scenario, within=shell(script)
    )
    said = finished.stderr.read_text()
    assert finished.exit_status == 1
    assert said in [
        f"out/{scenario.stem}{suffix}: cannot be written\n"
        for suffix in SUFFIXES
    ]
    assert files(tmp_path / "out") == []


@each_port
@pytest.mark.parametrize(
    ("output", "argument"),
    [
        ("> /dev/full", OTHER),
        (">&-", OTHER),
        ("> /dev/full", "--help"),
        ("> /dev/full", "--version"),
    ],
)
def test_says_that_standard_output_cannot_be_written(
    need: Callable[[str], Port],
    tmp_path: Path,
    output: str,
    argument: str | Path,
    name: str,
) -> None:
    """On a full disk, and where it is closed from the start."""
    if not Path("/dev/full").exists():
        unavailable("no /dev/full, the device that is always full")
    port = need(name)
    finished = run_port(
        port,
        tmp_path,
        argument,
        within=shell(f'exec "$@" {output}'),
        environment={"PYTHONUNBUFFERED": ""},  # which hides what is left over
    )
    said = finished.stderr.read_text().splitlines()
    if output == ">&-":
        del said[:-1]  # Octave's own complaint comes first
    assert (finished.exit_status, said) == (
        1,
        ["standard output: cannot be written"],
    )


@each_port
def test_a_closed_pipe_is_a_write_that_fails(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """Nobody reads the pipe from the start."""
    port = need(name)
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer):
        finished = subprocess.run(
            command_line(port, OTHER),
            cwd=tmp_path,
            env={**os.environ, "PATH": search_path()},
            stdout=writer,
            stderr=subprocess.PIPE,
            timeout=port.timeout,
            check=False,
        )
    assert (finished.returncode, finished.stderr) == (
        1,
        b"standard output: cannot be written\n",
    )


USAGE = {
    "unknown-option": ["--noisy"],
    "no-seed": ["--seed"],
    "negative-seed": ["--seed", "-1"],
    "large-seed": ["--seed", "4294967296"],
    "text-seed": ["--seed", "1.0"],
    "empty-out": ["--out"],
    "option-for-a-value": ["--out", "--noise-free", str(GOOD)],
    "empty-value": ["--out", "", str(GOOD)],
    "dash": ["-"],
    "two-dashes": ["--", str(GOOD)],
    "number": ["-5"],
    "equals-sign": ["--seed=7", str(GOOD)],
    "long-seed": ["--seed", "99999999999999999999", str(GOOD)],
    "before-help": ["--bogus", "--help"],
    "same-name-behind-a-slash": ["--out", "out", str(GOOD), f"{GOOD}/"],
    "two-modes": ["--noise-free", "--seed", "1"],
    "two-modes-turned": ["--seed", "0", "--noise-free"],
    "several-without-out": [str(GOOD), str(OTHER)],
    "same-name": ["--out", "out", str(GOOD), str(GOOD)],
    "before-reading": [
        "/nowhere/a.log",
        "--out",
        "out",
        "/nowhere/b.log",
        "--oops",
    ],
}


@pytest.mark.parametrize("arguments", USAGE.values(), ids=USAGE)
@each_port
def test_bad_usage(
    need: Callable[[str], Port],
    tmp_path: Path,
    name: str,
    arguments: list[str],
) -> None:
    finished = run_port(need(name), tmp_path, *arguments)
    said = finished.stderr.read_text()
    assert (finished.exit_status, finished.stdout.read_bytes()) == (2, b""), (
        said
    )
    assert "usage" in said.lower()
    assert len(said.splitlines()) >= 2
    assert files(tmp_path) == [f"{name}.stderr", f"{name}.stdout"]


@each_port
def test_values_of_odd_forms(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    """A seed of 22 digits, and a folder whose name begins with a dash."""
    seed = "0" * 21 + "7"
    finished = run_port(
        need(name), tmp_path, "--seed", seed, "--out", "-x", GOOD
    )
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    plain = run_port(need(name), tmp_path, "--seed", "7", GOOD)
    picture = tmp_path / "-x" / f"{GOOD.stem}.pgm"
    assert picture.read_bytes() == plain.stdout.read_bytes()


@each_port
@pytest.mark.parametrize("scenarios", [[f"{GOOD}/"], ["d/", "a/"]])
def test_a_path_that_ends_with_a_slash_cannot_be_read(
    need: Callable[[str], Port],
    tmp_path: Path,
    scenarios: list[str],
    name: str,
) -> None:
    (tmp_path / "d").mkdir()
    finished = run_port(need(name), tmp_path, "--out", "o", *scenarios)
    assert (finished.exit_status, finished.stderr.read_text()) == (
        1,
        f"{scenarios[0]}:0: cannot be read\n",
    )
    assert not (tmp_path / "o").exists()


@each_port
def test_help_acts_where_it_is_read(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    finished = run_port(need(name), tmp_path, "--help", "--bogus")
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    assert "usage" in finished.stdout.read_text().lower()


@each_port
def test_help_and_version(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    port = need(name)
    finished = run_port(port, tmp_path, "--version")
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    (line,) = finished.stdout.read_text().splitlines()
    assert line.startswith("occgrid ")
    finished = run_port(port, tmp_path, "--help")
    assert (finished.exit_status, finished.stderr.read_bytes()) == (0, b"")
    text = finished.stdout.read_text()
    for word in (
        "occgrid",
        "--noise-free",
        "--seed",
        "--out",
        "SCENARIO",
        "--version",
    ):
        assert word in text
