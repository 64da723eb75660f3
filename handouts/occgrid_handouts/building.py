"""All handouts, from the sources to the files in a folder."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from occgrid_handouts.blocks import read_blocks
from occgrid_handouts.facts import gather
from occgrid_handouts.languages import Language
from occgrid_handouts.math_font import find_font, with_math_font
from occgrid_handouts.mathematica import notebook_expression
from occgrid_handouts.matlab_script import script_text
from occgrid_handouts.notebook import (
    make_notebook,
    notebook_text,
    run_notebook,
)
from occgrid_handouts.page_tree import read_page
from occgrid_handouts.project import COMMAND, Edition
from occgrid_handouts.typesetting import Kind, prepare, typeset

EDITIONS = ("student", "instructor")
MARKER = ".occgrid-handouts"

# what there is to run, beside the pages: its file, and how the index calls it
EXTRAS = {
    "python": ("python.ipynb", "Jupyter notebook"),
    "matlab": ("matlab_handout.m", "script with sections"),
    "mathematica": ("mathematica.nb", "Mathematica notebook"),
}

KINDS: tuple[Kind, ...] = ("pdf", "html")

Say = Callable[[str], None]


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
) -> list[Path]:
    """Writes everything into ``out``, which is emptied first, and returns the files.

    Raises SnippetError, TypesettingError, FileExistsError (where ``out`` holds something else).
    """
    prepare_folder(out)
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        text = work / "text"
        say("runs, libraries, figures")
        facts = gather(root, work, languages, edition, text / "figures")
        facts["extras"] = {
            id: {"file": file, "name": title}
            for id, (file, title) in EXTRAS.items()
        }
        prepare(text, facts)
        say(f"typesetting {len(languages)} languages")
        files = _typeset(text, languages, edition, jobs)
    if find_font() is None:
        say("without a font for equations: install fonts-dejavu-extra")
    files |= _extras(root, files, languages, edition, say)
    pages = {
        name: content.decode()
        for name, content in files.items()
        if name.endswith(".html")
    }
    files |= {n: p.encode() for n, p in with_math_font(pages).items()}
    written = []
    for name, content in sorted(files.items()):
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        written.append(path)
    return written


def prepare_folder(out: Path) -> None:
    """Makes the folder, and empties that of an earlier build."""
    if out.exists() and not (out / MARKER).is_file() and any(out.iterdir()):
        raise FileExistsError(
            f"{out}: is not empty, and no folder of handouts"
        )
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    (out / MARKER).write_text("This folder is emptied by the next build.\n")


def _typeset(
    text: Path, languages: Sequence[Language], edition: Edition, jobs: int
) -> dict[str, bytes]:
    """PDF and HTML of every language in both editions, and the index pages."""
    plan = {}
    for which in EDITIONS:
        folder = "" if which == "student" else f"{which}/"
        for language in languages:
            for kind in KINDS:
                plan[f"{folder}{language.id}.{kind}"] = Job(
                    text,
                    "main.typ",
                    language.id,
                    which,
                    kind,
                    edition.seconds,
                )
        first = languages[0].id
        plan[f"{folder}index.html"] = Job(
            text, "index.typ", first, which, "html", edition.seconds
        )
    with ProcessPoolExecutor(jobs) as pool:
        made = pool.map(Job.run, plan.values())
        return dict(zip(plan, made, strict=True))


def _extras(
    root: Path,
    files: dict[str, bytes],
    languages: Sequence[Language],
    edition: Edition,
    say: Say,
) -> dict[str, bytes]:
    """Notebooks and script, with the text of the students' pages."""
    stamp = f"occgrid {edition.version}, commit {edition.commit}, {COMMAND}"
    made = {}
    for language in languages:
        if language.id not in EXTRAS:
            continue
        file, _ = EXTRAS[language.id]
        say(file)
        blocks = read_blocks(read_page(files[f"{language.id}.html"].decode()))
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
