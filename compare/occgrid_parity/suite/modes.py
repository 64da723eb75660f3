"""The two ways to map a scenario: without noise, or with a seed's noise."""

from __future__ import annotations

from dataclasses import dataclass

LARGEST_SEED = 2**32 - 1


@dataclass(frozen=True)
class Mode:
    """Without noise where ``seed`` is None, else with the noise of that seed."""

    seed: int | None

    @property
    def name(self) -> str:
        """``noise-free`` or ``seed-N``."""
        return "noise-free" if self.seed is None else f"seed-{self.seed}"

    @property
    def arguments(self) -> list[str]:
        """The mode on a port's command line: ``--noise-free`` or ``--seed N``."""
        return (
            ["--noise-free"]
            if self.seed is None
            else ["--seed", str(self.seed)]
        )


NOISE_FREE = Mode(None)
DEFAULT_MODES = (NOISE_FREE, Mode(0))


def parse_mode(text: str) -> Mode:
    """The mode of that name. Raises ValueError where it is none."""
    if text == "noise-free":
        return NOISE_FREE
    digits = text.removeprefix("seed-")
    if digits != text and digits.isascii() and digits.isdigit():
        seed = int(digits)
        if seed <= LARGEST_SEED and str(seed) == digits:
            return Mode(seed)
    raise ValueError(
        f"{text!r} is not a mode: noise-free, or seed-N with N from 0 to {LARGEST_SEED}"
    )
