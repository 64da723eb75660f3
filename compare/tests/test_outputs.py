"""The readers of a port's files say precisely what is wrong with them."""

from __future__ import annotations

import hashlib
import random
import struct
from pathlib import Path

import numpy as np
import pytest

from occgrid_parity.formats.errors import OutputError
from occgrid_parity.formats.log_odds import bits, hash_log_odds, read_log_odds
from occgrid_parity.formats.map_files import read_map, scenario_name
from occgrid_parity.formats.pgm import read_any_pgm, read_pgm
from occgrid_parity.suite.golden import hashes_text, read_hashes


def test_reads_a_picture_top_row_first(tmp_path: Path) -> None:
    path = tmp_path / "a.pgm"
    path.write_text("P2\n3 2\n255\n0 128 255\n7 8 9\n")
    assert read_pgm(path).tolist() == [[0, 128, 255], [7, 8, 9]]


PICTURES = {
    "": "line 1: the file ends, expected P2",
    "P2": "line 1: the file ends within the line 'P2', expected LF",
    "P5\n": "line 1: expected P2, found 'P5'",
    "P2\r\n2 1\n": "line 1: expected P2, found 'P2\\r'",
    "P2\n# x\n2 1\n": "line 2: expected a width and a height, found '# x'",
    "P2\n2  1\n": "line 2: expected a width and a height, found '2  1'",
    "P2\n02 1\n": "line 2: expected a width and a height, found '02 1'",
    "P2\n0 1\n": "line 2: expected a width and a height, found '0 1'",
    "P2\n5001 5000\n": "line 2: 5001 x 5000 is more than 25000000 cells",
    "P2\n2 1\n256\n": "line 3: expected 255, found '256'",
    "P2\n2 1\n255\n": "line 4: the file ends, expected row 1 of 1",
    "P2\n2 1\n255\n1\n": "line 4: 1 pixels, expected 2",
    "P2\n2 1\n255\n1 2 3\n": "line 4: 3 pixels, expected 2",
    "P2\n2 2\n255\n1 2\n1 2 \n": "line 5: pixels are not separated by one space each",
    "P2\n2 1\n255\n1 256\n": "line 4: pixel 2 is '256', expected 0 to 255",
    "P2\n2 1\n255\n1 +2\n": "line 4: pixel 2 is '+2', expected 0 to 255",
    "P2\n2 1\n255\n01 2\n": "line 4: pixel 1 is '01', expected 0 to 255",
    "P2\n2 1\n255\n1 2": "line 4: the file ends within the line '1 2', expected LF",
    "P2\n2 1\n255\n1 2\n\n": "line 5: expected the end of the file, found '\\n'",
    "P2\n2 1\n255\n"
    + "1 " * 500: "line 4: more than 88 bytes, expected row 1 of 1",
}


