"""The figures, drawn from the suite's own runs as SVG that is the same at every build."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from occgrid.grid import logit, sigmoid
from occgrid.lesson import lesson_poses, lesson_settings, lesson_world
from occgrid_handouts.lesson_run import LessonRun
from occgrid_handouts.one_beam import OneBeam
from occgrid_handouts.sensor_designs import ClampStory, Design
from occgrid_handouts.story import Story

Array = npt.NDArray[np.float64]

INK, BLUE, ORANGE, GREY = "#222222", "#1f5fa8", "#c4500a", "#8a8a8a"
OUTSIDE = "#f7e6c4"
FREE, OCCUPIED = "#cfe3f7", "#c4500a"
SETTINGS: dict[Any, Any] = {
    "svg.hashsalt": "occgrid",  # names inside the SVG, otherwise random
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.edgecolor": INK,
    "axes.linewidth": 0.7,
    "savefig.dpi": 220,
}


def draw_figures(
    folder: Path,
    run: LessonRun,
    beam: OneBeam,
    clamp: ClampStory,
    made: list[Design],
    story: Story,
) -> None:
    """Writes every figure into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for scans, log_odds in run.snapshots.items():
        with _figure(folder / f"map-{scans}.svg", 3.2, 2.9) as axes:
            _map(axes, sigmoid(log_odds))
            _trail(axes, scans)
    with _figure(folder / "model.svg", 5.2, 2.4) as axes:
        _model(axes)
    with _figure(folder / "sigmoid.svg", 5.2, 2.6) as axes:
        _sigmoid(axes)
    with _figure(folder / "room.svg", 5.2, 3.8) as axes:
        _room(axes)
    with _figure(folder / "one-beam.svg", 5.2, 3.4) as axes:
        _one_beam(axes, beam)
    with _figure(folder / "clamp.svg", 5.2, 3.0) as axes:
        _clamp(axes, clamp)
    for design in made:
        for scans, probability in design.probability.items():
            name = f"design-{design.p_occ:g}-{scans}.svg"
            with _figure(folder / name, 3.2, 2.9) as axes:
                _map(axes, probability)
    with _figure(folder / "differences.svg", 5.2, 4.2) as axes:
        _differences(axes, sigmoid(run.snapshots[120]), story)


@contextmanager
def _figure(path: Path, width: float, height: float) -> Iterator[Axes]:
    """Axes of a figure in inches, which is written at the end, without a date."""
    with mpl.rc_context(SETTINGS):
        figure = Figure(figsize=(width, height), layout="constrained")
        yield figure.subplots()
        figure.savefig(path, format="svg", metadata={"Date": None})


def _signed(value: float) -> str:
    """A number with its sign, as it is printed in the text."""
    return f"{value:+.2f}".replace("-", "\N{MINUS SIGN}")


def _extent() -> tuple[float, float, float, float]:
    s = lesson_settings()
    right = s.origin_x + s.width * s.resolution
    top = s.origin_y + s.height * s.resolution
    return s.origin_x, right, s.origin_y, top


def _map(axes: Axes, probability: Array) -> None:
    """A map in greys, white where it is free, axes in metres."""
    axes.imshow(
        1.0 - probability,
        cmap="gray",
        vmin=0.0,
        vmax=1.0,
        origin="lower",
        extent=_extent(),
        interpolation="nearest",
    )
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_xticks([-10, -5, 0, 5, 10])
    axes.set_yticks([-8, -4, 0, 4, 8])


def _trail(axes: Axes, scans: int) -> None:
    """The poses of the first scans."""
    x, y, _ = zip(*lesson_poses()[:scans], strict=True)
    axes.plot(x, y, ".", color=ORANGE, markersize=2.5)
    _, right, bottom, top = _extent()
    axes.set_facecolor(OUTSIDE)
    axes.set_xlim(-12.5, right)
    axes.set_ylim(bottom, top)


