"""The ways to map a scenario: without noise or with a seed's, with a port's fast version or its plain one."""

from __future__ import annotations

from dataclasses import dataclass, replace

LARGEST_SEED = 2**32 - 1
PLAIN_SUFFIX = "-plain"


@dataclass(frozen=True)
class Mode:
    """Without noise where ``seed`` is None, else with the noise of that seed.

    ``plain``: by the program as it is printed (``--plain``), and not by its fast version. The map is the same.
    """

    seed: int | None
    plain: bool = False

    @property
    def name(self) -> str:
        """``noise-free`` or ``seed-N``, with ``-plain`` behind it where it is plain."""
        return self.map_name + (PLAIN_SUFFIX if self.plain else "")

    @property
    def map_name(self) -> str:
        """``noise-free`` or ``seed-N``: what the map depends on."""
        return "noise-free" if self.seed is None else f"seed-{self.seed}"

    @property
    def arguments(self) -> list[str]:
        """The mode on a port's command line: ``--noise-free`` or ``--seed N``, and ``--plain``."""
        noise = (
            ["--noise-free"]
            if self.seed is None
            else ["--seed", str(self.seed)]
        )
        return noise + (["--plain"] if self.plain else [])


NOISE_FREE = Mode(None)
DEFAULT_MODES = (NOISE_FREE, Mode(0))
"""The modes of the golden results."""
PORT_MODES = (
    *DEFAULT_MODES,
    *(replace(mode, plain=True) for mode in DEFAULT_MODES),
)
"""The modes in which a port is compared: each by its fast version and by its plain one."""


def parse_mode(text: str) -> Mode:
    """The mode of that name. Raises ValueError where it is none."""
    plain = text.endswith(PLAIN_SUFFIX)
    noise = text.removesuffix(PLAIN_SUFFIX)
    if noise == "noise-free":
        return Mode(None, plain)
    digits = noise.removeprefix("seed-")
    if digits != noise and digits.isascii() and digits.isdigit():
        seed = int(digits)
        if seed <= LARGEST_SEED and str(seed) == digits:
            return Mode(seed, plain)
    raise ValueError(
        f"{text!r} is not a mode: noise-free, or seed-N with N from 0 to {LARGEST_SEED}, or one of these with "
        f"{PLAIN_SUFFIX} behind it"
    )
