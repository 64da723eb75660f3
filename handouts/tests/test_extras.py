"""What there is to run: the notebook of Python, the script of MATLAB, the notebook of Mathematica."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient.exceptions import CellExecutionError

from built_handouts import Handouts, needs
from occgrid_handouts.blocks import Command, Heading, Program
from occgrid_handouts.mathematica import SETUP, notebook_expression
from occgrid_handouts.matlab_script import script_text
from occgrid_handouts.notebook import make_notebook, run_notebook
from occgrid_handouts.platform_math import wolfram_command
from occgrid_handouts.project import ROOT
from occgrid_handouts.wolfram_syntax import check_expression

# nbformat has no types
READ: Any = nbformat.read


def test_notebook_was_run_from_top_to_bottom(handouts: Handouts) -> None:
    path = handouts.folder / "student/python.ipynb"
    notebook = READ(path, as_version=4)
    nbformat.validate(notebook)
    code = [c for c in notebook.cells if c.cell_type == "code"]
    assert [c.execution_count for c in code] == list(range(1, len(code) + 1))
    assert len(code) >= 6
    outputs = [o for c in code for o in c.outputs]
    assert not [o for o in outputs if o.output_type == "error"]
    texts = "".join(o.get("text", "") for o in outputs)
    assert "+1.0986" in texts and "cells are unsure" in texts
    assert any("image/png" in o.get("data", {}) for o in outputs)


def test_notebook_runs_again(handouts: Handouts) -> None:
    path = handouts.folder / "student/python.ipynb"
    notebook = READ(path, as_version=4)
    run_notebook(notebook, ROOT)


def test_notebook_that_fails_fails_the_build() -> None:
    notebook = make_notebook("t", "s", [Program("x", "h", "1 / 0")])
    with pytest.raises(CellExecutionError, match="ZeroDivisionError"):
        run_notebook(notebook, ROOT)


def test_notebook_pictures_are_attached(handouts: Handouts) -> None:
    path = handouts.folder / "student/python.ipynb"
    for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
        asked = re.findall(r"\(attachment:([^)]*)\)", "".join(cell["source"]))
        assert sorted(asked) == sorted(cell.get("attachments", {}))


def test_script_runs_in_octave(handouts: Handouts, tmp_path: Path) -> None:
    """Beside the folders matlab and scenarios, as it lies in the zip."""
    path = tmp_path / "matlab_handout.m"
    path.write_bytes(
        (handouts.folder / "student/matlab_handout.m").read_bytes()
    )
    for name in ("matlab", "scenarios"):
        (tmp_path / name).symlink_to(ROOT / name)
    octave = needs("octave", "octave-cli")
    done = run_script(octave, path)
    assert done.returncode == 0, done.stderr
    assert "+1.0986" in done.stdout and "cells are unsure" in done.stdout


def test_script_that_fails_is_noticed(tmp_path: Path) -> None:
    octave = needs("octave", "octave-cli")
    script = tmp_path / "failing.m"
    text = script_text("t", "s", [Program("x", "h", "error('no');")])
    script.write_text(text)
    assert run_script(octave, script).returncode != 0


def run_script(octave: str, path: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [octave, "--norc", "--no-history", "--quiet", str(path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "DISPLAY": ""},
    )


def test_script_has_sections_and_short_lines(handouts: Handouts) -> None:
    path = handouts.folder / "student/matlab_handout.m"
    lines = path.read_text(encoding="utf-8").splitlines()
    assert sum(line.startswith("%% ") for line in lines) > 30
    for line in lines:
        if not line.startswith("%"):
            assert len(line) <= 79
    # a section break of a publisher would end the comment that it stands in
    assert not [line for line in lines if line.startswith("%%%")]


def test_wolfram_notebook_is_one_expression(handouts: Handouts) -> None:
    path = handouts.folder / "student/mathematica.nb"
    text = path.read_text(encoding="ascii")
    check_expression(text, "Notebook")
    styles = set(re.findall(r'\], "(\w+)"\]', text))
    styles |= set(re.findall(r'", "(\w+)"\]', text))
    expected = {"Title", "Section", "Subsection", "Text", "Item", "Input"}
    assert expected | {"DisplayFormulaNumbered", "Program"} <= styles


def test_wolfram_notebook_is_read_by_an_interpreter(
    handouts: Handouts, tmp_path: Path
) -> None:
    path = handouts.folder / "student/mathematica.nb"
    needs("woxi", wolfram_command()[0])
    script = tmp_path / "read.wls"
    text = path.read_text(encoding="ascii")
    expression = text[text.index("Notebook[") :].strip()
    script.write_text(
        f"notebook = {expression};\n"
        'Print[Head[notebook], " ", Length[First[notebook]], " ",\n'
        "  Union[Map[Head, First[notebook]]]];\n"
    )
    done = subprocess.run(
        [*wolfram_command(), str(script)],
        capture_output=True,
        text=True,
        timeout=120,
    )
    cells = text.count("\n\nCell[")
    assert done.stdout.strip() == f"Notebook {cells} {{Cell}}"


def test_wolfram_programs_run(tmp_path: Path) -> None:
    """The input cells, but for the first, which needs a front end, and those that take long."""
    needs("woxi", wolfram_command()[0])
    lines = ['Get["mathematica/OccupancyGrid.wl"];']
    for name in ("world_to_grid", "log_odds", "one_beam"):
        program = ROOT / f"handouts/programs/mathematica/{name}.wl"
        lines.append(program.read_text(encoding="utf-8"))
    script = tmp_path / "programs.wls"
    script.write_text("\n".join(lines))
    done = subprocess.run(
        [*wolfram_command(), str(script)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert "::" not in done.stdout
    assert "{110, 90}" in done.stdout
    assert "1.09861228866810" in done.stdout.split("\n{", 1)[1]


def test_setup_of_the_wolfram_notebook_is_balanced() -> None:
    text = notebook_expression("t", "s", [Heading(1, "h"), Command("c")])
    check_expression(text, "Notebook")
    check_expression(f"List[{SETUP}]".replace(";]", "]"), "List")
