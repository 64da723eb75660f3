"""A map is found wherever a program puts it, and a bad file is called by its name."""

from __future__ import annotations

from pathlib import Path

import pytest

from occgrid_parity.ports.port_file import PortError
from occgrid_parity.programs.observed_map import Observed, Unreadable, find_map
from occgrid_parity.programs.program import (
    program_from_command,
    program_from_port,
)
from occgrid_parity.suite.modes import NOISE_FREE, Mode

GOOD = b"P2\n3 2\n255\n0 128 255\n7 8 9\n"


def look(
    folder: Path, files: dict[str, bytes], stdout: bytes = b""
) -> Observed | Unreadable:
    out = folder / "out"
    out.mkdir()
    for name, data in files.items():
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).write_bytes(data)
    printed = folder / "stdout"
    printed.write_bytes(stdout)
    return find_map(out, out / "lesson.pgm", printed)


@pytest.mark.parametrize(
    ("files", "stdout"),
    [
        ({"lesson.pgm": GOOD}, b""),
        ({"map.pgm": GOOD}, b"done\n"),
        ({"deep/map.pgm": GOOD}, b""),
        ({"lesson.pgm": GOOD, "other.pgm": b"?"}, b""),
        ({}, GOOD),
        ({}, b"P5 3 2 255\n\x00\x80\xff\x07\x08\x09"),
        ({"map.pgm": b"P2 # mine\n3 2\n# more\n255\n0 128\n255 7 8 9"}, b""),
    ],
)
def test_finds_the_map(
    tmp_path: Path, files: dict[str, bytes], stdout: bytes
) -> None:
    found = look(tmp_path, files, stdout)
    assert isinstance(found, Observed)
    assert found.pixels.tolist() == [[0, 128, 255], [7, 8, 9]]
    assert found.log_odds is None


def test_finds_log_odds_beside_it(tmp_path: Path) -> None:
    files = {
        "lesson.pgm": b"P2\n2 1\n255\n0 1\n",
        "lesson.logodds": b"# logodds 2 1\n0.5 -1e-3\n",
    }
    found = look(tmp_path, files)
    assert isinstance(found, Observed) and found.log_odds is not None
    assert found.log_odds.tolist() == [[0.5, -0.001]]


BAD = [
    ({}, b"", "no map", "no picture (*.pgm) in the output folder: it wrote no file and printed nothing"),
    ({}, b"hello\n", "no map", "it wrote no file and printed 'hello'"),
    ({"map.png": b"x"}, b"", "no map", "it wrote map.png"),
    ({"a.pgm": GOOD, "b.pgm": GOOD}, b"", "no map", "there are 2 pictures and none is lesson.pgm: a.pgm, b.pgm"),
    ({"lesson.pgm": b""}, b"", "half a file", "lesson.pgm is empty"),
    ({"lesson.pgm": b"P2\n3"}, b"", "half a file", "lesson.pgm: it ends within its first lines"),
    ({"lesson.pgm": GOOD[:-8]}, b"", "half a file", "lesson.pgm: 3 pixels, expected 6"),
    ({"lesson.pgm": b"P5 3 2 255\n\x00\x80"}, b"", "half a file", "lesson.pgm: 2 pixels, expected 6"),
    ({"lesson.pgm": b"\x89PNG\r\n\x1a\n"}, b"", "wrong magic", "lesson.pgm is a PNG picture, not P2 or P5"),
    ({"lesson.pgm": b"P3\n1 1\n255\n0 0 0\n"}, b"", "wrong magic", "lesson.pgm is a PPM picture (P3: colours)"),
    ({"lesson.pgm": b"3 2\n0 1"}, b"", "wrong magic", "lesson.pgm begins with '3 2', a PGM picture with P2 or P5"),
    ({"lesson.pgm": b"P2\n2 1\n255\n0.5 0.25\n"}, b"", "floats instead of integers", "has pixels such as 0.5"),
    ({"lesson.pgm": b"P2\n2 1\n255\n128.0 3\n"}, b"", "floats instead of integers", "such as 128.0"),
    ({"lesson.pgm": b"P2\n2 1\n255\nnan 3\n"}, b"", "floats instead of integers", "such as nan"),
    ({"lesson.pgm": b"P2\n2 1\n255\n300 3\n"}, b"", "not a picture", "a pixel is 300, above 255"),
    ({"lesson.pgm": b"P2\n2 1\n255\n-1 3\n"}, b"", "not a picture", "pixel 1 is '-1', no number"),
    ({"lesson.pgm": b"P2\n0 0\n255\n"}, b"", "not a picture", "0 x 0 is not from 1 to 25000000 cells"),
    (
        {"lesson.pgm": GOOD, "lesson.logodds": b"# logodds 3 2\n0 0 0\n"},
        b"", "not a log-odds file", "lesson.logodds: line 3: the file ends, expected row 2 of 2",
    ),
    ({"lesson.pgm": GOOD, "lesson.logodds": b"# logodds 1 1\n0\n"}, b"", "wrong size", "has 1 x 1 cells"),
]  # fmt: skip


