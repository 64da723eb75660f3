"""The command: its exit status, its record, and the command it gives to see a difference again."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from occgrid_parity.check.bad_input import BAD
from occgrid_parity.check.levels import LEVELS
from occgrid_parity.check.verdict import from_json
from occgrid_parity.commands.app import app
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.suite.cases import scenario_folder


def invoke(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["check", *arguments])
    return result.exit_code, result.output


def quiet_maps() -> int:
    """How many scenarios the levels ask without noise."""
    quiet = [plan for plan in LEVELS if not plan.noisy]
    return len({name for plan in quiet for name in plan.scenarios})


def test_a_right_program_ends_with_0(tmp_path: Path, mapper: Path) -> None:
    """It maps without noise only; its sines may put beams of the lesson on the other side of an edge."""
    folder = tmp_path / "o"
    command = f"{mapper} none --noise-free {{out}} {{scenario}}"
    status, text = invoke(
        "--run",
        command,
        "--out",
        str(folder),
        "--json",
        str(tmp_path / "j.json"),
    )
    assert status == 0
    assert re.match("mapper: (identical|on the lesson it differs only)", text)
    verdict = from_json((tmp_path / "j.json").read_text())
    assert verdict == from_json((folder / "verdict.json").read_text())
    assert verdict.score == verdict.maximum == 19
    assert verdict.compared == "pixels only"
    assert len(verdict.not_checked) == 3
    for said in verdict.not_checked:
        assert f"not checked: {said}" in text
    assert verdict.runs == quiet_maps() + len(BAD), "each scenario once"
    assert not (folder / "first-difference.log").exists()


def test_a_wrong_program_ends_with_1_and_can_be_seen_again(
    tmp_path: Path, mapper: Path
) -> None:
    run = f"{mapper} prior --noise-free {{out}} {{scenario}}"
    status, text = invoke("--run", run, "--out", str(tmp_path))
    assert status == 1
    mistake = MISTAKES["prior-not-subtracted"]
    assert f"{mistake.title} [{mistake.name}]" in text
    said = f"it reproduces all {quiet_maps()} of your maps exactly"
    assert said in text
    command = next(
        line.strip()
        for line in text.splitlines()
        if line.strip().startswith("occgrid-parity check")
    )
    words = shlex.split(command)[1:]
    result = CliRunner().invoke(
        app, [*words, "--out", str(tmp_path / "again")]
    )
    assert result.exit_code == 1
    again = from_json((tmp_path / "again" / "verdict.json").read_text())
    assert again.first_difference is not None
    assert (again.first_difference.scan, again.first_difference.beam) == (0, 0)


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--run", "true", "--port", "x"],
        ["--run", ""],
        ["--port", "/nowhere/port.toml"],
        ["--class", "/nowhere"],
        ["--run", "true", "--scenario", "no-such"],
        ["--run", "true", "--mode", "noise-free"],
        ["--run", "true", "--scenario", "one-beam", "--mode", "seed"],
        ["--run", "true", "--json", "/nowhere/a.json"],
        ["--run", "true", "--junit", "/nowhere/a.xml"],
        ["--run", "true", "--gradescope", "/nowhere/a.json"],
    ],
)
def test_wrong_usage_ends_with_2(arguments: list[str]) -> None:
    status, _ = invoke(*arguments)
    assert status == 2


def test_wrong_usage_is_one_line_that_names_it(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("")
    for arguments, said in {
        (
            "--scenario",
            "no-such",
        ): "no-such: no file, and no scenario of the suite has this name\n",
        (
            "--scenario",
            ".",
        ): ".: no file, and no scenario of the suite has this name\n",
        ("--out", str(file / "out")): f"{file}/out: Not a directory\n",
        ("--out", str(file)): f"{file}: File exists\n",
    }.items():
        assert invoke("--run", "true", *arguments) == (2, said)


def test_a_class_of_one(tmp_path: Path, mapper: Path) -> None:
    place = tmp_path / "class" / "ada"
    place.mkdir(parents=True)
    shutil.copy(mapper, place)
    (place / "port.toml").write_text(
        'run = ["{port}/mapper", "none", "{mode}", "{out}", "{scenario}"]\n'
    )
    status, text = invoke(
        "--class",
        str(tmp_path / "class"),
        "--out",
        str(tmp_path / "out"),
        "--scenario",
        "one-beam",
    )
    assert status == 0
    assert "1 of 1 are as they should be" in text
    assert (
        (tmp_path / "out" / "summary.csv")
        .read_text()
        .splitlines()[1]
        .startswith("ada,identical,")
    )


def test_the_python_port_is_identical(tmp_path: Path) -> None:
    port = scenario_folder().parent / "python" / "port.toml"
    if not port.is_file():
        pytest.skip("there is no port beside the installed package")
    status, text = invoke(
        "--port",
        str(port),
        "--out",
        str(tmp_path),
        "--scenario",
        "octants",
        "--scenario",
        "asymmetric",
    )
    assert status == 0
    assert "compared: pixels, and every bit of the log-odds" in text
