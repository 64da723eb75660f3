"""A campaign: what scenarios see, what they do not see, and what ends by its time limit."""

from __future__ import annotations

import ast
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from occgrid_mutants import port_modules
from occgrid_mutants.campaign import Campaign, Result
from occgrid_mutants.port_tests import port_tests
from occgrid_mutants.report import Run, read, summary, write
from occgrid_mutants.sites import sites
from occgrid_mutants.trials import Trial, scenario_trials

ROOT = Path(__file__).resolve().parents[3]


def one_plus_one(modules: dict[str, ModuleType]) -> bool:
    return float(modules["grid"].logit(0.5)) == 0.0


@pytest.fixture
def campaign(monkeypatch: pytest.MonkeyPatch) -> Campaign:
    """With one map in place of all, and no unit trial."""
    monkeypatch.setattr(
        "occgrid_mutants.campaign.scenario_trials",
        lambda root: [Trial("the even one", one_plus_one)],
    )
    monkeypatch.setattr(
        "occgrid_mutants.campaign.unit_trials", lambda root: []
    )
    monkeypatch.setattr(
        "occgrid_mutants.campaign.port_tests",
        lambda root: dict.fromkeys(
            port_modules.CHANGED, Trial("nothing", lambda modules: True)
        ),
    )
    return Campaign(ROOT, lambda text: None)


def test_what_is_seen_and_what_is_not(
    campaign: Campaign, tmp_path: Path
) -> None:
    names = {
        "grid.logit: q / (1.0 - q) -> q * (1.0 - q)": "the even one",
        "grid.logit: max(p, 1e-09) -> max(1e-09, p)": "",
        "grid.logit: statement": "",
        "grid.OccupancyGrid.update_cell: self.in_bounds(gx, gy) -> False": "",
    }
    chosen = [site for site in campaign.sites if site.name in names]
    assert len(chosen) == 3
    results: list[Result] = []
    campaign.run(chosen, 2, results.append)
    assert {r.site.name: r.seen_by for r in results} == {
        site.name: names[site.name] for site in chosen
    }
    reached = {r.site.function: r.reached for r in results}
    assert reached == {"logit": True, "OccupancyGrid.update_cell": False}
    numbers = {id(s): n for n, s in enumerate(campaign.sites)}
    found = {numbers[id(r.site)]: r for r in results}
    write(tmp_path, found, Run("these sources", 9, 60.0))
    text = (tmp_path / "report.md").read_text("utf-8")
    assert "a sample of 3 of 9, 1 minutes" in text
    assert "`self.in_bounds(gx, gy)` -> `False`" in text
    assert "seen by scenarios: 1 (33.3 %)" in summary(results, 9, 60.0)
    # an interrupted run is taken up where it stopped
    assert read(tmp_path, campaign.sites, "these sources") == (found, 60.0)
    with pytest.raises(ValueError, match="the sources have changed"):
        read(tmp_path, campaign.sites, "other sources")
    with pytest.raises(ValueError, match="there is no run to take up"):
        read(tmp_path / "elsewhere", campaign.sites, "these sources")


def test_no_change_is_there_twice() -> None:
    for module, path in port_modules.sources(ROOT).items():
        if module in port_modules.CHANGED:
            found = sites(module, ast.parse(path.read_text("utf-8")))
            places = [(s.name, s.line, s.lines, s.kind) for s in found]
            assert len(places) > len(set(places)) * 0.9


def test_a_map_is_left_where_it_first_differs() -> None:
    """The plain program is stopped after the first scan whose map is another one."""
    (trial,) = (
        trial
        for trial in scenario_trials(ROOT)
        if trial.name == "octants, noise-free, plain"
    )
    with port_modules.loaded(port_modules.compiled(ROOT)) as modules:
        assert trial.right(modules)
        mapper: Any = modules["mapper"]
        update = mapper.update_grid_from_scan
        scans = []

        def wrong_third(grid: Any, scan: Any, *rest: Any) -> None:
            scans.append(scan)
            update(grid, scan, *rest)
            if len(scans) == 3:
                grid.log_odds[0, 0] += 1e-9

        mapper.update_grid_from_scan = wrong_third
        assert not trial.right(modules)
        assert len(scans) == 3
        assert mapper.update_grid_from_scan is wrong_third


@pytest.mark.parametrize("module", ["noise", "sensor"])
def test_the_ports_own_tests_look_at_a_changed_port(module: str) -> None:
    trial = port_tests(ROOT)[module]
    code = port_modules.compiled(ROOT)
    with port_modules.loaded(code) as modules:
        assert trial.right(modules)
    tree = port_modules.parse(port_modules.sources(ROOT)[module])
    change = sites(module, tree)[-1]
    change.change()
    code[module] = compile(tree, f"{module}.py", "exec")
    with port_modules.loaded(code) as modules:
        assert not trial.right(modules)
