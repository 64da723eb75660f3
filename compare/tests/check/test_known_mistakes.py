"""A mistake's map that has been drawn before is known by its hash; what it says is what drawing it again says."""

from __future__ import annotations

from dataclasses import replace

import pytest

from occgrid_parity.explain import mistaken_maps
from occgrid_parity.explain.mistaken_maps import Evidence, MistakenMaps
from occgrid_parity.mistakes.catalogue import MISTAKES
from occgrid_parity.model.arithmetic import PORTABLE
from occgrid_parity.model.mapper_steps import Mapper
from occgrid_parity.suite.cases import case
from occgrid_parity.suite.modes import NOISE_FREE

from ..check_helpers import MapperRunner

SOME = list(MISTAKES.values())[::9]


@pytest.mark.parametrize("log_odds", [True, False])
def test_twice(log_odds: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mistaken_maps, "DRAWN", {})
    one = case("asymmetric")

    def answers(own: type[Mapper]) -> list[bool]:
        observed = MapperRunner(own).run(one, NOISE_FREE).observed
        assert observed is not None
        if not log_odds:
            observed = replace(observed, log_odds=None)
        evidence = Evidence(one, NOISE_FREE, observed, "differs")
        maps = MistakenMaps()
        return [maps.draws(other, evidence, PORTABLE) for other in SOME]

    first = [answers(own) for own in SOME]
    assert len(mistaken_maps.DRAWN) == len(SOME)
    for number, row in enumerate(first):
        assert row[number]
    assert not all(map(all, first))
    assert [answers(own) for own in SOME] == first
    for known in mistaken_maps.DRAWN:
        drawn = mistaken_maps.DRAWN[known]
        mistaken_maps.DRAWN[known] = drawn._replace(pixels=b"")
    assert not any(map(any, [answers(own) for own in SOME]))
