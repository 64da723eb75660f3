"""A campaign: what scenarios see, what they do not see, and what ends by its time limit."""

from __future__ import annotations

import ast
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from occgrid_mutants import port_modules
from occgrid_mutants.calls import Calls
from occgrid_mutants.campaign import Campaign, Result
from occgrid_mutants.report import summary, write
from occgrid_mutants.sites import sites
from occgrid_mutants.trials import Trial

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
    write(tmp_path, results, 9, 60.0)
    text = (tmp_path / "report.md").read_text("utf-8")
    assert "a sample of 3 of 9, 1 minutes" in text
    assert "`self.in_bounds(gx, gy)` -> `False`" in text
    assert "seen by scenarios: 1 (33.3 %)" in summary(results, 9, 60.0)


def test_no_change_is_there_twice() -> None:
    for module, path in port_modules.sources(ROOT).items():
        if module in port_modules.CHANGED:
            found = sites(module, ast.parse(path.read_text("utf-8")))
            places = [(s.name, s.line, s.lines, s.kind) for s in found]
            assert len(places) > len(set(places)) * 0.9


def test_calls_are_asked_again(campaign: Campaign) -> None:
    """A change that no call can tell is spared the scenarios; any other is not."""
    calls = Calls()
    with port_modules.loaded(campaign.code) as modules:
        module: Any = modules["portable_math"]
        with calls.recorded(module):
            module.log(np.array([0.25, 0.75]))
            module.sin(0.5)
        assert {name for name, _ in calls.seen} >= {"log", "sin"}
        assert calls.alike(module)
        right = module.sin
        for wrong in (
            lambda x: np.nextafter(right(x), 2.0),  # another bit
            lambda x: np.array([float(right(x))]),  # another shape
        ):
            module.sin = wrong
            assert not calls.alike(module)
        module.sin = right
        logarithm = module.log

        def in_place(x: Any) -> Any:
            answer = logarithm(x)
            x += 1.0
            return answer

        def in_its_argument(x: Any) -> Any:
            x[...] = logarithm(x)
            return x

        for wrong_log in (in_place, in_its_argument):
            module.log = wrong_log
            assert not calls.alike(module)