def _model(axes: Axes) -> None:
    """The piecewise inverse model: P(occupied) of a cell over its distance along the beam."""
    settings = lesson_settings()
    z, alpha, far = 6.0, 1.0, 9.0
    levels = (
        (0.0, z - alpha / 2.0, settings.p_free, BLUE),
        (z - alpha / 2.0, z + alpha / 2.0, settings.p_occ, OCCUPIED),
        (z + alpha / 2.0, far, settings.p0, GREY),
    )
    for begin, end, p, color in levels:
        axes.plot([begin, end], [p, p], color=color, lw=2.4)
    for x, low, high in (
        (z - alpha / 2.0, settings.p_free, settings.p_occ),
        (z + alpha / 2.0, settings.p0, settings.p_occ),
    ):
        axes.plot([x, x], [low, high], color=INK, lw=0.8, ls=":")
    axes.plot([z, z], [0.0, settings.p_occ], color=INK, lw=0.8, ls="--")
    axes.annotate(
        "",
        (z - alpha / 2.0, 0.88),
        (z + alpha / 2.0, 0.88),
        arrowprops={"arrowstyle": "<->", "color": INK, "lw": 0.8},
    )
    axes.text(z, 0.90, r"$\alpha$", ha="center", va="bottom")
    axes.set_xlim(0.0, far)
    axes.set_ylim(0.0, 1.05)
    axes.set_xticks([0.0, z], ["0", r"$z$"])
    axes.set_yticks(
        [0.0, settings.p_free, settings.p0, settings.p_occ, 1.0],
        ["0", r"$p_{free}$", r"$p_0$", r"$p_{occ}$", "1"],
    )
    axes.set_xlabel(r"distance $d$ along the beam")
    axes.set_ylabel("P(occupied)")


def _sigmoid(axes: Axes) -> None:
    """The way back from log-odds to probability, with the lesson's two answers of the sensor on it."""
    settings = lesson_settings()
    x = np.linspace(-5.0, 5.0, 401)
    axes.axhline(0.5, color=GREY, lw=0.6, ls=":")
    axes.axvline(0.0, color=GREY, lw=0.6, ls=":")
    axes.plot(x, sigmoid(x), color=INK, lw=1.6)
    # each label on the side where no line is
    for p, name, color, side in (
        (settings.p_free, "p_{free}", BLUE, -1),
        (settings.p_occ, "p_{occ}", OCCUPIED, 1),
    ):
        at = logit(p)
        axes.plot([at, at], [0.0, p], color=color, lw=1.0, ls="--")
        axes.plot([-5.0, at], [p, p], color=color, lw=1.0, ls="--")
        axes.plot([at], [p], "o", color=color, markersize=6)
        axes.text(
            at + side * 0.2,
            p - side * 0.02,
            f"${name}$ = {p:g}\nlog-odds {_signed(at)}",
            ha="left" if side > 0 else "right",
            va="top" if side > 0 else "bottom",
            color=color,
        )
    axes.set_xlim(-5.0, 5.0)
    axes.set_ylim(0.0, 1.0)
    axes.set_xlabel("log-odds")
    axes.set_ylabel("probability")


