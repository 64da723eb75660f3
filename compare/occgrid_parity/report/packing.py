"""Arrays as text inside a page."""

from __future__ import annotations

import base64
import zlib

import numpy as np
from numpy.typing import NDArray


def pack(data: bytes) -> str:
    """Bytes, deflated (RFC 1950), in base 64."""
    return base64.b64encode(zlib.compress(data, 9)).decode("ascii")


def pack_frames(pictures: NDArray[np.uint8]) -> str:
    """Pictures (frames, height, width), each as its difference from the one before.

    A scan changes few cells, so that the differences are nearly all zero.
    """
    before = np.concatenate([np.zeros_like(pictures[:1]), pictures[:-1]])
    return pack((pictures ^ before).tobytes())


def pack_log_odds(log_odds: NDArray[np.float64]) -> str:
    """Log-odds (height, width), the smallest y first, as little-endian doubles."""
    return pack(np.ascontiguousarray(log_odds, dtype="<f8").tobytes())