@pytest.mark.parametrize(("text", "reason"), PICTURES.items())
def test_refuses_a_picture(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "NAME.pgm"
    path.write_bytes(text.encode())
    with pytest.raises(OutputError) as error:
        read_pgm(path)
    assert str(error.value) == f"NAME.pgm: {reason}"


ANY = {
    b"P2 # made by hand\n# more\n 2\t1 # size\n255\n 1\n\n2": [[1, 2]],
    b"P2\n2 1\n15\n0 15 99": [[0, 255]],
    b"P2\n2 1\n65535\n0 32768\n": [[0, 128]],
    b"P5\n2 2\n255\n\x00\x01\xfe\xff": [[0, 1], [254, 255]],
    b"P5 2 1 255\n\x0a\x20trailing": [[10, 32]],
    b"P5\n1 1\n65535\n\xff\xff": [[255]],
}


@pytest.mark.parametrize(("data", "pixels"), ANY.items())
def test_reads_any_picture(
    tmp_path: Path, data: bytes, pixels: list[list[int]]
) -> None:
    path = tmp_path / "a.pgm"
    path.write_bytes(data)
    assert read_any_pgm(path)[0].tolist() == pixels


NOT_ANY = {
    b"": "line 1: expected P2 or P5, found ''",
    b"P6\n1 1\n255\n": "line 1: expected P2 or P5, found 'P6'",
    b"P2": "expected white space before the width",
    b"P2\nx 1\n": "expected the width, found 'x 1\\n'",
    b"P2\n1 1\n": "expected the maximum, found ''",
    b"P2\n0 1\n255\n": "0 x 1 is not from 1 to 25000000 cells",
    b"P2\n9000 9000\n255\n": "9000 x 9000 is not from 1 to 25000000 cells",
    b"P2\n1 1\n65536\n1": "the maximum 65536 is not from 1 to 65535",
    b"P2\n2 1\n255\n1": "1 pixels, expected 2",
    b"P2\n2 1\n255\n1 x": "pixel 2 is 'x', no number",
    b"P2\n2 1\n9\n1 10": "a pixel is 10, above 9",
    b"P5\n2 1\n255\n1": "1 pixels, expected 2",
    b"P5\n1 1\n255": "expected one white space after the maximum",
}


@pytest.mark.parametrize(("data", "reason"), NOT_ANY.items())
def test_refuses_what_is_no_picture(
    tmp_path: Path, data: bytes, reason: str
) -> None:
    path = tmp_path / "a.pgm"
    path.write_bytes(data)
    with pytest.raises(OutputError) as error:
        read_any_pgm(path)
    assert str(error.value) == f"a.pgm: {reason}"


def test_reads_log_odds_to_the_last_bit(tmp_path: Path) -> None:
    source = random.Random(4)
    values = [
        source.uniform(-8, 8) * 10.0 ** source.randint(-9, 0)
        for _ in range(5000)
    ]
    values += [5e-324, -2.2250738585072014e-308, 1000.0, -0.0, 0.1 + 0.2]
    texts = [f"{value:.17g}" for value in values]
    path = tmp_path / "a.logodds"
    path.write_text(f"# logodds {len(values)} 1\n" + " ".join(texts) + "\n")
    read = read_log_odds(path)
    expected = [
        struct.unpack("<Q", struct.pack("<d", value))[0] for value in values
    ]
    assert bits(read)[0].tolist() == expected


def test_takes_every_way_to_write_a_decimal(tmp_path: Path) -> None:
    path = tmp_path / "a.logodds"
    path.write_text(
        "# logodds 3 2\n0 -1. +.5\n1E-3 -2.5e+00 0.00012345678901234567\n"
    )
    expected = [[0.0, -1.0, 0.5], [1e-3, -2.5, 0.00012345678901234567]]
    assert read_log_odds(path).tolist() == expected


LOG_ODDS = {
    "": "line 1: the file ends, expected # logodds WIDTH HEIGHT",
    "# logodds\n": "line 1: expected # logodds WIDTH HEIGHT, found '# logodds'",
    "# logodds 2\n": "line 1: expected a width and a height, found '# logodds 2'",
    "# logodds 2 -1\n": "line 1: expected a width and a height, found '# logodds 2 -1'",
    "# logodds 99999 99999\n": "line 1: 99999 x 99999 is more than 25000000 cells",
    "# logodds 2 1\n": "line 2: the file ends, expected row 1 of 1",
    "# logodds 2 1\n1\n": "line 2: 1 values, expected 2",
    "# logodds 2 1\n1 2 3\n": "line 2: 3 values, expected 2",
    "# logodds 2 1\n1  2\n": "line 2: values are not separated by one space each",
    "# logodds 2 1\n1 2 \n": "line 2: values are not separated by one space each",
    "# logodds 2 1\n1 2\r\n": "line 2: value 2 is '2\\r', expected a decimal",
    "# logodds 2 1\n1\t2\n": "line 2: 1 values, expected 2",
    "# logodds 3 1\n1-2 3 \n": "line 2: values are not separated by one space each",
    "# logodds 2 1\n1-2 3\n": "line 2: value 1 is '1-2', expected a decimal",
    "# logodds 2 1\n1 nan\n": "line 2: value 2 is 'nan', expected a decimal",
    "# logodds 2 1\n0x1p3 1\n": "line 2: value 1 is '0x1p3', expected a decimal",
    "# logodds 2 1\n1e 1\n": "line 2: value 1 is '1e', expected a decimal",
    "# logodds 2 1\n1,5 1\n": "line 2: value 1 is '1,5', expected a decimal",
    "# logodds 1 1\n1e999\n": "line 2: value 1 is '1e999', not finite",
    "# logodds 1 1\n0.100000000000000006\n": (
        "line 2: value 1 is '0.100000000000000006', more than 17 digits"
    ),
    "# logodds 1 1\n100000000000000000\n": (
        "line 2: value 1 is '100000000000000000', more than 17 digits"
    ),
    "# logodds 1 2\n1\n2": "line 3: the file ends within the line '2', expected LF",
    "# logodds 1 1\n1\n2\n": "line 3: expected the end of the file, found '2\\n'",
}


@pytest.mark.parametrize(("text", "reason"), LOG_ODDS.items())
def test_refuses_log_odds(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "NAME.logodds"
    path.write_bytes(text.encode())
    with pytest.raises(OutputError) as error:
        read_log_odds(path)
    assert str(error.value) == f"NAME.logodds: {reason}"


def write_three(folder: Path) -> None:
    (folder / "a.pgm").write_text("P2\n2 1\n255\n1 2\n")
    (folder / "a.logodds").write_text("# logodds 2 1\n0.5 1\n")
    (folder / "a.yaml").write_text("image: a.pgm\n")


@pytest.mark.parametrize("suffix", [".pgm", ".yaml", ".logodds"])
def test_a_map_is_all_its_files(tmp_path: Path, suffix: str) -> None:
    write_three(tmp_path)
    assert read_map(tmp_path, "a").yaml == b"image: a.pgm\n"
    (tmp_path / f"a{suffix}").unlink()
    with pytest.raises(OutputError, match=f"^a{suffix}: is missing$"):
        read_map(tmp_path, "a")


def test_the_grids_of_a_map_have_one_size(tmp_path: Path) -> None:
    write_three(tmp_path)
    (tmp_path / "a.logodds").write_text("# logodds 1 2\n0.5\n1\n")
    with pytest.raises(OutputError) as error:
        read_map(tmp_path, "a")
    assert (
        str(error.value) == "a.logodds: 1 x 2 cells beside a picture of 2 x 1"
    )


def test_the_hash_is_of_little_endian_doubles_smallest_y_first() -> None:
    log_odds = np.array([[0.5, 1.0], [-2.0, 0.0]])
    data = struct.pack("<4d", 0.5, 1.0, -2.0, 0.0)
    assert hash_log_odds(log_odds) == hashlib.sha256(data).hexdigest()
    turned = struct.pack("<4d", 0.5, -2.0, 1.0, 0.0)
    assert hash_log_odds(log_odds.T) == hashlib.sha256(turned).hexdigest()


def test_hashes_read_back(tmp_path: Path) -> None:
    path = tmp_path / "a.sha256"
    hashes = ["0" * 64, "ab" * 32]
    path.write_text(hashes_text(hashes))
    assert read_hashes(path) == hashes


@pytest.mark.parametrize(
    ("text", "reason"),
    {
        "": "has no scan",
        "scan 1 "
        + "0" * 64
        + "\n": "line 1: expected scan 0 and 64 hexadecimal",
        "scan 0 "
        + "0" * 63
        + "\n": "line 1: expected scan 0 and 64 hexadecimal",
        "scan 0 " + "0" * 64: "has no last LF",
    }.items(),
)
def test_refuses_hashes(tmp_path: Path, text: str, reason: str) -> None:
    path = tmp_path / "a.sha256"
    path.write_text(text)
    with pytest.raises(OutputError, match=f"^a.sha256: {reason}"):
        read_hashes(path)


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("lesson.log", "lesson"),
        ("a/b.c/intel.gfs.log", "intel.gfs"),
        ("plain", "plain"),
        (".hidden", ".hidden"),
        ("..log", "."),
        ("ends.", "ends"),
    ],
)
def test_names_a_scenario_as_the_contract_says(file: str, name: str) -> None:
    assert scenario_name(file) == name
