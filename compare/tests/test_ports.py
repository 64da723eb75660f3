"""Declarations: what port.toml may say, and how its templates are filled in."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from occgrid_parity.ports.declaration import Port, expand, read_port
from occgrid_parity.ports.finding import find_ports
from occgrid_parity.ports.port_file import PortError

GOOD = {
    "name": '"a"',
    "language": '"A"',
    "run": '["run", "{mode}", "{out}", "{scenarios}"]',
    "timeout": "9",
}


def declare(folder: Path, **changes: str | None) -> Path:
    keys = {**GOOD, **changes}
    text = "".join(f"{k} = {v}\n" for k, v in keys.items() if v is not None)
    path = folder / "port.toml"
    path.write_text(text)
    return path


def test_reads_a_declaration(tmp_path: Path) -> None:
    path = declare(
        tmp_path,
        build='[["make", "-C", "{port}"]]',
        version='["v"]',
        probe='["p", "{function}", "{input}", "{output}"]',
        log_scans="7",
        probe_lines="8",
        build_timeout="1.5",
        needs='[{command = "x", install = "pkg-x"}]',
    )
    port = read_port(path)
    assert (port.name, port.language, port.folder) == ("a", "A", tmp_path)
    assert (port.timeout, port.build_timeout) == (9.0, 1.5)
    assert (port.log_scans, port.probe_lines) == (7, 8)
    assert port.build == (("make", "-C", "{port}"),)
    assert port.needs[0].install == "pkg-x"
    assert port.takes_many


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"name": None}, "name is missing"),
        ({"name": "7"}, "name: expected a text, got a whole number"),
        ({"name": '""'}, "name: expected a text that is not empty"),
        ({"name": '"a/b"'}, "name 'a/b' does not make a folder's name"),
        ({"name": '".."'}, "name '..' does not make a folder's name"),
        ({"timeout": "0"}, "timeout: expected a number > 0"),
        ({"timeout": '"9"'}, "timeout: expected a number, got a text"),
        ({"timeout": None}, "timeout is missing"),
        ({"run": None}, "run is missing (a command is a list of texts)"),
        (
            {"run": '"run"'},
            "run: expected a list, got a text (a command is a list of texts)",
        ),
        (
            {"run": "[]"},
            "run: expected a list that is not empty (a command is a list of texts)",
        ),
        (
            {"run": '["{mode}", "{out}"]'},
            "run has no argument {scenarios} or {scenario}",
        ),
        ({"run": '["{mode}", "{scenario}"]'}, "run has no {out}"),
        ({"run": '["{out}", "{scenario}"]'}, "run has no {mode}"),
        (
            {"run": '["--mode={mode}", "{out}", "{scenario}"]'},
            "run: {mode} must be an argument of its own",
        ),
        (
            {"build": '["make"]'},
            "build[0]: expected a list, got a text (a command is a list of texts)",
        ),
        (
            {"build": '[["make", 1]]'},
            "build[0][1]: expected a text, got a whole number (a command is a list of texts)",
        ),
        ({"needs": '[{command = "x"}]'}, "needs[0].install is missing"),
        (
            {"needs": '[{command = "x", instal = "y"}]'},
            "unknown key needs[0].instal",
        ),
        (
            {"needs": '[{command = 3, install = "y"}]'},
            "needs[0].command: expected a text or a list, got a whole number",
        ),
        ({"tiemout": "9"}, "unknown key tiemout"),
        ({"log_scans": "0"}, "log_scans: expected a whole number >= 1"),
        (
            {"probe_lines": "true"},
            "probe_lines: expected a whole number, got true or false",
        ),
    ],
)
def test_says_what_is_wrong_with_a_declaration(
    tmp_path: Path, changes: dict[str, str | None], reason: str
) -> None:
    with pytest.raises(PortError) as error:
        read_port(declare(tmp_path, **changes))
    assert str(error.value) == f"{tmp_path}/port.toml: {reason}"


def test_says_where_the_toml_is_broken(tmp_path: Path) -> None:
    (tmp_path / "port.toml").write_text("name = \n")
    with pytest.raises(PortError, match=r"port\.toml: .*line 1"):
        read_port(tmp_path / "port.toml")


def test_fills_in_a_template() -> None:
    template = [
        "{a}/x",
        "{list}",
        "-D{a}={b}",
        "{none}",
        "{unknown}",
        "{",
        "{}",
    ]
    values: dict[str, str | Path | Sequence[str | Path]] = {
        "a": Path("/p"),
        "b": "q",
        "list": ["1", Path("2")],
        "none": [],
    }
    expected = ["/p/x", "1", "2", "-D/p=q", "{unknown}", "{", "{}"]
    assert expand(template, values) == expected


def test_a_list_may_be_empty(fake: Callable[..., Port]) -> None:
    port = fake("x")
    command = port.command(
        port.run, mode=["--noise-free"], out="o", scenarios=[]
    )
    program = str(port.folder / "program.py")
    assert command == [sys.executable, program, "--noise-free", "--out", "o"]


def test_finds_the_ports_reference_first(
    fake_root: Path, fake: Callable[..., Port]
) -> None:
    fake("cpp")
    assert [port.name for port in find_ports(fake_root)] == ["python", "cpp"]
    other = fake_root / "other"
    other.mkdir()
    text = (fake_root / "cpp" / "port.toml").read_text()
    (other / "port.toml").write_text(text)
    with pytest.raises(
        PortError, match="cpp and other: both ports are named cpp"
    ):
        find_ports(fake_root)


def test_a_missing_tool_is_named_by_its_package(
    fake: Callable[..., Port],
) -> None:
    needs = [
        '[[needs]]\ncommand = "sh"\ninstall = "dash"',
        '[[needs]]\ncommand = "no-such-command-1"\ninstall = "octave"',
        '[[needs]]\ncommand = "no-such-command-2"\ninstall = "octave"',
        '[[needs]]\ncommand = "no-such-command-3"\ninstall = "cmake"',
    ]
    port = fake("x", extra="\n".join(needs))
    assert port.skip_reason == "install octave, cmake"
    assert fake("y", extra=needs[0]).skip_reason is None
