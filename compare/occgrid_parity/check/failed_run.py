"""Keeps a run that drew no map: its scenario, the command that repeats it, and all that it printed."""

from __future__ import annotations

from pathlib import Path

from occgrid_parity.check.program_maps import ProgramMaps
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

SCENARIO = "failing-scenario.log"
PRINTED = "failing-output.txt"


def keep_failed_run(
    maps: ProgramMaps, case: Case, mode: Mode, save: Path | None
) -> None:
    """Writes the files into ``save``, and notes how to see the failure again."""
    if save is None:
        return
    runner = maps.runner
    outcome = maps.run(case, mode)
    save.mkdir(parents=True, exist_ok=True)
    if case.is_file:
        file = save / SCENARIO
        file.write_bytes(case.data)
        command = f"occgrid-parity check {runner.option} --scenario {file} --mode {mode.name}"
        maps.note(
            f"to see the failed run of {case.name}, {mode.name} again: {command}"
        )
    if outcome.printed:
        write_text(save / PRINTED, outcome.printed)
        maps.note(f"all that it printed: {save / PRINTED}")
