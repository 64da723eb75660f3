"""A campaign's record for people, in lines."""

from __future__ import annotations

from occgrid_parity.campaign.campaign_record import (
    CampaignRecord,
    ProgramRecord,
    WorldDifference,
)

SHOWN = 10  # differences of a program that are printed


def campaign_lines(record: CampaignRecord) -> list[str]:
    """A line for each program, the first differences of each, and the summary."""
    lines = [program_line(one) for one in record.programs]
    for program in record.programs:
        found = [x for x in record.differences if x.program == program.name]
        for one in found[:SHOWN]:
            lines += ["", *difference_lines(one)]
        if len(found) > SHOWN:
            lines += ["", f"{program.name}: and {len(found) - SHOWN} more"]
    return [*lines, "", summary(record)]


def program_line(one: ProgramRecord) -> str:
    """How many worlds came out in which way."""
    parts = [f"{one.identical} as the reference"]
    parts.append(f"{one.different} not")
    if one.left_out:
        parts.append(f"{one.left_out} left out")
    if one.skipped:
        parts.append(f"{one.skipped} skipped ({one.problem})")
    return f"{one.name}: {', '.join(parts)}"


def difference_lines(one: WorldDifference) -> list[str]:
    """What differs, how to see it again, and the shortest scenario that shows it."""
    lines = [
        f"{one.program}, world {one.world} ({one.kind}), {one.mode}: {one.status}",
        f"  {one.reason}",
        f"  again: {one.again}",
    ]
    if one.text:
        lines.append(f"  shortened ({one.shortened}):")
        lines += [f"    {line}" for line in one.text.splitlines()]
    return lines


def summary(record: CampaignRecord) -> str:
    """The campaign in a line."""
    count = len(record.differences)
    said = "1 difference" if count == 1 else f"{count} differences"
    names = ", ".join(one.name for one in record.programs)
    return f"{record.done} of {record.worlds} worlds (seed {record.seed}), {names}: {said} in {record.seconds:.0f} s"
