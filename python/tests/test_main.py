"""main: the command line as its users meet it."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

import occgrid
from occgrid.main import main

SCENARIOS = Path(__file__).parents[2] / "scenarios"
ONE_BEAM = str(SCENARIOS / "one-beam.log")
OCTANTS = str(SCENARIOS / "octants.log")


def test_the_map_on_standard_output(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["--noise-free", ONE_BEAM]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert out == (
        "P2\n8 5\n255\n"
        "128 128 128 128 128 128 128 128\n"
        "128 128 128 128 128 64 128 128\n"
        "128 128 128 179 179 128 128 128\n"
        "128 179 179 128 128 128 128 128\n"
        "128 128 128 128 128 128 128 128\n"
    )


def test_the_lesson_and_its_seed(capsys: pytest.CaptureFixture[str]) -> None:
    maps = []
    for arguments in ([], ["--seed", "0"], ["--seed", "1"], ["--noise-free"]):
        assert main(arguments) == 0
        maps.append(capsys.readouterr().out)
    assert maps[0] == maps[1]
    assert len(set(maps)) == 3
    assert maps[0].startswith("P2\n220 180\n255\n")


def test_the_last_value_counts(capsys: pytest.CaptureFixture[str]) -> None:
    file = str(SCENARIOS / "asymmetric.log")
    maps = []
    for arguments in (["--seed", "1"], ["--seed", "5", file, "--seed", "1"]):
        assert main([*arguments, *([] if file in arguments else [file])]) == 0
        maps.append(capsys.readouterr().out)
    assert maps[0] == maps[1]


def test_files(tmp_path: Path) -> None:
    out = tmp_path / "maps"
    assert main([ONE_BEAM, "--out", str(out), OCTANTS]) == 0
    names = sorted(file.name for file in out.iterdir())
    assert names == [
        f"{name}.{kind}"
        for name in ("octants", "one-beam")
        for kind in ("logodds", "pgm", "yaml")
    ]


def test_a_bad_scenario(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bad = tmp_path / "bad.log"
    bad.write_text("# a comment\nPARAM occgrid_width 0\n")
    out = tmp_path / "maps"
    assert main([ONE_BEAM, str(bad), OCTANTS, "--out", str(out)]) == 1
    assert capsys.readouterr() == (
        "",
        f"{bad}:2: occgrid_width '0' is not from 1 to 25000000\n",
    )
    # what was mapped before stays, nothing is written after
    assert {file.stem for file in out.iterdir()} == {"one-beam"}


def test_an_error_after_many_scans_writes_nothing(tmp_path: Path) -> None:
    bad = tmp_path / "bad.log"
    bad.write_text((SCENARIOS / "lesson.log").read_text() + "POSE 1 2\n")
    assert main([str(bad), "--out", str(tmp_path / "maps")]) == 1
    assert not (tmp_path / "maps").exists()


def test_a_folder_that_cannot_be_made(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").touch()
    for folder in (tmp_path / "file", tmp_path / "file" / "maps"):
        assert main([ONE_BEAM, "--out", str(folder)]) == 1
        assert capsys.readouterr().err == f"{folder}: cannot be written\n"


@pytest.mark.parametrize(
    "arguments",
    [
        ["--sed", "1"],
        ["--seed"],
        ["--seed", "-1"],
        ["--seed", "4294967296"],
        ["--seed", "1.5"],
        ["--seed", "9" * 5000],
        ["--seed", "00000000004294967296"],
        ["--seed", "\u0661"],
        ["--seed", ""],
        ["--seed", "-5"],
        ["--seed", "--out", "maps"],
        ["--seed=7"],
        ["--out", "--noise-free", ONE_BEAM],
        ["--out", "", ONE_BEAM],
        ["--plot", "", ONE_BEAM],
        ["-", ONE_BEAM],
        ["--", ONE_BEAM],
        ["-5"],
        ["-h"],
        ["--plain=1"],
        ["--Plain"],
        ["--threads", "2"],
        ["--bogus", "--help"],
        ["--seed", "x", "--version"],
        ["a\nb.log", "c.log"],
        ["d/a.log/", "a.log//", "--out", "maps"],
        [ONE_BEAM, OCTANTS, "--out", "maps", "--plot", "a.png"],
        [ONE_BEAM, "--plot", "a.bmp"],
        [ONE_BEAM, "--plot", "png"],
        ["--noise-free", "--seed", "0"],
        ["--out"],
        [ONE_BEAM, OCTANTS],
        [ONE_BEAM, "missing/one-beam.log", "--out", "maps"],
        [ONE_BEAM, OCTANTS, "a\nb/octants.x", "--out", "maps"],
    ],
)
def test_bad_usage(
    arguments: list[str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    reason, usage, *more = err.splitlines()
    assert reason.startswith("occgrid: ") and not more
    assert usage.startswith("usage: occgrid")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("arguments", [[], ["missing.log", "--bogus"]])
def test_help_and_version_act_where_they_are_read(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["--noise-free", "--help", *arguments]) == 0
    out, err = capsys.readouterr()
    assert out.startswith("usage: occgrid") and "--plain" in out
    assert main(["--version", *arguments]) == 0
    out, err = capsys.readouterr()
    assert re.fullmatch(r"occgrid \S+ \(Python \S+, NumPy \S+\)\n", out)
    assert err == ""


def test_a_seed_with_zeros_before_it(
    capsys: pytest.CaptureFixture[str],
) -> None:
    file = str(SCENARIOS / "asymmetric.log")
    maps = []
    for seed in ("7", "00000000000000000007", "0" * 5000 + "7", "8"):
        assert main(["--seed", seed, file]) == 0
        maps.append(capsys.readouterr().out)
    assert maps[0] == maps[1] == maps[2] != maps[3]


@pytest.mark.parametrize("mode", [["--noise-free"], []])
def test_plain_maps_the_same(
    mode: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    file = str(SCENARIOS / "asymmetric.log")
    fast, plain = tmp_path / "fast", tmp_path / "plain"
    assert main([*mode, file, "--out", str(fast)]) == 0
    monkeypatch.delattr("occgrid.main.map_scenario_fast")
    with pytest.raises(NameError):
        main([*mode, file, "--out", str(plain)])
    monkeypatch.setattr("occgrid.main.map_scenario_fast", None, raising=False)
    assert main([*mode, "--plain", file, "--out", str(plain)]) == 0
    for name in ("asymmetric.pgm", "asymmetric.yaml", "asymmetric.logodds"):
        assert (fast / name).read_bytes() == (plain / name).read_bytes()


def test_a_folder_as_a_scenario(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in (f"{ONE_BEAM}/", str(tmp_path), f"{tmp_path}//", ""):
        assert main([name, "--out", str(tmp_path / "maps")]) == 1
        assert capsys.readouterr().err == f"{name}:0: cannot be read\n"
    assert not list(tmp_path.iterdir())


def test_the_picture(tmp_path: Path) -> None:
    file = tmp_path / "lesson.png"
    assert main(["--out", str(tmp_path / "maps"), "--plot", str(file)]) == 0
    with Image.open(file) as picture:
        colours = picture.convert("RGB").getcolors(maxcolors=1 << 20)
    assert colours is not None and len(colours) > 50


def test_the_picture_without_matplotlib(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One line that names the extra, before anything is mapped."""
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    monkeypatch.delitem(sys.modules, "occgrid.picture", raising=False)
    monkeypatch.delattr(occgrid, "picture", raising=False)
    out = tmp_path / "maps"
    assert main(["--plot", "a.png", "--out", str(out), ONE_BEAM]) == 1
    assert capsys.readouterr() == (
        "",
        "occgrid: --plot needs matplotlib, which the extra 'plot' brings: pip install 'occgrid-parity[plot]'\n",
    )
    assert not out.exists()


