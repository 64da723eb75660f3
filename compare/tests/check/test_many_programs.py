"""Programs in five languages, right ones and ones with one mistake each: what they lose, what is seen, which cause is named.

No wrong program passes, no right one loses a point, and no cause is named that is not the mistake.
"""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import pytest

from occgrid_parity.check import levels
from occgrid_parity.check.verdict import Verdict
from occgrid_parity.suite.cases import LESSON, TWIN

from ..check_helpers import PROGRAMS, check_words, names
from ..conftest import unavailable


class Program(NamedTuple):
    """A program, what it must lose, and what must be said.

    ``lost`` are its levels without a point. ``causes`` are those named; empty: none is. ``seen`` is a part of an observation
    or of a note.
    """

    words: str
    lost: set[str]
    causes: set[str] = set()  # noqa: RUF012
    seen: str = ""


SIMULATED = {"simulated", "mixed", "noise", "mixed-noise"}
RECORDED = {"recorded", "mixed", "mixed-noise"}