def _room(axes: Axes) -> None:
    """The lesson's walls, the poses on the ellipse, and the edge of the grid."""
    left, right, bottom, top = _extent()
    axes.add_patch(
        Rectangle(
            (left, bottom),
            right - left,
            top - bottom,
            facecolor="white",
            edgecolor=GREY,
            lw=0.8,
            ls="--",
        )
    )
    axes.set_facecolor(OUTSIDE)
    for wall in lesson_world():
        axes.plot([wall.x0, wall.x1], [wall.y0, wall.y1], color=INK, lw=2.0)
    x, y, theta = map(np.array, zip(*lesson_poses(), strict=True))
    axes.plot(x, y, ".", color=ORANGE, markersize=3.0)
    every = slice(None, None, 15)
    axes.quiver(
        x[every],
        y[every],
        np.cos(theta[every]),
        np.sin(theta[every]),
        color=ORANGE,
        width=0.005,
        scale=18.0,
    )
    axes.set_xlim(-12.8, right + 0.6)
    axes.set_ylim(bottom - 0.6, top + 0.6)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _one_beam(axes: Axes, beam: OneBeam) -> None:
    """The beam over the grid, its cells coloured and numbered."""
    spec = beam.grid.spec
    for k, (gx, gy) in enumerate(beam.cells):
        last = beam.hit and k == len(beam.cells) - 1
        axes.add_patch(
            Rectangle((gx, gy), 1, 1, color=OCCUPIED if last else FREE, lw=0)
        )
        value = beam.grid.log_odds[gy, gx]
        # a beam that passes through the upper part of a cell leaves only the lower one for labels
        slope = (beam.ey - beam.y) / (beam.ex - beam.x)
        height = beam.y + (gx + 0.5 - beam.x) * slope - gy
        labels = (
            (0.06, 0.34 if height > 0.75 else 0.74, f"k = {k}", "left", INK),
            (0.95, 0.07, _signed(value), "right", BLUE),
        )
        for x, y, text, side, color in labels:
            axes.text(
                gx + x,
                gy + y,
                text,
                ha=side,
                va="bottom",
                fontsize=9,
                color="white" if last else color,
            )
    axes.plot([beam.x, beam.ex], [beam.y, beam.ey], color=INK, lw=1.4)
    axes.plot([beam.x], [beam.y], "o", color=INK, markersize=6)
    axes.plot([beam.ex], [beam.ey], "s", color=INK, markersize=5)
    axes.set_xlim(0, spec.width)
    axes.set_ylim(0, spec.height)
    axes.set_aspect("equal")
    axes.set_xticks(
        np.arange(spec.width) + 0.5, list(map(str, range(spec.width)))
    )
    axes.set_yticks(
        np.arange(spec.height) + 0.5, list(map(str, range(spec.height)))
    )
    axes.set_xticks(range(spec.width + 1), minor=True)
    axes.set_yticks(range(spec.height + 1), minor=True)
    axes.grid(which="minor", color=GREY, lw=0.6)
    axes.tick_params(which="both", length=0)
    axes.set_xlabel("column $g_x$")
    axes.set_ylabel("row $g_y$")


def _clamp(axes: Axes, clamp: ClampStory) -> None:
    """Log-odds of one cell after each scan, with and without the clamp."""
    settings = lesson_settings()
    scans = np.arange(1, clamp.clamped.size + 1)
    axes.axhspan(settings.l_min, settings.l_max, color="#f1f1ee", zorder=0)
    for bound in (settings.l_min, settings.l_max):
        axes.axhline(bound, color=GREY, lw=0.8)
    axes.axhline(0.0, color=GREY, lw=0.6, ls=":")
    axes.step(
        scans,
        clamp.unclamped,
        where="post",
        color=ORANGE,
        lw=1.3,
        ls=(0, (4, 2)),
        label="without the clamp",
    )
    axes.step(
        scans,
        clamp.clamped,
        where="post",
        color=BLUE,
        lw=1.8,
        label="clamped, as in the ports",
    )
    axes.set_xlim(1, scans[-1])
    axes.set_xlabel("scan")
    axes.set_ylabel("log-odds")
    axes.legend(frameon=False, loc="best")


def _differences(axes: Axes, probability: Array, story: Story) -> None:
    """The final map with the cells that one program or another draws otherwise."""
    _map(axes, 0.3 * probability)
    settings = lesson_settings()
    bits = story.bits_differ & ~story.seen_to_differ
    for cells, color, marker, label in (
        (bits, BLUE, ".", "in bits, not visibly"),
        (story.seen_to_differ, ORANGE, "s", "visibly"),
    ):
        gy, gx = np.nonzero(cells)
        axes.plot(
            settings.origin_x + (gx + 0.5) * settings.resolution,
            settings.origin_y + (gy + 0.5) * settings.resolution,
            marker,
            color=color,
            markersize=3.2,
            label=f"{label}: {int(cells.sum())} cells",
        )
    for wall in lesson_world():
        axes.plot([wall.x0, wall.x1], [wall.y0, wall.y1], color=INK, lw=0.5)
    axes.legend(
        loc="upper center",
        bbox_to_anchor=(0.5, 1.12),
        ncols=2,
        markerscale=2.0,
        frameon=False,
    )
