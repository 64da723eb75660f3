"""The command line: python handouts/build.py --out DIR"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from occgrid_handouts.building import build
from occgrid_handouts.durations import DurationRecord
from occgrid_handouts.function_bodies import CutError
from occgrid_handouts.languages import BY_ID, LANGUAGES
from occgrid_handouts.missing import IncompleteError
from occgrid_handouts.project import ROOT, current_edition
from occgrid_handouts.speech import SpeechError
from occgrid_handouts.typesetting import TypesettingError
from occgrid_parity.ports.snippets import SnippetError


def main(arguments: Sequence[str] | None = None) -> int:
    """Builds the handouts; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="handouts/build.py",
        description="Build the course handouts: PDF, HTML, notebooks.",
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=ROOT / "build" / "handouts",
        metavar="DIR",
        help="where to (default: build/handouts)",
    )
    parser.add_argument(
        "--language",
        action="append",
        choices=sorted(BY_ID),
        help="only this one, and others given likewise (default: all five)",
    )
    parser.add_argument(
        "--jobs", type=int, default=2, help="processes side by side"
    )
    parser.add_argument(
        "--partial",
        action="store_true",
        help="go on where something cannot be made or measured here, and say in the text what is missing",
    )
    parser.add_argument("--quiet", action="store_true", help="say nothing")
    options = parser.parse_args(arguments)
    chosen = options.language or [language.id for language in LANGUAGES]
    started = time.monotonic()

    def say(text: str) -> None:
        if not options.quiet:
            print(f"{time.monotonic() - started:6.1f} s  {text}", flush=True)

    chosen_languages = [one for one in LANGUAGES if one.id in chosen]
    record = DurationRecord(ROOT / "build" / "handouts-seconds")
    say(record.announcement(chosen_languages))
    try:
        files = build(
            ROOT,
            options.out.resolve(),
            chosen_languages,
            current_edition(),
            options.jobs,
            say,
            options.partial,
        )
    except (
        SnippetError,
        CutError,
        TypesettingError,
        SpeechError,
        FileExistsError,
        IncompleteError,
    ) as error:
        print(f"handouts: {error}", file=sys.stderr)
        return 1
    say(f"{len(files)} files in {options.out}")
    record.keep(chosen_languages, time.monotonic() - started)
    return 0
