"""The levels of a check, in order: each looks at one thing, and the first that fails is the clearest to tell."""

from __future__ import annotations

from dataclasses import dataclass

from occgrid_parity.suite.cases import LESSON, TWIN
from occgrid_parity.suite.modes import Mode

SEEDS = (Mode(0), Mode(1))


@dataclass(frozen=True)
class LevelPlan:
    """Scenarios that are mapped without noise, or with that of SEEDS where the level is about noise."""

    name: str
    title: str
    scenarios: tuple[str, ...]
    noisy: bool = False


RUNS = ("runs", "it runs")
FILE = ("file", "its file is a picture of the right size")
ORIENTATION = ("orientation", "orientation (the eight symmetries)")
ORIENTED = ("one-beam", "asymmetric")

LEVELS = (
    LevelPlan("one-beam", "one beam", ("one-beam",)),
    LevelPlan("octants", "lines in all octants", ("octants",)),
    LevelPlan(
        "no-return",
        "beams without return",
        ("no-return-free", "no-return-ignore"),
    ),
    LevelPlan("clamping", "clamping", ("saturate",)),
    LevelPlan("prior", "a prior that is not one half", ("prior",)),
    LevelPlan("outside", "outside the grid", ("outside",)),
    LevelPlan("simulated", "simulated scans", ("asymmetric",)),
    LevelPlan("recorded", "recorded scans", ("flaser", "robotlaser1")),
    LevelPlan("formats", "all that the file format allows", ("formats",)),
    LevelPlan("twin", "the well-conditioned lesson", (TWIN,)),
    LevelPlan("lesson", "the lesson", (LESSON,)),
    LevelPlan(
        "noise", "seeded noise", ("asymmetric", TWIN, LESSON), noisy=True
    ),
)

# for the search of the cause, when a level has failed: quick to map, and together they tell the mistakes apart
EVIDENCE = (
    "one-beam",
    "octants",
    "no-return-free",
    "no-return-ignore",
    "saturate",
    "prior",
    "outside",
    "asymmetric",
    "flaser",
    "robotlaser1",
)
