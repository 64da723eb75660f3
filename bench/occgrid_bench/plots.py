"""Pictures of what was measured."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from statistics import median

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator

from occgrid_bench.contestants import CONTESTANTS, REFERENCE
from occgrid_bench.record import Part, Series
from occgrid_bench.statistics import ratio
from occgrid_bench.tables import times

COLOURS = {
    "port": "#1f6f8b",
    "lesson": "#b0b0b0",
    "floor": "#7a9e3a",
    "peer": "#c8803a",
}
GROUPS = {
    "port": "port of this suite",
    "lesson": "the lesson's algorithm, written plainly",
    "floor": "what no port can do without",
    "peer": "another mapping library",
}
WHITE = {"facecolor": "white", "edgecolor": "none", "pad": 0.5}
PLAIN = FuncFormatter(lambda value, _: f"{value:,g}")
LABELS = {
    "scans": "scans, as a multiple of the lesson's 120",
    "beams": "beams of a scan",
    "resolution": "side of a cell (m)",
    "grid": "side of the grid, as a multiple of the lesson's",
}


def draw(parts: Mapping[str, Part], folder: Path) -> list[Path]:
    """Draw the comparisons and the growth, as far as they were measured."""
    drawn = []
    works = [
        parts[name]
        for name in ("lesson", "open", "log")
        if name in parts and parts[name].find(REFERENCE)
    ]
    if works:
        drawn.append(_draw_comparison(works, folder / "comparison.png"))
    if "growth" in parts:
        drawn.append(_draw_growth(parts["growth"], folder / "growth.png"))
    return drawn


def _draw_comparison(works: list[Part], path: Path) -> Path:
    figure, axes = plt.subplots(
        1,
        len(works),
        figsize=(4 + 4 * len(works), 6),
        sharey=True,
        squeeze=False,
        layout="constrained",
    )
    names = [c for c in CONTESTANTS if any(w.find(c.name) for w in works)]
    for axis, work in zip(axes[0], works, strict=True):
        reference = work.find(REFERENCE)
        assert reference is not None
        for row, contestant in enumerate(names):
            series = work.find(contestant.name)
            if series is None:
                continue
            value = ratio(series.seconds, reference.seconds)
            axis.barh(row, value, color=COLOURS[contestant.group])
            label = axis.text(value * 1.1, row, times(value), va="center")
            label.set(fontsize=8, bbox=WHITE)
        axis.set_xscale("log")
        axis.xaxis.set_major_formatter(PLAIN)
        axis.margins(x=0.2)
        axis.axvline(1.0, color="black", linewidth=0.7, zorder=0)
        axis.set_title(work.title.split(":")[0], fontsize=10)
        axis.set_xlabel("time, lesson's C++ = 1")
    axes[0][0].set_yticks(range(len(names)), [c.title for c in names])
    axes[0][0].invert_yaxis()
    patches = [Patch(color=COLOURS[g], label=t) for g, t in GROUPS.items()]
    figure.legend(handles=patches, loc="outside lower center", ncols=4)
    figure.savefig(path, dpi=130)
    plt.close(figure)
    return path


def _draw_growth(part: Part, path: Path) -> Path:
    groups: dict[str, dict[str, list[Series]]] = {}
    for series in part.series:
        if series.seconds:
            axis, _ = series.name.split("/")
            ports = groups.setdefault(axis, {})
            ports.setdefault(series.title, []).append(series)
    figure, axes = plt.subplots(
        2,
        len(groups),
        figsize=(4 * len(groups), 7.5),
        sharey="row",
        squeeze=False,
        layout="constrained",
    )
    for column, (axis, ports) in enumerate(groups.items()):
        above, below = axes[0][column], axes[1][column]
        for title, points in ports.items():
            points.sort(key=lambda s: s.extra["value"])
            x = [s.extra["value"] for s in points]
            above.plot(x, [s.median for s in points], "o-", label=title)
            known = [s for s in points if "peak_mib" in s.extra]
            peaks = [s.extra["peak_mib"] for s in known]
            below.plot([s.extra["value"] for s in known], peaks, "o-")
        _draw_slope(above, list(ports.values()))
        measured = sorted(
            {s.extra["value"] for p in ports.values() for s in p}
        )
        below.set_xlabel(LABELS[axis])
        for one in (above, below):
            one.set_xscale("log")
            one.set_yscale("log")
            one.set_xticks(measured, [f"{value:g}" for value in measured])
            one.xaxis.set_minor_locator(NullLocator())
            one.yaxis.set_major_formatter(PLAIN)
            one.yaxis.set_minor_formatter(NullFormatter())
            one.grid(alpha=0.3)
            if axis == "resolution":
                one.invert_xaxis()
    axes[0][0].set_ylabel("mapping (s)")
    axes[1][0].set_ylabel("peak memory of the command (MiB)")
    lines, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(lines, labels, loc="outside upper center", ncols=len(labels))
    figure.savefig(path, dpi=130)
    plt.close(figure)
    return path


def _draw_slope(axis: Axes, ports: list[list[Series]]) -> None:
    """Where the first port's times would be if they grew as the crossed cells do."""
    points = ports[0]
    each = median(s.median / s.extra["crossed"] for s in points)
    x = [s.extra["value"] for s in points]
    y = [s.extra["crossed"] * each for s in points]
    axis.plot(x, y, "k:", linewidth=0.9, label="as the crossed cells")
