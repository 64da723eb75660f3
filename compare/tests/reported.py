"""A run to report on: the Python port, one that draws a few cells otherwise, and worse ones."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from occgrid_parity.compare.matrix_run import Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.ports.declaration import Port, read_port
from occgrid_parity.suite.modes import DEFAULT_MODES
from occgrid_parity.suite.repository import find_root
from occgrid_parity.suite.scenarios import choose_scenarios

ROOT = find_root(Path(__file__).parent)

# draws the maps as the Python port does, then moves one cell by one bit and
# another one by much
NEARLY = """
import pathlib, sys
from occgrid.main import main
status = main(sys.argv[1:])
out = pathlib.Path(sys.argv[sys.argv.index("--out") + 1])
file = out / "asymmetric.logodds"
if file.exists():
    head, *rows = file.read_text().splitlines()
    values = [row.split(" ") for row in rows]
    values[20][30] = repr(float.fromhex("0x1.0000000000001p-3"))
    values[3][5] = "4.0"
    rows = [" ".join(row) for row in values]
    file.write_text("\\n".join([head, *rows]) + "\\n")
    picture = out / "asymmetric.pgm"
    lines = picture.read_text().splitlines()
    row = lines[3 + 36 - 3].split(" ")
    row[5] = "5"
    lines[3 + 36 - 3] = " ".join(row)
    picture.write_text("\\n".join(lines) + "\\n")
raise SystemExit(status)
"""
CRASHES = "raise SystemExit('<b>no</b> & never</script>')"


@dataclass(frozen=True)
class Ran:
    """A run and the folder of its maps."""

    record: RunRecord
    folder: Path


def run_and_report(root: Path, folder: Path) -> Ran:
    """One-beam, asymmetric and saturate, in both modes, with four ports.

    The ports are made in ``root``, the maps in ``folder``.
    """
    ports = [
        read_port(ROOT / "python" / "port.toml"),
        _port(root, "nearly", NEARLY),
        _port(root, "crashes", CRASHES),
        _port(root, "absent", "", needs="no-such-tool"),
    ]
    plan = Plan(
        ports=ports,
        scenarios=choose_scenarios(
            ROOT, ["one-beam", "asymmetric", "saturate"]
        ),
        folder=folder,
        modes=DEFAULT_MODES,
        golden=ROOT / "scenarios" / "golden",
    )
    return Ran(run(plan), folder)


def _port(root: Path, name: str, program: str, needs: str = "") -> Port:
    folder = root / name
    folder.mkdir()
    (folder / "program.py").write_text(program)
    tools = (
        f'[[needs]]\ncommand = "{needs}"\ninstall = "{needs}"\n'
        if needs
        else ""
    )
    (folder / "port.toml").write_text(
        f'name = "{name}"\nlanguage = "test"\n'
        f'run = ["{sys.executable}", "{{port}}/program.py", "{{mode}}", '
        f'"--out", "{{out}}", "{{scenarios}}"]\ntimeout = 30\n{tools}'
    )
    return read_port(folder / "port.toml")
