"""All handouts, from the sources to the files in a folder."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from occgrid_handouts.blocks import read_blocks
from occgrid_handouts.class_rules import class_rules, rules_name
from occgrid_handouts.facts import gather
from occgrid_handouts.languages import Language
from occgrid_handouts.math_font import find_font, with_math_font
from occgrid_handouts.mathematica import notebook_expression
from occgrid_handouts.matlab_script import script_text
from occgrid_handouts.missing import IncompleteError, missing_measurements
from occgrid_handouts.notebook import (
    make_notebook,
    notebook_text,
    run_notebook,
)
from occgrid_handouts.packages import make_package, package_name
from occgrid_handouts.page_tree import Element, read_page
from occgrid_handouts.project import COMMAND, Edition
from occgrid_handouts.speech import missing_tool, without_formulas, words
from occgrid_handouts.starters import Stage, make_stages, starter_zip
from occgrid_handouts.typesetting import (
    Kind,
    prepare,
    typeset,
    write_speech,
)
from occgrid_handouts.web_pages import NAMES as WEB_PAGES
from occgrid_handouts.web_pages import web_pages

EDITIONS = ("student", "instructor")
MARKER = ".occgrid-handouts"

# what there is to run, beside the pages: its file, and how the index calls it
EXTRAS = {
    "python": ("python.ipynb", "Jupyter notebook"),
    "matlab": ("matlab_handout.m", "script with sections"),
    "mathematica": ("mathematica.nb", "Mathematica notebook"),
}

Say = Callable[[str], None]
Files = dict[str, bytes]


@dataclass(frozen=True)
class Job:
    """One thing to typeset."""

    folder: Path
    main: str
    language: str
    edition: str
    kind: Kind
    seconds: int

    def run(self) -> bytes:
        """The file's content."""
        return typeset(
            self.folder,
            self.main,
            self.language,
            self.edition,
            self.kind,
            self.seconds,
        )


def build(
    root: Path,
    out: Path,
    languages: Sequence[Language],
    edition: Edition,
    jobs: int,
    say: Say,
    partial: bool = False,
) -> list[Path]:
    """Writes everything into ``out``, which is emptied first, and returns the files.

    Where something cannot be made, it raises IncompleteError, or with ``partial`` says so and goes on. Also raises
    SnippetError, CutError, TypesettingError, SpeechError, FileExistsError (where ``out`` holds something else).
    """
    check_folder(out)
    stages = {one.id: make_stages(root, one) for one in languages}
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        text = work / "text"
        pages, missing = web_pages(root, work / "web")
        if find_font() is None:
            missing.append("a font for equations: install fonts-dejavu-extra")
        without_words = missing_tool(root)
        if without_words:
            missing.append(f"words for equations: {without_words}")
        if missing and not partial:
            raise IncompleteError(missing)
        say("runs, libraries, figures")
        facts = gather(root, work, languages, edition, text / "figures")
        missing += missing_measurements(facts)
        if missing and not partial:
            raise IncompleteError(missing)
        for part in missing:
            say(f"MISSING: {part}")
        facts["missing"] = missing
        facts["extras"] = {
            id: {"file": file, "name": title}
            for id, (file, title) in EXTRAS.items()
        }
        facts["web_pages"] = sorted(pages)
        facts["packages"] = {one.id: package_name(one) for one in languages}
        prepare(text, facts)
        say(f"typesetting {len(languages)} languages")
        files = _typeset(_plan(text, languages, edition, "html"), jobs)
        files, equations = _without_formulas(files)
        say(f"words for {len(equations)} equations")
        spoken = (
            {key: one.text() for key, one in equations.items()}
            if without_words
            else words(root, equations)
        )
        write_speech(text, spoken)
        say("typesetting for print")
        files |= _typeset(_plan(text, languages, edition, "pdf"), jobs)
    files |= _with_fonts(files)
    student = of_edition(files, "student")
    extras = _extras(root, student, languages, edition, say)
    say("zip files")
    files |= {
        f"{which}/{n}": c for which in EDITIONS for n, c in extras.items()
    }
    files |= {
        f"{which}/{n}": c for which in EDITIONS for n, c in pages.items()
    }
    files |= pages  # where the build of the folder web puts them, too
    files |= _zip_files(
        root, languages, edition, student | extras, pages, stages
    )
    files |= _solutions(languages, stages)
    return _write(out, files)


