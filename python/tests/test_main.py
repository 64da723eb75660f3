"""main: the command line as its users meet it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

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
        ["--noise-free", "--seed", "0"],
        ["--out"],
        [ONE_BEAM, OCTANTS],
        [ONE_BEAM, "missing/one-beam.log", "--out", "maps"],
    ],
)
def test_bad_usage(
    arguments: list[str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert "usage: occgrid" in err
    assert not list(tmp_path.iterdir())


def test_the_picture(tmp_path: Path) -> None:
    file = tmp_path / "lesson.png"
    assert main(["--out", str(tmp_path / "maps"), "--plot", str(file)]) == 0
    with Image.open(file) as picture:
        colours = picture.convert("RGB").getcolors(maxcolors=1 << 20)
    assert colours is not None and len(colours) > 50
