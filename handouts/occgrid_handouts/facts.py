"""Everything that the text takes from outside: code, numbers, tables, as one JSON file; and the figures."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

from occgrid.grid import logit
from occgrid.lesson import lesson_settings
from occgrid_handouts import figures, sensor_designs
from occgrid_handouts.languages import Language
from occgrid_handouts.lesson_run import lesson_facts, run_lesson
from occgrid_handouts.one_beam import one_beam_facts, run_one_beam
from occgrid_handouts.port_maps import run_ports
from occgrid_handouts.problems import problem_facts
from occgrid_handouts.programs import read_programs
from occgrid_handouts.project import COMMAND, Edition
from occgrid_handouts.snippets import read_snippets, require
from occgrid_handouts.story import tell_story
from occgrid_parity.ports.contributing import snippet_names

# mathematics is read more slowly than a novel
WORDS_A_MINUTE = 100
APPENDIX = ("11-exact-and-fast", "12-side-by-side")
HANDOUTS = Path(__file__).resolve().parents[1]

# how each port is run, as the text shows it
COMMANDS = {
    "python": (
        ".venv/bin/occgrid --plain --noise-free --out maps",
        ".venv/bin/occgrid --plot lesson.png",
    ),
    "cpp": (
        "cpp/build/occgrid --plain --noise-free --out maps",
        "cpp/build/occgrid --seed 1 > lesson.pgm",
    ),
    "java": (
        "java -jar java/target/occgrid.jar --plain --noise-free --out maps",
        "java -jar java/target/occgrid.jar --seed 1 > lesson.pgm",
    ),
    "matlab": (
        "sh matlab/matlab.sh occgrid --plain --noise-free --out maps",
        "sh matlab/matlab.sh occgrid --seed 1 > lesson.pgm",
    ),
    "mathematica": (
        "sh mathematica/wolfram.sh mathematica/occgrid.wls --plain --out maps",
        "sh mathematica/wolfram.sh mathematica/occgrid.wls > lesson.pgm",
    ),
}


def snippet_facts(
    root: Path, languages: Sequence[Language]
) -> dict[str, dict[str, object]]:
    """Each language's snippets. Raises SnippetError where one is missing or unknown."""
    names = snippet_names(root)
    facts: dict[str, dict[str, object]] = {}
    for language in languages:
        found = read_snippets(root, language)
        require(language, found, names)
        facts[language.id] = {
            name: {
                "file": found[name].file,
                "first": found[name].first,
                "last": found[name].last,
                "code": found[name].code,
            }
            for name in names
        }
    return facts


def reading_minutes(text: Path) -> int:
    """How long the text takes to read, without code and appendix, in steps of ten minutes."""
    words = sum(
        len(re.findall(r"[A-Za-z]{2,}", chapter.read_text(encoding="utf-8")))
        for chapter in text.glob("[01]*.typ")
        if chapter.stem not in APPENDIX
    )
    return 10 * math.ceil(words / WORDS_A_MINUTE / 10)


def gather(
    root: Path,
    work: Path,
    languages: Sequence[Language],
    edition: Edition,
    figure_folder: Path,
) -> dict[str, object]:
    """Runs what there is to run, draws the figures, and returns the facts."""
    snippets = snippet_facts(root, languages)
    run = run_lesson()
    beam = run_one_beam(root)
    clamp = sensor_designs.clamp_story(run.history)
    made = sensor_designs.designs()
    story = tell_story(HANDOUTS / "platform_math", work / "platform_math")
    figures.draw_figures(figure_folder, run, beam, clamp, made, story)
    settings = lesson_settings()
    lesson = lesson_facts(run)
    cells = run.history[0].size
    lesson["map_digits"] = math.floor(cells * math.log10(2.0)) + 1
    both = logit(settings.p_occ) + logit(settings.p_free)
    problems = problem_facts() | {"both": f"{both:+.4f}"}
    ports = run_ports(root, languages)
    return {
        "reading": {"minutes": reading_minutes(HANDOUTS / "text")},
        "version": edition.version,
        "commit": edition.commit,
        "command": COMMAND,
        "languages": {
            language.id: {
                "name": language.name,
                "syntax": language.syntax,
                "run": COMMANDS[language.id],
            }
            for language in languages
        },
        "pages": {
            language.id: f"{language.id}.html" for language in languages
        },
        "snippets": snippets,
        "programs": {
            language.id: read_programs(HANDOUTS, language)
            for language in languages
        },
        "lesson": lesson,
        "one_beam": one_beam_facts(beam),
        "clamp": sensor_designs.clamp_facts(clamp),
        "designs": sensor_designs.design_facts(made),
        "problems": problems,
        "story": story.facts,
        "ports": [one.facts() for one in ports],
    }