def test_a_picture_that_cannot_be_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "missing" / "a.png"
    assert main(["--plot", str(file), ONE_BEAM]) == 1
    assert capsys.readouterr().err == f"{file}: cannot be written\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
def test_a_picture_on_a_full_disk(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.png"
    file.symlink_to("/dev/full")
    assert main(["--plot", str(file), "--out", str(tmp_path), ONE_BEAM]) == 1
    assert capsys.readouterr().err == f"{file}: cannot be written\n"


# --- The program as a process ---


# Python's own buffers are part of what is tested.
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name != "PYTHONUNBUFFERED"
}


def run(
    *arguments: str | bytes, **more: Any
) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "occgrid", *arguments]
    settings = {"capture_output": True, "env": ENVIRONMENT, **more}
    return subprocess.run(command, check=False, **settings)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize(
    "arguments", [["--help"], ["--version"], ["--noise-free"], [ONE_BEAM]]
)
def test_a_full_disk(arguments: list[str]) -> None:
    with Path("/dev/full").open("wb") as full:
        ended = run(
            *arguments,
            capture_output=False,
            stdout=full,
            stderr=subprocess.PIPE,
        )
    assert ended.returncode == 1
    assert ended.stderr == b"standard output: cannot be written\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
def test_standard_error_on_a_full_disk() -> None:
    """The message is lost, but the status is right."""
    with Path("/dev/full").open("wb") as full:
        for arguments, status in ((["missing.log"], 1), (["--bogus"], 2)):
            ended = run(*arguments, capture_output=False, stderr=full)
            assert ended.returncode == status


