"""Ports that go wrong in every way, each with a status of its own."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from rich.console import Console
from typer.testing import CliRunner

from occgrid_parity.commands.app import app
from occgrid_parity.compare.matrix_run import Plan, prepare_folder, run
from occgrid_parity.compare.run_record import (
    Result,
    RunRecord,
    from_json,
    to_json,
)
from occgrid_parity.formats.log_odds import hash_log_odds, read_log_odds
from occgrid_parity.ports.declaration import Port
from occgrid_parity.ports.finding import find_ports
from occgrid_parity.report.run_table import (
    explain_result,
    footnotes,
    matrix_table,
    summary,
)
from occgrid_parity.suite.golden import golden_files, hashes_text
from occgrid_parity.suite.modes import DEFAULT_MODES, NOISE_FREE, Mode
from occgrid_parity.suite.scenarios import BUILT_IN_NAME, choose_scenarios

Fake = Callable[..., Port]


def run_all(
    root: Path,
    words: Sequence[str] = (),
    modes: Sequence[Mode] = (NOISE_FREE,),
) -> RunRecord:
    folder = root / "out"
    prepare_folder(folder)
    plan = Plan(
        ports=find_ports(root),
        scenarios=choose_scenarios(root, words),
        modes=modes,
        folder=folder,
        golden=root / "scenarios" / "golden",
    )
    return run(plan)


def results(record: RunRecord, port: str) -> dict[str, Result]:
    return {r.scenario: r for r in record.results if r.port == port}


def one(root: Path, port: str) -> Result:
    """The result of that port on scenario b; the others' must be identical."""
    found = results(run_all(root, ["a", "b", "c"]), port)
    assert found["a"].status == found["c"].status == "identical", found
    assert found["a"].reason == ""
    return found["b"]


def test_ports_that_agree_are_identical(fake_root: Path, fake: Fake) -> None:
    fake("x")
    record = run_all(fake_root, modes=DEFAULT_MODES)
    assert record.is_identical()
    assert [s.name for s in record.scenarios] == [BUILT_IN_NAME, "a", "b", "c"]
    assert record.counts()["identical"] == len(record.results) == 2 * 4 * 2
    x = record.result("x", "b", "seed-0")
    assert (x.width, x.height, x.compared_with) == (2, 3, ["python"])
    assert (
        (fake_root / "out" / str(x.picture))
        .read_text()
        .startswith("P2\n2 3\n")
    )
    # two processes for each mode: the built-in lesson, and all files together
    processes = [p for p in record.processes if p.port == "x"]
    assert [p.scenarios for p in processes] == 2 * [
        [BUILT_IN_NAME],
        ["a", "b", "c"],
    ]
    assert {p.command[2] for p in processes} == {"--noise-free", "--seed"}


def test_the_record_is_json_and_comes_back(
    fake_root: Path, fake: Fake
) -> None:
    fake("x", "for file in files:\n    write(file.stem, yaml='image: other')")
    record = run_all(fake_root)
    text = (fake_root / "out" / "run.json").read_text()
    assert text == to_json(record)
    assert json.loads(text)["schema"] == 1
    assert from_json(text) == record
    with pytest.raises(ValueError, match="schema 2, expected 1"):
        from_json(text.replace('"schema": 1', '"schema": 2'))
    with pytest.raises(ValueError, match="not a record of schema 1"):
        from_json(text.replace('"reference"', '"preference"'))


def test_nothing_compared_is_not_identical(fake_root: Path) -> None:
    record = run_all(fake_root)
    assert record.counts()["identical"] == len(record.results)
    assert not record.is_identical()
    assert "8 reference" not in summary(record)
    assert "4 reference" in summary(record)
    assert "nothing was compared" in footnotes(record)[1]


ONE_BIT = """
for file in files:
    if file.stem == "b":
        write("b", values=((0.0, -3.5), (8.0, 0.10000000000000002), (1.5, 0.25)))
    else:
        write(file.stem)
"""


def test_one_bit_differs(fake_root: Path, fake: Fake) -> None:
    fake("x", ONE_BIT)
    result = one(fake_root, "x")
    assert result.status == "differs"
    assert explain_result(result) == [
        "x, b, noise-free: differs",
        "  b.logodds: 1 of 6 cells differ from python",
        "    cell gx=1 gy=1",
        "      found    log-odds 0.10000000000000002 (0x3fb999999999999b), "
        "p 0.524979, pixel 128",
        "      expected log-odds 0.1 (0x3fb999999999999a), p 0.524979, pixel 128",
    ]


