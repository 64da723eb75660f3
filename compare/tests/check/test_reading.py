"""A map is found wherever a program puts it, and a bad file is called by its name."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from occgrid_parity.ports.port_file import PortError
from occgrid_parity.programs.observed_map import Observed, Unreadable, find_map
from occgrid_parity.programs.program import (
    program_from_command,
    program_from_port,
)
from occgrid_parity.suite.modes import NOISE_FREE, Mode

GOOD = b"P2\n3 2\n255\n0 128 255\n7 8 9\n"
ROWS = [[0, 128, 255], [7, 8, 9]]


def encoded(rows: Sequence[object], kind: str, dtype: str = "uint8") -> bytes:
    """A picture as a program with an image library writes it."""
    file = io.BytesIO()
    Image.fromarray(np.array(rows, dtype=dtype)).save(file, kind)
    return file.getvalue()


GREY_PNG = encoded(ROWS, "PNG")


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


@pytest.mark.parametrize(
    ("files", "stdout", "kind"),
    [
        ({"map.png": GREY_PNG}, b"done\n", "PNG"),
        ({}, GREY_PNG, "PNG"),
        ({"lesson.pgm": GREY_PNG}, b"", "PNG"),
        ({"map.PNG": encoded([[[v] * 3 for v in row] for row in ROWS], "PNG")}, b"", "PNG"),
        ({"map.png": encoded([[257 * v for v in row] for row in ROWS], "PNG", "uint16")}, b"", "PNG"),
        ({"map.bmp": encoded(ROWS, "BMP")}, b"", "BMP"),
        ({"map.tif": encoded(ROWS, "TIFF")}, b"", "TIFF"),
        ({"map.gif": encoded(ROWS, "GIF")}, b"", "GIF"),
        ({"map.ppm": b"P3 3 2 255 0 0 0 128 128 128 255 255 255 7 7 7 8 8 8 9 9 9\n"}, b"", "PPM"),
    ],
)  # fmt: skip
def test_reads_other_pictures_that_keep_grey_values(
    tmp_path: Path, files: dict[str, bytes], stdout: bytes, kind: str
) -> None:
    found = look(tmp_path, files, stdout)
    assert isinstance(found, Observed)
    assert found.pixels.tolist() == ROWS
    assert f"is a {kind} picture; the programs of the suite write PGM" in str(
        found.remarks
    )


def test_a_pgm_goes_before_other_pictures(tmp_path: Path) -> None:
    found = look(tmp_path, {"map.pgm": GOOD, "plot.png": b"", "b.png": b""})
    assert isinstance(found, Observed)
    assert (found.source, found.remarks) == ("map.pgm", ())


def test_a_pgm_on_standard_output_goes_before_a_plot(tmp_path: Path) -> None:
    found = look(tmp_path, {"plot.png": b""}, GOOD)
    assert isinstance(found, Observed)
    assert (found.source, found.remarks) == ("standard output", ())


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
    ({"map.png": b"x"}, b"", "wrong magic", "map.png begins with 'x'"),
    ({"map.txt": b"x"}, b"", "no map", "it wrote map.txt"),
    ({"a.pgm": GOOD, "b.pgm": GOOD}, b"", "no map", "there are 2 pictures and none is lesson.pgm: a.pgm, b.pgm"),
    ({"lesson.pgm": b""}, b"", "half a file", "lesson.pgm is empty"),
    ({"lesson.pgm": b"P2\n3"}, b"", "half a file", "lesson.pgm: it ends within its first lines"),
    ({"lesson.pgm": GOOD[:-8]}, b"", "half a file", "lesson.pgm: 3 pixels, expected 6"),
    ({"lesson.pgm": b"P5 3 2 255\n\x00\x80"}, b"", "half a file", "lesson.pgm: 2 pixels, expected 6"),
    ({"lesson.pgm": b"P1\n2 1\n10\n"}, b"", "wrong magic", "lesson.pgm is a PPM picture of two colours"),
    ({"lesson.pgm": b"P3\n1 1\n255\n1 0 0\n"}, b"", "not a picture", "has red, green, blue and opacity 1, 0, 0, 255"),
    ({"lesson.pgm": b"P3\n2 1\n255\n1 1 1\n"}, b"", "half a file", "lesson.pgm: a PPM picture: not enough image data"),
    ({"lesson.pgm": b"P6 9999 9999 255\n"}, b"", "not a picture", "9999 x 9999 is not from 1 to 25000000 cells"),
    ({"map.png": GREY_PNG[:-26]}, b"", "half a file", "map.png: a PNG picture: image file is truncated"),
    ({"map.png": GREY_PNG, "other.bmp": b""}, b"", "no map", "none is lesson.pgm: map.png, other.bmp"),
    ({"map.png": encoded(ROWS, "JPEG")}, b"", "wrong magic", "is a JPEG picture, which need not keep grey values"),
    ({"map.png": encoded([[[1, 1, 1, 7]]], "PNG")}, b"", "not a picture", "opacity 1, 1, 1, 7; in a grey picture"),
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


def test_a_command_that_expects_what_it_does_not_get(tmp_path: Path) -> None:
    (tmp_path / "my work").mkdir()
    (tmp_path / "my work" / "map").write_text("")
    for text, said in {
        "./map {scen}": r"\{scen\} is none of \{scenario\}, ",
        "./map {scenario} > {pgm}": "without a shell, so '>' would be",
        f"{tmp_path}/my work/map {{out}}": f"needs quotes: '{tmp_path}/my work/map'",
        "my work/map {out}": "needs quotes: 'my work/map'",
    }.items():
        with pytest.raises(ValueError, match=said):
            program_from_command(text, tmp_path, 5)
    for text in ("'my work/map' {out}", "awk '{ print }' {scenario}"):
        program_from_command(text, tmp_path, 5)


def test_a_folder_in_place_of_a_program_has_a_name(tmp_path: Path) -> None:
    assert program_from_command(".", tmp_path, 5).name == "."


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