@pytest.mark.skipif(os.name == "nt", reason="sh is not on Windows")
@pytest.mark.parametrize("closing", ["| true", ">&-"])
def test_a_closed_pipe(closing: str) -> None:
    command = f'({sys.executable} -m occgrid; echo "$?" >&2) {closing}'
    ended = subprocess.run(
        ["sh", "-c", command],
        capture_output=True,
        check=False,
        env=ENVIRONMENT,
    )
    assert ended.stderr == b"standard output: cannot be written\n1\n"


@pytest.mark.skipif(
    sys.platform in ("win32", "darwin"),
    reason="names are bytes on Linux; elsewhere they are Unicode",
)
def test_names_that_are_not_utf_8(tmp_path: Path) -> None:
    file = os.fsencode(tmp_path) + b"/\xfc\n.log"
    ended = run(file, env={**ENVIRONMENT, "LC_ALL": "C"})
    shown = file.replace(b"\n", b"?")
    assert ended.stderr == shown + b":0: cannot be read\n"
    Path(os.fsdecode(file)).write_bytes(Path(ONE_BEAM).read_bytes())
    out = os.fsencode(tmp_path) + b"/maps\xfc"
    ended = run(file, b"--out", out, env={**ENVIRONMENT, "LC_ALL": "C"})
    assert (ended.returncode, ended.stderr) == (0, b"")
    written = Path(os.fsdecode(out))
    assert sorted(os.fsencode(file.name) for file in written.iterdir()) == [
        b"\xfc\n.logodds", b"\xfc\n.pgm", b"\xfc\n.yaml"
    ]  # fmt: skip
    yaml = (written / os.fsdecode(b"\xfc\n.yaml")).read_bytes()
    assert yaml.startswith(b'image: "\xfc\\x0A.pgm"\n')


def start_writing(
    folder: Path, out: Path, number: signal.Signals, action: signal.Handlers
) -> subprocess.Popen[bytes]:
    """A run that is in the midst of writing a map of 2 million cells, and that was started with a signal's action."""
    scenario = folder / "wide.log"
    text = Path(ONE_BEAM).read_text()
    text = text.replace("occgrid_width 8", "occgrid_width 2000")
    text = text.replace("occgrid_height 5", "occgrid_height 1000")
    scenario.write_text(text)
    arguments = ["-m", "occgrid", "--out", str(out), str(scenario)]
    before = signal.signal(number, action)
    try:
        process = subprocess.Popen(
            [sys.executable, *arguments], stderr=subprocess.PIPE
        )
    finally:
        signal.signal(number, before)
    deadline = time.monotonic() + 60
    while not list(out.glob(".occgrid-*.part")):
        assert process.poll() is None and time.monotonic() < deadline
        time.sleep(0.005)
    return process


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_leaves_no_temporary_file(
    tmp_path: Path, number: signal.Signals
) -> None:
    """The run ends by the signal, also where these tests run in the background and ignore SIGINT themselves."""
    out = tmp_path / "maps"
    with start_writing(tmp_path, out, number, signal.SIG_DFL) as process:
        process.send_signal(number)
        _, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (-number, b"")
    assert not list(out.iterdir())


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_ignored_signal_stays_ignored(
    tmp_path: Path, number: signal.Signals
) -> None:
    """As a shell has it for what runs in the background: the map is written."""
    out = tmp_path / "maps"
    with start_writing(tmp_path, out, number, signal.SIG_IGN) as process:
        process.send_signal(number)
        _, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, b"")
    assert len(list(out.iterdir())) == 3


def test_main_leaves_the_handlers_as_they_were(tmp_path: Path) -> None:
    before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    assert main(["--out", str(tmp_path), ONE_BEAM]) == 0
    after = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    assert after == before
