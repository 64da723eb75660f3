"""Real laser logs, which the project does not carry: all ports map them alike.

The folder is OCCGRID_DATA, or shared/data beside the repository. A slow port maps
the first scans only (``log_scans`` in its port.toml): the name of the test says so.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path

import pytest

from occgrid_parity.compare.matrix_run import REFERENCE, Plan, run
from occgrid_parity.compare.run_record import RunRecord
from occgrid_parity.logs.conversion import Request, Selection
from occgrid_parity.logs.making import make_scenario
from occgrid_parity.ports.building import Built
from occgrid_parity.ports.declaration import Port
from occgrid_parity.report.run_table import explain_result
from occgrid_parity.suite.modes import NOISE_FREE
from occgrid_parity.suite.scenarios import scenario_from

from .conftest import JOBS, PORTS, ROOT, unavailable

LOGS = [
    "orebro.gfs.log",
    "intel.gfs.log",
    "freiburg_course_csail.log",
    "fr079_flirt.log",
    "mrpt_localization_demo.carmen.log",
    "mit-csail_odometry.clf",
]
DATA = Path(os.environ.get("OCCGRID_DATA", ROOT.parent / "shared" / "data"))
LIMITS = sorted({port.log_scans or 0 for port in PORTS})


def stem(log: str) -> str:
    return log.split(".")[0]


def scope(limit: int | None) -> str:
    return f"first-{limit}-scans" if limit else "all-scans"


def need_log(log: str) -> Path:
    """The log; skips the test without it.

    Nobody has to have the logs: only where OCCGRID_DATA promises them does one that
    is missing fail under PARITY_REQUIRE_ALL.
    """
    path = DATA / log
    if not path.is_file():
        reason = f"{path}: no such log (OCCGRID_DATA names its folder)"
        if "OCCGRID_DATA" in os.environ:
            unavailable(reason)
        pytest.skip(reason)
    return path


@pytest.fixture(scope="session")
def maps(
    built: dict[str, Built], tmp_path_factory: pytest.TempPathFactory
) -> dict[int, RunRecord]:
    """For each limit of scans: the run of the ports that have it, and of the reference."""
    records = {}
    there = [DATA / log for log in LOGS if (DATA / log).is_file()]
    for limit in LIMITS if there else []:
        folder = tmp_path_factory.mktemp(f"logs-{scope(limit)}")
        scenarios = []
        for log in there:
            scenario = folder / f"{stem(log.name)}.log"
            request = Request(
                log,
                scenario,
                resolution=Decimal("0.1"),
                max_range=Decimal(30),
                selection=Selection(last=limit or None),
            )
            make_scenario(request)
            scenarios.append(scenario_from(scenario))
        ports = [
            p
            for p in PORTS
            if REFERENCE == p.name or (p.log_scans or 0) == limit
        ]
        plan = Plan(
            ports=ports,
            scenarios=scenarios,
            modes=[NOISE_FREE],  # recorded scans get no noise in any mode
            folder=folder / "maps",
            jobs=JOBS,
            built=[built[port.name] for port in ports],
        )
        plan.folder.mkdir()
        records[limit] = run(plan)
    return records


CASES = [
    pytest.param(
        port.name,
        log,
        port.log_scans or 0,
        id=f"{port.name}-{stem(log)}-{scope(port.log_scans)}",
    )
    for port in PORTS
    if port.name != REFERENCE
    for log in LOGS
]


@pytest.mark.parametrize(("port", "log", "limit"), CASES)
def test_maps_the_log_as_the_reference_does(
    maps: dict[int, RunRecord],
    need: Callable[[str], Port],
    port: str,
    log: str,
    limit: int,
) -> None:
    need_log(log)
    need(port)
    result = maps[limit].result(port, stem(log), NOISE_FREE.name)
    if result.status != "identical":
        pytest.fail("\n".join(explain_result(result)), pytrace=False)
    assert result.compared_with == [REFERENCE]
    assert result.width
    assert result.height
    assert result.width * result.height > 50_000 or limit


def test_the_reference_maps_all_logs(maps: dict[int, RunRecord]) -> None:
    for log in LOGS:
        need_log(log)
    for record in maps.values():
        for result in record.results:
            if result.port == REFERENCE:
                assert (result.status, result.reason) == ("identical", "")
