"""Turns what the search found into the record: cell, values, endpoint, drawing, command."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from occgrid_parity.compare.cell_values import CellValue, cell_value
from occgrid_parity.explain.cell_drawing import Cell, draw_patch
from occgrid_parity.explain.closeness import Compared
from occgrid_parity.explain.difference_search import Found, Trial
from occgrid_parity.explain.findings import BeamCell, Endpoint, FirstDifference
from occgrid_parity.model.array_types import Array, Mask
from occgrid_parity.model.line_cells import contract_lines
from occgrid_parity.model.mapper_steps import Drawn
from occgrid_parity.model.reference import reference_map
from occgrid_parity.model.rounding import Beams, beams_of
from occgrid_parity.model.worlds import World, world_of
from occgrid_parity.programs.observed_map import Observed
from occgrid_parity.suite.cases import Case
from occgrid_parity.suite.modes import Mode

LISTED_CELLS = 400


class BeamView:
    """The contract's beams of a scenario, one at a time."""

    def __init__(self, case: Case, mode: Mode) -> None:
        self.world: World = world_of(case)
        self.beams: Beams = beams_of(
            self.world, mode.seed, own_poses=not case.is_file
        )
        self.ways = self.beams.ways
        self.contract = np.flatnonzero(self.ways.contract)  # one for each beam
        scans = np.arange(len(self.world.scans) + 1)
        self.first = np.searchsorted(self.beams.scan, scans)

    def index(self, scan: int, beam: int) -> int:
        """The beam's place among the beams of all scans."""
        return int(self.first[scan]) + beam

    def cells(self, index: int) -> dict[Cell, str]:
        """The cells that the beam updates, in order, inside the grid or not."""
        way = int(self.contract[index])
        if not self.ways.used[way]:
            return {}
        w = self.ways
        lines = contract_lines(
            *(a[way : way + 1] for a in (w.gx0, w.gy0, w.gx1, w.gy1))
        )
        pairs = zip(lines.gx.tolist(), lines.gy.tolist(), strict=True)
        cells = dict.fromkeys(pairs, "free")
        if w.hit[way]:
            cells[next(reversed(cells))] = "occupied"
        return cells

    def robot(self, scan: int) -> Cell:
        """The robot's cell."""
        s = self.world.settings
        one = self.world.scans[scan]
        x, y = one[0][:2] if isinstance(one[0], tuple) else one[:2]
        return (
            math.floor((x - s.origin_x) / s.resolution),
            math.floor((y - s.origin_y) / s.resolution),
        )

    def endpoint(self, index: int) -> Endpoint:
        """Where the beam ends."""
        b = self.beams
        x, y = float(b.ex[index]), float(b.ey[index])
        return Endpoint(
            f"{x:.17g}",
            f"{y:.17g}",
            x.hex(),
            y.hex(),
            f"{float(b.z[index]):.17g}",
            bool(b.hit[index]),
            float(b.edge[index]),
            float(b.error[index]),
        )

    def touches(self, scan: int, wrong: Mask) -> bool:
        """Whether a beam of a scan updates one of the wrong cells."""
        height, width = wrong.shape
        first, end = int(self.first[scan]), int(self.first[scan + 1])
        way = self.contract[first:end]
        way = way[self.ways.used[way]]
        w = self.ways
        lines = contract_lines(w.gx0[way], w.gy0[way], w.gx1[way], w.gy1[way])
        inside = (lines.gx >= 0) & (lines.gx < width)
        inside &= (lines.gy >= 0) & (lines.gy < height)
        return bool(wrong[lines.gy[inside], lines.gx[inside]].any())

    def touching(self, scan: int, wrong: Mask) -> list[int]:
        """The beams of a scan that update one of the wrong cells."""
        height, width = wrong.shape
        beams = int(self.first[scan + 1] - self.first[scan])
        found = []
        for beam in range(beams):
            cells = self.cells(self.index(scan, beam))
            if any(
                0 <= x < width and 0 <= y < height and wrong[y, x]
                for x, y in cells
            ):
                found.append(beam)
        return found


class TouchingBeams:
    """Guesses the scan and the beam of a difference: the first that updates a wrong cell."""

    def __init__(self, view: BeamView) -> None:
        self.view = view

    def scan(self, trial: Trial) -> int:
        """The first scan with a beam that updates a wrong cell; 0 where there is none."""
        wrong = _wrong(trial)
        scans = range(len(self.view.world.scans))
        touching = (s for s in scans if self.view.touches(s, wrong))
        return next(touching, 0)

    def beam(self, scan: int, trial: Trial) -> int:
        """The first such beam of a scan; 0 where there is none."""
        return next(iter(self.view.touching(scan, _wrong(trial))), 0)