def of_edition(files: Mapping[str, bytes], edition: str) -> Files:
    """The files of one edition, by their names in its folder."""
    prefix = f"{edition}/"
    return {
        name.removeprefix(prefix): content
        for name, content in files.items()
        if name.startswith(prefix)
    }


def check_folder(out: Path) -> None:
    """Raises FileExistsError where the folder holds something that no earlier build has put there."""
    if not out.exists() or (out / MARKER).is_file():
        return
    # the pages of the folder web, whose own build puts them here
    others = [path for path in out.iterdir() if path.name not in WEB_PAGES]
    if others:
        raise FileExistsError(
            f"{out}: is not empty, and no folder of handouts"
        )


def _write(out: Path, files: Mapping[str, bytes]) -> list[Path]:
    """The folder with these files and no others."""
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    (out / MARKER).write_text("This folder is emptied by the next build.\n")
    written = []
    for name, content in sorted(files.items()):
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        written.append(path)
    return written


def _plan(
    text: Path, languages: Sequence[Language], edition: Edition, kind: Kind
) -> dict[str, Job]:
    """Every language in both editions, by the name of its file; with the pages, the index pages."""
    plan = {}
    for which in EDITIONS:
        for language in languages:
            plan[f"{which}/{language.id}.{kind}"] = Job(
                text, "main.typ", language.id, which, kind, edition.seconds
            )
        if kind == "html":
            first = languages[0].id
            plan[f"{which}/index.html"] = Job(
                text, "index.typ", first, which, kind, edition.seconds
            )
    return plan


def _typeset(plan: Mapping[str, Job], jobs: int) -> Files:
    """The files of a plan."""
    with ProcessPoolExecutor(jobs) as pool:
        made = pool.map(Job.run, plan.values())
        return dict(zip(plan, made, strict=True))


def _without_formulas(files: Files) -> tuple[Files, dict[str, Element]]:
    """The pages without their lists of equations, and all of these in one."""
    equations: dict[str, Element] = {}
    pages = {}
    for name, content in files.items():
        page, found = without_formulas(content.decode())
        pages[name] = page.encode()
        equations |= found
    return pages, equations


def _with_fonts(files: Mapping[str, bytes]) -> Files:
    """The pages with a font for their equations."""
    pages = {
        name: content.decode()
        for name, content in files.items()
        if name.endswith(".html")
    }
    return {n: p.encode() for n, p in with_math_font(pages).items()}


def _extras(
    root: Path,
    student: Mapping[str, bytes],
    languages: Sequence[Language],
    edition: Edition,
    say: Say,
) -> Files:
    """Notebooks and script, with the text of the students' pages."""
    stamp = f"occgrid {edition.version}, commit {edition.commit}, {COMMAND}"
    made = {}
    for language in languages:
        if language.id not in EXTRAS:
            continue
        file, _ = EXTRAS[language.id]
        say(file)
        page = read_page(student[f"{language.id}.html"].decode())
        blocks = read_blocks(page)
        title = f"Occupancy grid mapping: {language.name}"
        if language.id == "python":
            notebook = make_notebook(title, stamp, blocks)
            run_notebook(notebook, root)
            text = notebook_text(notebook)
        elif language.id == "matlab":
            text = script_text(title, stamp, blocks)
        else:
            text = notebook_expression(title, stamp, blocks)
        made[file] = text.encode()
    return made


def _zip_files(
    root: Path,
    languages: Sequence[Language],
    edition: Edition,
    student: Mapping[str, bytes],
    pages: Mapping[str, bytes],
    stages: Mapping[str, Sequence[Stage]],
) -> Files:
    """For each language, the students' edition and the starter."""
    made = {}
    for language in languages:
        extra = EXTRAS.get(language.id, (None, ""))[0]
        made[f"student/{package_name(language)}.zip"] = make_package(
            root, language, edition, student, extra, pages
        )
        made[f"student/starter-{language.id}.zip"] = starter_zip(
            language, stages[language.id], edition
        )
    return made


def _solutions(
    languages: Sequence[Language], stages: Mapping[str, Sequence[Stage]]
) -> Files:
    """For instructors: the solutions of the exercises as patches, and rules for a class that does one."""
    made = {}
    for language in languages:
        folder = f"instructor/solutions/{language.id}"
        for stage in stages[language.id]:
            exercise = stage.exercise
            patch = f"{folder}/exercise-{exercise.number}.patch"
            made[patch] = stage.patch.encode()
            rules = f"{folder}/{rules_name(exercise)}"
            made[rules] = class_rules(language, exercise).encode()
    return made