@pytest.mark.parametrize(("files", "stdout", "word", "message"), BAD)
def test_says_what_is_wrong(
    tmp_path: Path,
    files: dict[str, bytes],
    stdout: bytes,
    word: str,
    message: str,
) -> None:
    found = look(tmp_path, files, stdout)
    assert isinstance(found, Unreadable)
    assert found.word == word
    assert message in found.message


def test_placeholders_of_a_command(tmp_path: Path) -> None:
    (tmp_path / "my.py").write_text("")
    program = program_from_command(
        "python3 my.py {mode} -o {pgm} '{scenario}' --in={scenario} {seed}",
        tmp_path,
        5,
    )
    assert program.name == "my.py"
    assert program.reads_scenarios and program.takes_seeds
    args = program.arguments(
        Path("/s/a b.log"), Path("/o"), Path("/o/a.pgm"), Mode(7)
    )
    mine = str(tmp_path / "my.py")
    assert args == [
        "python3",
        mine,
        "--seed",
        "7",
        "-o",
        "/o/a.pgm",
        "/s/a b.log",
        "--in=/s/a b.log",
        "7",
    ]
    args = program.arguments(
        Path("/s/a.log"), Path("/o"), Path("/o/a.pgm"), NOISE_FREE
    )
    assert args[2:3] == ["--noise-free"]


@pytest.mark.parametrize(
    ("words", "reads", "seeds", "plain"),
    [("./p", False, False, None), ("./p {scenario}", True, False, None),
     ("./p {scenario} {seed}", True, True, 0), ("./p {mode}", False, True, None)],
)  # fmt: skip
def test_what_a_command_can_be_asked(
    words: str, reads: bool, seeds: bool, plain: int | None
) -> None:
    program = program_from_command(words, Path("/x"), 5)
    assert (program.reads_scenarios, program.takes_seeds) == (reads, seeds)
    assert program.plain_mode == Mode(plain)
    assert program.command[0] == "/x/p"


def test_a_command_that_is_none() -> None:
    for text in ("", "'"):
        with pytest.raises(ValueError, match="--run"):
            program_from_command(text, Path("/x"), 5)


def test_a_students_port_toml_needs_only_the_command(tmp_path: Path) -> None:
    (tmp_path / "map.sh").write_text("")
    (tmp_path / "port.toml").write_text(
        'run = ["sh", "map.sh", "{scenario}"]\n'
    )
    program = program_from_port(tmp_path)
    assert program.name == tmp_path.name
    assert program.command == ("sh", str(tmp_path / "map.sh"), "{scenario}")
    assert program.cwd is None, (
        "it does not say where its files go: they go to the empty folder"
    )
    (tmp_path / "port.toml").write_text(
        'run = ["sh", "map.sh", "{scenario}", "{out}"]\ntimeout = 3\n'
    )
    program = program_from_port(tmp_path)
    assert (program.cwd, program.timeout) == (tmp_path, 3.0)
    (tmp_path / "port.toml").write_text("run = 3\n")
    with pytest.raises(PortError, match="run: expected a list"):
        program_from_port(tmp_path)
