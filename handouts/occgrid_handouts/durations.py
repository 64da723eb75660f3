"""How long a build takes: what the last one took, or a guess from the machine's speed."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path

from occgrid_handouts.languages import Language
from occgrid_handouts.machine import slowness

# seconds on an idle desktop computer, where no port has mapped the lesson yet
FOR_ALL = 25.0
FOR_A_LANGUAGE = 12.0


class DurationRecord:
    """The seconds of earlier builds, by the number of their languages, in a file."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def announcement(self, languages: Sequence[Language]) -> str:
        """What to say before the work begins."""
        last = self._read().get(str(len(languages)))
        if last is not None:
            return f"this takes about {_minutes(last)}, as the last time"
        guess = (FOR_ALL + FOR_A_LANGUAGE * len(languages)) * slowness()
        return f"this takes about {_minutes(guess)} on this machine"

    def keep(self, languages: Sequence[Language], seconds: float) -> None:
        """Writes down how long a build took; does nothing where that is not possible."""
        known = self._read() | {str(len(languages)): round(seconds, 1)}
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self.path.write_text(json.dumps(known) + "\n", encoding="ascii")
        except OSError:
            return

    def _read(self) -> dict[str, float]:
        try:
            known = json.loads(self.path.read_text(encoding="ascii"))
        except (OSError, ValueError):
            return {}
        return known if isinstance(known, dict) else {}


def _minutes(seconds: float) -> str:
    minutes = max(1, math.ceil(seconds / 60.0))
    return "one minute" if minutes == 1 else f"{minutes} minutes"
