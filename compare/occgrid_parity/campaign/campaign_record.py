"""What a campaign found, as plain data."""

from __future__ import annotations

from dataclasses import dataclass, field

from occgrid_parity.formats.json_records import json_text, record_from_json

SCHEMA = 1
RECORD_FILE = "campaign.json"


@dataclass(frozen=True)
class WorldDifference:
    """A world that a program does not map as the reference does.

    ``status`` and ``reason`` as in the record of a run. ``file`` is the scenario, ``shortened`` the least of it that
    still shows the difference, both beside the record; empty where they were not written. ``text`` is the shortened
    scenario. ``again`` is the command that maps the world again.
    """

    program: str
    world: int
    kind: str
    mode: str
    status: str
    reason: str
    again: str
    file: str = ""
    shortened: str = ""
    text: str = ""


@dataclass(frozen=True)
class ProgramRecord:
    """One program: how many worlds it mapped as the reference does, and otherwise.

    ``left_out`` were too slow for it, ``skipped`` could not be asked: ``problem`` says why.
    """

    name: str
    language: str
    version: str = ""
    identical: int = 0
    different: int = 0
    left_out: int = 0
    skipped: int = 0
    problem: str = ""


@dataclass(frozen=True)
class CampaignRecord:
    """A whole campaign: the worlds from ``first`` on, of which ``done`` were mapped."""

    schema: int
    started: str
    seconds: float
    machine: str
    seed: int
    first: int
    worlds: int
    done: int
    programs: list[ProgramRecord]
    differences: list[WorldDifference] = field(default_factory=list)

    def is_identical(self, allow_skipped: bool = False) -> bool:
        """Whether every program mapped every world that it could be asked, at least one, as the reference does."""
        return (
            not self.differences
            and self.done == self.worlds
            and any(one.identical for one in self.programs)
            and (
                allow_skipped or not any(one.skipped for one in self.programs)
            )
        )


def to_json(record: CampaignRecord) -> str:
    """The record as JSON text."""
    return json_text(record)


def from_json(text: str) -> CampaignRecord:
    """The record in JSON text. Raises ValueError where it is of another schema."""
    return record_from_json(CampaignRecord, SCHEMA, text)
