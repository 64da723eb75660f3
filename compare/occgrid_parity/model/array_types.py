"""The arrays of the model: numbers, cells, and which of them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Cells = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]


def index_type(
    cells: int,
) -> type[np.signedinteger] | type[np.unsignedinteger]:
    """The smallest type of integers that numbers so many cells."""
    return np.uint16 if cells <= 1 << 16 else np.int64