def test_the_sign_of_zero_differs(fake_root: Path, fake: Fake) -> None:
    fake(
        "x", ONE_BIT.replace("(0.0,", "(-0.0,").replace("0000000000000002", "")
    )
    result = one(fake_root, "x")
    assert result.status == "differs"
    cell = result.differences[0].cells[0]
    assert (cell.gx, cell.gy) == (0, 0)
    assert (cell.found.bits, cell.expected.bits) == ("8" + "0" * 15, "0" * 16)


def test_many_cells_differ(fake_root: Path, fake: Fake) -> None:
    values = "values=((1.0, 1.0), (1.0, 1.0), (1.0, 1.0))"
    fake("x", f"for file in files:\n    write(file.stem, {values})")
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.differences[0].count == 6
    assert len(result.differences[0].cells) == 5
    assert explain_result(result)[-1] == "    and 1 more"


def test_one_pixel_differs(fake_root: Path, fake: Fake) -> None:
    fake(
        "x",
        "for file in files:\n    write(file.stem, ((128, 255), (0, 129), (7, 8)))",
    )
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.status == "differs"
    assert explain_result(result)[1:] == [
        "  a.pgm: 1 of 6 pixels differ from python",
        "    cell gx=1 gy=1",
        "      found    log-odds 0.1 (0x3fb999999999999a), p 0.524979, pixel 129",
        "      expected log-odds 0.1 (0x3fb999999999999a), p 0.524979, pixel 128",
    ]


def test_the_yaml_differs(fake_root: Path, fake: Fake) -> None:
    fake(
        "x",
        "for f in files:\n    write(f.stem, yaml='image: a.pgm\\r\\nnegate: 0\\n')",
    )
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.status == "differs"
    assert explain_result(result)[1:] == [
        "  a.yaml: 1 of 2 lines differ from python",
        r"    line 1: found    'image: a.pgm\r\n'",
        r"    line 1: expected 'image: a.pgm\n'",
    ]


def test_the_size_differs(fake_root: Path, fake: Fake) -> None:
    fake("x", "for f in files:\n    write(f.stem, ((1, 2),), ((0.0, 0.0),))")
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.status == "differs"
    assert explain_result(result)[2] == "    2 x 1 cells, expected 2 x 3"


BREAKS = {
    "crash": (
        "os.kill(os.getpid(), signal.SIGSEGV)",
        "error",
        "killed by SIGSEGV, nothing on standard error",
    ),
    "status": (
        "sys.exit('what is wrong')",
        "error",
        "exit status 1: what is wrong",
    ),
    "hang": (
        "subprocess.Popen(['sleep', '1000']); time.sleep(1000)",
        "timeout",
        "no end after 5 s, killed",
    ),
}


@pytest.mark.parametrize(
    ("code", "status", "reason"), BREAKS.values(), ids=BREAKS
)
def test_a_failure_takes_no_other_result_with_it(
    fake_root: Path, fake: Fake, code: str, status: str, reason: str
) -> None:
    body = f"""
for file in files:
    if file.stem == "b":
        {code}
    write(file.stem)
"""
    fake("x", body, timeout=5 if status == "timeout" else 100)
    result = one(fake_root, "x")
    assert (result.status, result.reason) == (status, reason)


SPOILS = {
    "nothing": ("pass", "b.pgm: is missing"),
    "one file": (
        "write('b'); (out / 'b.yaml').unlink()",
        "b.yaml: is missing",
    ),
    "half a file": (
        "write('b'); (out / 'b.pgm').write_text('P2\\n2 3\\n255\\n7 8\\n0 1')",
        "b.pgm: line 5: the file ends within the line '0 1', expected LF",
    ),
    "half a line": (
        "write('b'); (out / 'b.logodds').write_text('# logodds 2 3\\n1 2\\n3\\n')",
        "b.logodds: line 3: 1 values, expected 2",
    ),
    "a folder": (
        "write('b'); (out / 'b.pgm').unlink(); (out / 'b.pgm').mkdir()",
        "b.pgm: is missing",
    ),
}


