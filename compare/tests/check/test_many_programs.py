"""Programs in five languages, right ones and ones with one mistake each: what they lose, what is seen, which cause is named.

No wrong program passes, no right one loses a point, and no cause is named that is not the mistake.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import pytest

from occgrid_parity.check import levels
from occgrid_parity.suite.cases import LESSON, TWIN

from ..check_helpers import PROGRAMS, check_words, names
from ..conftest import unavailable


class Expected(NamedTuple):
    """What a program must lose, and what must be said.

    ``lost`` are its levels without a point; ``causes`` those named, none where it is empty; ``said`` is a part of an
    observation, of a note or of the summary.
    """

    lost: str = ""
    causes: str = ""
    said: str = ""


SIMULATED = "simulated mixed noise mixed-noise"
EVERY = "one-beam octants no-return clamping prior outside simulated recorded mixed powers formats noise mixed-noise"

C = {
    "none": Expected(),
    "prior": Expected("prior", "prior-not-subtracted"),
    "break-outside": Expected("outside", "robot-outside-skipped"),
    "half-step": Expected(
        "no-return outside simulated mixed formats noise mixed-noise",
        "bearings-half-a-step-off",
    ),
    "octant": Expected(
        "octants no-return prior simulated recorded formats noise mixed-noise"
    ),
    "odometry": Expected("mixed mixed-noise", "odometry-for-pose"),
    "ros": Expected(EVERY, said="0, 205 and 254"),
    "flipped": Expected("orientation", "y-flipped y-axis-down"),
    "bare-param": Expected("formats", said="PARAM without a value"),
    "CPLACE": Expected(),
}
del C["CPLACE"]