def report_found(
    view: BeamView, case: Case, mode: Mode, found: Found, runs: int
) -> FirstDifference:
    """The record of a difference that running has found; ``view`` is of the whole scenario."""
    wrong = _wrong(found.trial)
    undetermined = [f"the beam: {found.why}"] if found.why else []
    if found.beam is None:
        candidates = view.touching(found.scan, wrong)
        shown = (
            view.cells(view.index(found.scan, candidates[0]))
            if candidates
            else {}
        )
        cell = _cell(shown, wrong)
        drawn = reference_map(found.trial.case, mode)
        return FirstDifference(
            case.name, mode.name, "runs", runs, found.scan, None, *cell,
            _value(found.trial.observed, cell), _expected(drawn, cell),
            candidates=candidates, undetermined=undetermined,
        )  # fmt: skip
    index = view.index(found.scan, found.beam)
    expected = view.cells(index)
    cell = _cell(expected, wrong)
    drawn = reference_map(found.trial.case, mode)
    theirs = _changed(found, mode)
    settings = view.world.settings
    patch = draw_patch(
        expected,
        theirs,
        {(int(x), int(y)) for y, x in np.argwhere(wrong)},
        cell,
        view.robot(found.scan),
        (settings.width, settings.height),
    )
    return FirstDifference(
        scenario=case.name,
        mode=mode.name,
        how="runs",
        runs=runs,
        scan=found.scan,
        beam=found.beam,
        gx=cell[0],
        gy=cell[1],
        found=_value(found.trial.observed, cell),
        expected=_expected(drawn, cell),
        endpoint=view.endpoint(index),
        expected_cells=_listed(expected),
        found_cells=_listed(theirs),
        patch=patch,
        undetermined=undetermined,
    )


def report_deduced(
    case: Case, mode: Mode, observed: Observed, compared: Compared
) -> FirstDifference | None:
    """What a finished map alone tells: the earliest beam that updates a wrong cell."""
    wrong = (
        compared.unexplained if compared.unexplained.any() else compared.wrong
    )
    if not wrong.any():
        return None
    view = BeamView(case, mode)
    drawn = reference_map(case, mode)
    undetermined = [
        "the program maps only what is built into it, so nothing was run again: the mistake is in this beam or in a "
        "later one that updates a wrong cell"
    ]
    for scan in range(len(view.world.scans)):
        if not view.touches(scan, wrong):
            continue
        touching = view.touching(scan, wrong)
        index = view.index(scan, touching[0])
        expected = view.cells(index)
        cell = _cell(expected, wrong)
        return FirstDifference(
            case.name, mode.name, "deduced", 0, scan, touching[0], *cell,
            _value(observed, cell), _expected(drawn, cell),
            endpoint=view.endpoint(index), expected_cells=_listed(expected),
            undetermined=undetermined,
        )  # fmt: skip
    cell = _cell({}, wrong)
    return FirstDifference(
        case.name, mode.name, "deduced", 0, None, None, *cell,
        _value(observed, cell), _expected(drawn, cell),
        undetermined=["scan and beam: no beam of the reference updates a cell that is wrong"],
    )  # fmt: skip


def _wrong(trial: Trial) -> Mask:
    compared = trial.compared
    return (
        compared.unexplained if compared.unexplained.any() else compared.wrong
    )


def _cell(cells: Mapping[Cell, str], wrong: Mask) -> Cell:
    """The first of the cells that is wrong, else the first wrong cell of the map."""
    height, width = wrong.shape
    for gx, gy in cells:
        if 0 <= gx < width and 0 <= gy < height and wrong[gy, gx]:
            return gx, gy
    gy, gx = np.argwhere(wrong)[0].tolist()
    return gx, gy


def _changed(found: Found, mode: Mode) -> dict[Cell, str]:
    """The cells that the program's beam has changed: up is occupied, down is free."""
    after = _levels(found.trial.observed)
    if found.before is not None and not found.single:
        before = _levels(found.before.observed)
    else:
        settings = world_of(found.trial.case).settings
        start = settings.new_grid().log_odds
        if found.trial.observed.log_odds is None:
            start = -np.floor(
                (1.0 - settings.new_grid().probability_grid()) * 255.0 + 0.5
            )
        before = start
    changed = {}
    for gy, gx in np.argwhere(after != before).tolist():
        changed[gx, gy] = (
            "occupied" if after[gy, gx] > before[gy, gx] else "free"
        )
    return changed


def _levels(observed: Observed) -> Array:
    """What grows as a cell becomes occupied: log-odds, or darkness; smallest y first."""
    if observed.log_odds is not None:
        return observed.log_odds
    return -observed.pixels[::-1].astype(np.float64)


def _value(observed: Observed, cell: Cell) -> CellValue:
    gx, gy = cell
    pixel = int(observed.pixels[::-1][gy, gx])
    if observed.log_odds is None:
        return CellValue(pixel)
    return cell_value(pixel, float(observed.log_odds[gy, gx]))


def _expected(drawn: Drawn, cell: Cell) -> CellValue:
    gx, gy = cell
    return cell_value(
        int(drawn.pixels[::-1][gy, gx]), float(drawn.log_odds[gy, gx])
    )


def _listed(cells: Mapping[Cell, str]) -> list[BeamCell]:
    return [
        BeamCell(gx, gy, kind)
        for (gx, gy), kind in list(cells.items())[:LISTED_CELLS]
    ]
