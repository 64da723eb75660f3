"""The command ``occgrid-parity golden``."""

from __future__ import annotations

from typing import Annotated

import typer

from occgrid.scenario import ScenarioError
from occgrid_parity.commands.console import (
    Root,
    print_plain,
    wide_console,
    wrong_usage,
)
from occgrid_parity.compare.golden_results import (
    changes,
    make_golden,
    strays,
    write_golden,
)
from occgrid_parity.suite.modes import DEFAULT_MODES, Mode
from occgrid_parity.suite.repository import find_root
from occgrid_parity.suite.scenarios import scenario_files


def golden_command(
    write: Annotated[
        bool, typer.Option("--write", help="Write what changed.")
    ] = False,
    root: Root = None,
) -> None:
    """Check the golden results in scenarios/golden, or write them anew."""
    console = wide_console()
    try:
        found = find_root() if root is None else root
    except OSError as error:
        raise wrong_usage(error) from error
    folder = found / "scenarios" / "golden"
    scenarios = scenario_files(found)
    if not scenarios:
        raise wrong_usage(
            ValueError(f"{found / 'scenarios'}: no scenario there")
        )
    wrong = 0
    for scenario in scenarios:
        for mode in DEFAULT_MODES:
            try:
                fresh = make_golden(scenario, mode)
            except ScenarioError as error:
                print_plain(console, str(error))
                raise typer.Exit(1) from error
            said = changes(folder, fresh)
            wrong += bool(said)
            if said and write:
                write_golden(folder, fresh)
            verb = "written: " if said and write else ""
            what = f"{len(fresh.scans)} scans as committed"
            print_plain(
                console,
                f"{_title(scenario.map, mode)}: {verb}{'; '.join(said) or what}",
            )
    for path in strays(folder, scenarios):
        wrong += 1
        if write:
            path.unlink()
        verb = "removed: " if write else ""
        print_plain(console, f"{path.name}: {verb}belongs to no scenario")
    raise typer.Exit(1 if wrong and not write else 0)


def _title(name: str, mode: Mode) -> str:
    return f"{name}, {mode.name}"
