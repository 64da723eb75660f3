"""What a campaign found, as text and as JSON."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from occgrid_mutants.campaign import UNITS, Result
from occgrid_mutants.sites import Site


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


@dataclass(frozen=True)
class Run:
    """A run of changes: of which sources, how many are chosen, how long it has taken."""

    sources: str  # their fingerprint
    of: int
    seconds: float


def write(folder: Path, results: Mapping[int, Result], run: Run) -> None:
    """``report.md`` with those that no scenario sees, ``results.json`` with all.

    ``results`` stand under the numbers of the changes, among all that there are.
    """
    folder.mkdir(parents=True, exist_ok=True)
    ordered = sorted(
        results.items(),
        key=lambda item: (item[1].site.module, item[1].site.line, item[0]),
    )
    lines = ["# Changes of the Python port", ""]
    found = summary(list(results.values()), run.of, run.seconds)
    lines += [f"- {line}" for line in found]
    for group in ("nothing", *UNITS):
        lines += ["", f"## Seen by {group}", ""]
        for _, result in ordered:
            if result.group == group:
                site = result.site
                where = f"{site.module}.py:{site.line} {site.function}"
                why = f" ({result.seen_by})" if result.seen_by else ""
                lines.append(
                    f"- {where}: `{site.before}` -> `{site.after}`{why}"
                )
    _replace(folder / "report.md", "\n".join(lines) + "\n")
    records = [
        {
            "number": number,
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
        for number, r in ordered
    ]
    text = json.dumps({**asdict(run), "changes": records}, indent=1)
    _replace(folder / "results.json", text + "\n")


def read(
    folder: Path, sites: Sequence[Site], sources: str
) -> tuple[dict[int, Result], float]:
    """What an interrupted run of the same sources has found, and how long that took. ValueError where there is none."""
    file = folder / "results.json"
    if not file.exists():
        raise ValueError(f"{file}: there is no run to take up")
    run = json.loads(file.read_text("utf-8"))
    if run["sources"] != sources:
        raise ValueError(f"{file}: the sources have changed since that run")
    results = {
        r["number"]: Result(
            sites[r["number"]], r["seen_by"], r["how"], r["reached"]
        )
        for r in run["changes"]
    }
    return results, run["seconds"]


def _replace(file: Path, text: str) -> None:
    new = file.with_name(f"{file.name}.new")
    new.write_text(text, "utf-8")
    new.replace(file)