@pytest.mark.parametrize(("code", "reason"), SPOILS.values(), ids=SPOILS)
def test_a_missing_or_broken_output_is_an_error(
    fake_root: Path, fake: Fake, code: str, reason: str
) -> None:
    body = f"""
for file in files:
    if file.stem == "b":
        {code}
    else:
        write(file.stem)
"""
    fake("x", body)
    result = one(fake_root, "x")
    assert (result.status, result.reason) == ("error", reason)
    assert explain_result(result) == [f"x, b, noise-free: error: {reason}"]


def test_output_of_an_earlier_run_is_not_found_again(
    fake_root: Path, fake: Fake
) -> None:
    port = fake("x")
    assert results(run_all(fake_root, ["a"]), "x")["a"].status == "identical"
    program = port.folder / "program.py"
    program.write_text(
        program.read_text().replace("for file in files:", "if False:")
    )
    assert results(run_all(fake_root, ["a"]), "x")["a"].status == "error"


def test_a_program_that_cannot_be_started(fake_root: Path, fake: Fake) -> None:
    port = fake("x")
    toml = port.folder / "port.toml"
    toml.write_text(toml.read_text().replace(sys.executable, "{port}/gone"))
    result = results(run_all(fake_root, ["a", "b"]), "x")["b"]
    assert result.status == "error"
    assert result.reason.startswith("cannot be started: ")


def test_a_missing_tool_is_skipped_with_its_reason(
    fake_root: Path, fake: Fake
) -> None:
    fake(
        "x", extra='[[needs]]\ncommand = "no-such-command"\ninstall = "octave"'
    )
    record = run_all(fake_root, ["a"])
    result = results(record, "x")["a"]
    assert (result.status, result.reason) == ("skipped", "install octave")
    assert "x: skipped: install octave" in footnotes(record)
    assert not record.is_identical()
    # nothing but the reference is left: nothing was compared
    assert not record.is_identical(allow_skipped=True)
    fake("y")
    record = run_all(fake_root, ["a"])
    assert not record.is_identical()
    assert record.is_identical(allow_skipped=True)


def test_a_build_that_fails(fake_root: Path, fake: Fake) -> None:
    lines = "print('fine'); raise SystemExit('x.cpp:1: error: no')"
    build = json.dumps([[sys.executable, "-c", lines]])
    fake("x", extra=f"build = {build}")
    record = run_all(fake_root, ["a"])
    result = results(record, "x")["a"]
    assert result.status == "error"
    assert result.reason.startswith("build failed: x.cpp:1: error: no (")
    assert not [p for p in record.processes if p.port == "x"]


def test_a_build_that_hangs(fake_root: Path, fake: Fake) -> None:
    build = json.dumps([["sleep", "1000"]])
    fake("x", extra=f"build = {build}\nbuild_timeout = 0.5")
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.status == "error"
    assert (
        result.reason
        == "build failed: no end after 0.5 s, killed (sleep 1000)"
    )


def test_the_version_is_recorded(fake_root: Path, fake: Fake) -> None:
    version = json.dumps([sys.executable, "-c", "print('x 1.0')"])
    fake("x", extra=f"version = {version}")
    ports = {port.name: port for port in run_all(fake_root, ["a"]).ports}
    assert ports["x"].version == "x 1.0"
    assert ports["python"].version is None


def test_without_the_reference_nothing_is_identical(
    fake_root: Path, fake: Fake
) -> None:
    program = fake_root / "python" / "program.py"
    program.write_text(program.read_text() + "\nsys.exit(3)\n")
    fake("x")
    record = run_all(fake_root, ["a"])
    reason = "exit status 3, nothing on standard error"
    assert results(record, "python")["a"].status == "error"
    x = results(record, "x")["a"]
    assert (x.status, x.reason) == (
        "error",
        f"no map of the reference python: {reason}",
    )


def test_a_reference_that_times_out_costs_its_own_cell(
    fake_root: Path, fake: Fake
) -> None:
    program = fake_root / "python" / "program.py"
    program.write_text(
        program.read_text().replace(
            "for file in files:",
            "for file in files:\n    if file.stem == 'b': time.sleep(1000)",
        )
    )
    toml = fake_root / "python" / "port.toml"
    toml.write_text(toml.read_text().replace("timeout = 100", "timeout = 5"))
    fake("x")
    fake("y")
    fake("z", ONE_BIT)
    record = run_all(fake_root, ["a", "b"])
    found = {
        (r.port, r.scenario): (r.status, r.compared_with)
        for r in record.results
    }
    assert found == {
        ("python", "a"): ("identical", []),
        ("x", "a"): ("identical", ["python"]),
        ("y", "a"): ("identical", ["python"]),
        ("z", "a"): ("identical", ["python"]),
        ("python", "b"): ("timeout", []),
        ("x", "b"): ("identical", ["y"]),
        ("y", "b"): ("identical", ["x"]),
        ("z", "b"): ("differs", ["x"]),
    }
    assert not record.is_identical()


