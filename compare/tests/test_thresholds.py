"""A cell that nothing touched loads as unknown, whatever the prior (SPEC section 7)."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from occgrid_parity.formats.log_odds import read_log_odds
from occgrid_parity.ports.declaration import Port

from .conftest import ROOT
from .map_loading import load_map
from .port_runs import each_port, run_port

PRIORS = [
    "1e-12", "0.001", "0.01", "0.1", "0.15", "0.3", "0.499", "0.5", "0.501", "0.6", "0.65", "0.7", "0.9", "0.99",
    "0.999", "0.999999999999",
]  # fmt: skip


@each_port
def test_untouched_cells_are_unknown(
    need: Callable[[str], Port],
    tmp_path: Path,
    map_loader: Path,
    name: str,
) -> None:
    text = (ROOT / "scenarios" / "one-beam.log").read_text()
    for p0 in PRIORS:
        values = f"p0 {p0}", "l_min -30", "l_max 30", "p_occ .77", "p_free .29"
        more = "".join(f"PARAM occgrid_{value}\n" for value in values)
        (tmp_path / f"p{p0}.log").write_text(more + text)
    files = [tmp_path / f"p{p0}.log" for p0 in PRIORS]
    finished = run_port(
        need(name), tmp_path, "--noise-free", "--out", "o", *files
    )
    assert (finished.exit_status, finished.stderr.read_text()) == (0, "")
    for p0 in PRIORS:
        log_odds = read_log_odds(tmp_path / "o" / f"p{p0}.logodds")
        _, cells = load_map(map_loader, tmp_path / "o" / f"p{p0}.yaml")
        untouched = log_odds == log_odds[0, 0]
        assert untouched.sum() == 40 - 5
        assert (cells[untouched] == -1).all()


@each_port
def test_even_odds_keep_the_usual_thresholds(
    need: Callable[[str], Port], tmp_path: Path, name: str
) -> None:
    scenario = ROOT / "scenarios" / "one-beam.log"
    finished = run_port(need(name), tmp_path, "--out", "o", scenario)
    assert finished.exit_status == 0
    assert (tmp_path / "o" / "one-beam.yaml").read_text() == (
        "image: one-beam.pgm\nmode: trinary\nresolution: 1.0\n"
        "origin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.196\n"
    )
