"""Loading a map as ROS does: by the published rules of map_server and Nav2, and with yaml-cpp, as they do."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np

from occgrid.grid import GridSpec


def load_map(loader: Path, yaml: Path) -> tuple[GridSpec, np.ndarray]:
    """The map as ROS has it: 100 occupied, 0 free, -1 unknown; (height, width), the smallest y first.

    ``loader`` is the program that the fixture ``map_loader`` builds.
    """
    text = subprocess.run(
        [str(loader), str(yaml)], capture_output=True, text=True, check=True
    ).stdout.split()
    width, height = int(text[0]), int(text[1])
    resolution, x, y, yaw = map(float, text[2:6])
    assert yaw == 0.0
    cells = np.array(text[6:], dtype=np.int64).reshape(height, width)
    return GridSpec(width, height, resolution, x, y), cells
