"""The lesson's picture: P(occupied) in colour, a colour bar, axes in metres (lesson section 6.1).

It needs matplotlib, which the package's extra ``plot`` brings.
"""

from __future__ import annotations

from pathlib import Path

from matplotlib.figure import Figure

from occgrid.grid import OccupancyGrid


def file_kinds() -> list[str]:
    """The endings of file names, without a dot, that draw_map knows."""
    return sorted(Figure().canvas.get_supported_filetypes())


def draw_map(grid: OccupancyGrid, file: str | Path) -> None:
    """Draw the map into a file; its ending (.png, .pdf, .svg) says which kind.

    Raises OSError where it cannot be written and ValueError for an ending that matplotlib does not know.
    """
    spec = grid.spec
    extent = (
        spec.origin_x,
        spec.origin_x + spec.width * spec.resolution,
        spec.origin_y,
        spec.origin_y + spec.height * spec.resolution,
    )
    figure = Figure(figsize=(9, 6), layout="tight")
    axes = figure.subplots()
    image = axes.imshow(
        grid.probability_grid(),
        origin="lower",
        extent=extent,
        vmin=0.0,
        vmax=1.0,
    )
    figure.colorbar(image, label="P(occupied)")
    axes.set_title("Occupancy Grid Map (probability)")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    figure.savefig(file, dpi=150)
