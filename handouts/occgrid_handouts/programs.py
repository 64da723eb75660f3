"""Small programs for the reader, in handouts/programs: shown in the text, run in the notebook and the script."""

from __future__ import annotations

from pathlib import Path

from occgrid_handouts.languages import Language
from occgrid_parity.ports.snippets import MAX_COLUMNS, SnippetError

ENDINGS = {"python": ".py", "matlab": ".m", "mathematica": ".wl"}


def read_programs(
    handouts: Path, language: Language
) -> dict[str, dict[str, str]]:
    """Name to file and code; empty for a language that has none."""
    ending = ENDINGS.get(language.id)
    if ending is None:
        return {}
    folder = handouts / "programs" / language.id
    programs = {}
    for path in sorted(folder.glob(f"*{ending}")):
        code = path.read_text(encoding="utf-8").rstrip("\n")
        for number, line in enumerate(code.splitlines(), 1):
            if len(line) > MAX_COLUMNS:
                raise SnippetError(
                    f"{path}:{number}: {len(line)} columns, {MAX_COLUMNS} fit"
                )
        file = path.relative_to(handouts.parent).as_posix()
        programs[path.stem] = {"file": file, "code": code}
    return programs
