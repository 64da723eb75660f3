"""The snippets of each port, as the handouts print them (CONTRIBUTING.md, "Snippets")."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from occgrid_handouts.languages import Language
from occgrid_parity.ports.snippets import (
    Snippet,
    SnippetError,
    parse_snippets,
)


def read_snippets(root: Path, language: Language) -> dict[str, Snippet]:
    """All snippets of a port by name, in the order of its files. Raises SnippetError."""
    found: dict[str, Snippet] = {}
    for path in source_files(root, language):
        file = path.relative_to(root).as_posix()
        for snippet in parse_snippets(file, path.read_text(encoding="utf-8")):
            if snippet.name in found:
                raise SnippetError(
                    f"{file}:{snippet.first}: snippet {snippet.name} is also "
                    f"in {found[snippet.name].file}"
                )
            found[snippet.name] = snippet
    return found


def source_files(root: Path, language: Language) -> list[Path]:
    """The tested sources of a port."""
    return sorted(
        {path for pattern in language.sources for path in root.glob(pattern)}
    )


def require(
    language: Language, found: dict[str, Snippet], names: Sequence[str]
) -> None:
    """Raises SnippetError where a port lacks one of the snippets, or has another one."""
    missing = [name for name in names if name not in found]
    if missing:
        raise SnippetError(
            f"{language.folder}: no snippet {', '.join(missing)}"
        )
    unknown = [name for name in found if name not in names]
    if unknown:
        raise SnippetError(
            f"{language.folder}: unknown snippet {', '.join(unknown)}"
        )