def test_golden_results_stand_in_for_the_reference(
    fake_root: Path, fake: Fake
) -> None:
    fake("x")
    commit_golden(fake_root, run_all(fake_root, ["a"]))
    program = fake_root / "python" / "program.py"
    program.write_text(program.read_text() + "\nsys.exit(3)\n")
    x = results(run_all(fake_root, ["a"]), "x")["a"]
    assert (x.status, x.compared_with) == ("identical", ["golden"])


def test_the_time_limit_of_the_command(fake_root: Path, fake: Fake) -> None:
    fake("x", "time.sleep(1000)")
    words = ["run", "--root", str(fake_root), "--scenario", "a"]
    words += ["--mode", "noise-free", "--timeout", "1.5"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 1
    assert "no end after 1.5 s, killed" in result.output


def test_a_program_that_takes_one_scenario(
    fake_root: Path, fake: Fake
) -> None:
    port = fake("x")
    toml = port.folder / "port.toml"
    toml.write_text(toml.read_text().replace("{scenarios}", "{scenario}"))
    record = run_all(fake_root)
    assert record.is_identical()
    assert len([p for p in record.processes if p.port == "x"]) == 4


def commit_golden(
    root: Path, record: RunRecord, mode: Mode = NOISE_FREE
) -> None:
    """Makes the reference's maps of a run the golden ones."""
    golden = root / "scenarios" / "golden"
    for result in record.results:
        if (
            result.port == "python"
            and result.mode == mode.name
            and result.picture
        ):
            picture = root / "out" / result.picture
            hash_file, picture_file = golden_files(golden, picture.stem, mode)
            picture_file.write_bytes(picture.read_bytes())
            digest = hash_log_odds(
                read_log_odds(picture.with_suffix(".logodds"))
            )
            hash_file.write_text(hashes_text(["0" * 64, digest]))


def test_every_port_must_equal_the_golden_result(
    fake_root: Path, fake: Fake
) -> None:
    fake("x")
    commit_golden(fake_root, run_all(fake_root))
    record = run_all(fake_root)
    assert record.is_identical()
    assert record.result("python", "a", "noise-free").compared_with == [
        "golden"
    ]
    x = record.result("x", BUILT_IN_NAME, "noise-free")
    assert x.compared_with == ["python", "golden"]
    for name in ("python", "x"):  # both change alike
        program = fake_root / name / "program.py"
        text = program.read_text()
        program.write_text(
            text.replace("128, 255", "127, 255").replace("-3.5", "-3.6")
        )
    record = run_all(fake_root, ["a"])
    digest = (
        record.result("x", "a", "noise-free")
        .differences[0]
        .detail[1]
        .split()[1]
    )
    for name in ("python", "x"):
        result = record.result(name, "a", "noise-free")
        assert result.status == "differs"
        text = "\n".join(explain_result(result))
        assert (
            "a.logodds: 1 of 1 hashes differ from golden a.noise-free.sha256"
            in text
        )
        assert f"found    {digest}" in text
        assert (
            "a.pgm: 1 of 6 pixels differ from golden a.noise-free.pgm" in text
        )
        assert "cell gx=0 gy=0" in text
        assert "expected pixel 128" in text


def test_half_a_golden_result_is_an_error(fake_root: Path, fake: Fake) -> None:
    fake("x")
    commit_golden(fake_root, run_all(fake_root))
    (fake_root / "scenarios" / "golden" / "a.noise-free.pgm").unlink()
    result = results(run_all(fake_root, ["a"]), "x")["a"]
    assert result.status == "error"
    assert result.reason == "golden result: a.noise-free.pgm: is missing"


def test_a_folder_that_is_no_runs_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(
        FileExistsError, match="is not empty and not the folder of a run"
    ):
        prepare_folder(tmp_path)
    assert (tmp_path / "thesis.txt").read_text() == "years of work"


def test_scenarios_are_chosen_by_name_or_file(
    fake_root: Path, tmp_path: Path
) -> None:
    other = tmp_path / "elsewhere" / "d.log"
    other.parent.mkdir()
    other.write_text("POSE 0 0 0\n")
    chosen = choose_scenarios(fake_root, ["built-in", "b", str(other), "b"])
    assert [s.name for s in chosen] == [BUILT_IN_NAME, "b", "d"]
    with pytest.raises(
        ValueError, match="'e' is neither a file nor a scenario: built"
    ):
        choose_scenarios(fake_root, ["e"])
    twin = other.with_name("b.log")
    twin.write_text("")
    with pytest.raises(ValueError, match="are both named b"):
        choose_scenarios(fake_root, ["b", str(twin)])


def table_text(record: RunRecord) -> str:
    console = Console(width=100, record=True, file=io.StringIO())
    console.print(matrix_table(record))
    return console.export_text()


def test_the_table_is_made_from_the_record_alone(
    fake_root: Path, fake: Fake
) -> None:
    fake("x", ONE_BIT)
    fake(
        "y", extra='[[needs]]\ncommand = "no-such-command"\ninstall = "octave"'
    )
    record = run_all(fake_root, ["a", "b"], DEFAULT_MODES)
    again = from_json((fake_root / "out" / "run.json").read_text())
    text = table_text(again)
    assert text == table_text(record)
    rows = [line.split() for line in text.splitlines()]
    assert ["b", "noise-free", "reference", "differs", "skipped"] in rows
    assert ["a", "noise-free", "reference", "identical", "skipped"] in rows


def cli(root: Path, *arguments: str) -> tuple[int, str]:
    out = str(root / "out")
    words = ["run", "--root", str(root), "--out", out, *arguments]
    result = CliRunner().invoke(app, words)
    return result.exit_code, result.output


def test_the_command_ends_with_0_only_if_all_is_identical(
    fake_root: Path, fake: Fake
) -> None:
    fake("x")
    status, text = cli(fake_root)
    assert status == 0, text
    assert "32 maps: 16 reference, 16 identical" in text
    assert f"pictures and run.json: {fake_root / 'out'}" in text
    assert "[1/18] " in text
    fake("y", ONE_BIT)
    status, text = cli(fake_root, "--json", str(fake_root / "copy.json"))
    assert status == 1
    assert "b.logodds: 1 of 6 cells differ from python" in text
    assert (
        from_json((fake_root / "copy.json").read_text()).counts()["differs"]
        == 4
    )
    assert cli(fake_root, "--port", "x")[0] == 0
    assert (
        cli(fake_root, "--port", "x", "--port", "y", "--scenario", "a")[0] == 0
    )
    assert (
        cli(fake_root, "--port", str(fake_root / "y"), "--mode", "seed-7")[0]
        == 1
    )


def test_skipped_ports_are_no_success(fake_root: Path, fake: Fake) -> None:
    fake("x")
    fake(
        "y", extra='[[needs]]\ncommand = "no-such-command"\ninstall = "octave"'
    )
    assert cli(fake_root, "--scenario", "a")[0] == 1
    status, text = cli(fake_root, "--scenario", "a", "--allow-skipped")
    assert status == 0
    assert "y: skipped: install octave" in text


@pytest.mark.parametrize(
    "arguments",
    [
        ("--port", "nobody"),
        ("--scenario", "nothing"),
        ("--mode", "noisy"),
        ("--mode", "seed-4294967296"),
        ("--mode", "seed-01"),
        ("--jobs", "0"),
        ("--out", "/dev/null"),
        ("--root", "/nowhere"),
    ],
)
def test_wrong_usage_ends_with_2(
    fake_root: Path, arguments: tuple[str, str]
) -> None:
    assert cli(fake_root, *arguments)[0] == 2


def test_build_says_what_failed(fake_root: Path, fake: Fake) -> None:
    words = ["build", "--root", str(fake_root)]
    assert CliRunner().invoke(app, words).exit_code == 0
    build = json.dumps(
        [[sys.executable, "-c", "raise SystemExit('error: no')"]]
    )
    fake("x", extra=f"build = {build}")
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 1
    assert "x: build failed: error: no" in result.output
    assert CliRunner().invoke(app, [*words, "python"]).exit_code == 0
    assert CliRunner().invoke(app, [*words, "nobody"]).exit_code == 2
