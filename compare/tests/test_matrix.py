"""The parity matrix: every port, every scenario, both modes, fast and plain, every bit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from occgrid_parity.compare.mapping import left_out
from occgrid_parity.compare.matrix_run import Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.formats.map_files import SUFFIXES
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.report.run_table import explain_result
from occgrid_parity.suite.modes import PORT_MODES
from occgrid_parity.suite.scenarios import BUILT_IN_NAME, choose_scenarios

from .conftest import JOBS, PORTS, ROOT

SCENARIOS = choose_scenarios(ROOT, [])


@pytest.fixture(scope="session")
def matrix(
    root: Path,
    built: dict[str, Built],
    tmp_path_factory: pytest.TempPathFactory,
) -> RunRecord:
    """The run of all ports over all scenarios in both modes."""
    plan = Plan(
        ports=PORTS,
        scenarios=SCENARIOS,
        modes=PORT_MODES,
        folder=tmp_path_factory.mktemp("matrix"),
        golden=root / "scenarios" / "golden",
        jobs=JOBS,
        built=list(built.values()),
    )
    return run(plan)


CASES = [
    pytest.param(port.name, scenario.name, mode.name)
    for port in PORTS
    for scenario in SCENARIOS
    for mode in PORT_MODES
    if left_out(port, scenario, mode) is None
]


@pytest.mark.parametrize(("port", "scenario", "mode"), CASES)
def test_map(
    matrix: RunRecord,
    need: Callable[[str], Port],
    port: str,
    scenario: str,
    mode: str,
) -> None:
    need(port)
    result = matrix.result(port, scenario, mode)
    if result.status != "identical":
        pytest.fail("\n".join(explain_result(result)), pytrace=False)
    assert "golden" in result.compared_with
    assert "python" in [port, *result.compared_with]


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_writes_its_files_and_no_other(
    matrix: RunRecord, need: Callable[[str], Port], port: str
) -> None:
    need(port)
    maps = {scenario.name: scenario.map for scenario in SCENARIOS}
    for process in matrix.processes:
        if process.port == port:
            folder = Path(matrix.folder) / process.folder
            found = sorted(path.name for path in folder.iterdir())
            names = [maps[scenario] for scenario in process.scenarios]
            assert found == sorted(n + s for n in names for s in SUFFIXES)


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_tells_its_version(
    built: dict[str, Built], need: Callable[[str], Port], port: str
) -> None:
    need(port)
    assert str(built[port].version).startswith("occgrid ")


@pytest.mark.parametrize("port", [port.name for port in PORTS])
def test_maps_the_lesson_by_its_plain_program(port: str) -> None:
    """What a slow port leaves out is never all there is of a scenario or of its plain program."""
    chosen = {p.name: p for p in PORTS}[port]
    kept = [
        (scenario.name, mode.name)
        for scenario in SCENARIOS
        for mode in PORT_MODES
        if left_out(chosen, scenario, mode) is None
    ]
    assert (BUILT_IN_NAME, "noise-free-plain") in kept
    assert {name for name, mode in kept if not mode.endswith("plain")} == {
        scenario.name for scenario in SCENARIOS
    }
