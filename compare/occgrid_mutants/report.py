"""What a campaign found, as text and as JSON."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from occgrid_mutants.campaign import UNITS, Result


def summary(results: Sequence[Result], of: int, seconds: float) -> list[str]:
    """The score, and how many of each kind are seen by what."""
    groups = Counter(result.group for result in results)
    total = len(results)
    what = "every change" if total == of else f"a sample of {total} of {of}"
    seen = groups["scenarios"]
    share = 100.0 * seen / total if total else 0.0
    lines = [
        f"{what}, {seconds / 60.0:.0f} minutes",
        f"seen by scenarios: {seen} ({share:.1f} %)",
        *(f"seen by {unit} only: {groups[unit]}" for unit in UNITS),
        f"seen by nothing: {groups['nothing']}, {sum(not r.reached and not r.seen_by for r in results)} of them on "
        "lines that no scenario runs",
    ]
    kinds = sorted({result.site.kind for result in results})
    for kind in kinds:
        mine = [r for r in results if r.site.kind == kind]
        left = sum(not r.seen_by for r in mine)
        lines.append(f"{kind}: {len(mine)}, {left} of them seen by nothing")
    return lines


def write(
    folder: Path, results: Sequence[Result], of: int, seconds: float
) -> None:
    """``report.md`` with those that are seen by nothing, ``results.json`` with all."""
    folder.mkdir(parents=True, exist_ok=True)
    ordered = sorted(
        results, key=lambda r: (r.site.module, r.site.line, r.site.name)
    )
    lines = ["# Changes of the Python port", ""]
    lines += [f"- {line}" for line in summary(results, of, seconds)]
    for group in ("nothing", *UNITS):
        lines += ["", f"## Seen by {group}", ""]
        for result in ordered:
            if result.group == group:
                site = result.site
                where = f"{site.module}.py:{site.line} {site.function}"
                why = f" ({result.seen_by})" if result.seen_by else ""
                lines.append(
                    f"- {where}: `{site.before}` -> `{site.after}`{why}"
                )
    (folder / "report.md").write_text("\n".join(lines) + "\n", "utf-8")
    records = [
        {
            "module": r.site.module,
            "line": r.site.line,
            "function": r.site.function,
            "kind": r.site.kind,
            "before": r.site.before,
            "after": r.site.after,
            "seen_by": r.seen_by,
            "how": r.how,
            "reached": r.reached,
        }
        for r in ordered
    ]
    (folder / "results.json").write_text(
        json.dumps(records, indent=1) + "\n", "utf-8"
    )
