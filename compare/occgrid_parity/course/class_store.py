"""Where the results of a class lie: written as they come, each whole or not at all, and taken up by the next run."""

from __future__ import annotations

import hashlib
import json
import shutil
from pathlib import Path

from occgrid import __version__
from occgrid_parity.check.verdict import Verdict, from_json
from occgrid_parity.course.submission_task import SUITE, Checked
from occgrid_parity.formats.text_files import write_text
from occgrid_parity.report.run_page import PAGE_FILE

SUBMISSIONS = "submissions"
"""The folder that the submissions' names are in. Nothing else is, and nothing of theirs is beside it."""

RECORD = "record.json"
SCHEMA = 1


class ClassStore:
    """The results in a folder, and the pages in another."""

    def __init__(self, out: Path, report: Path | None) -> None:
        self.out = out
        self.report = report
        self.folder = out / SUBMISSIONS
        self.folder.mkdir(parents=True, exist_ok=True)

    def place(self, name: str) -> Path:
        """Where the files of a submission lie."""
        return self.folder / name

    def keep(self, checked: Checked, digest: str) -> None:
        """Writes everything about a submission, in place of what was there."""
        files = dict(checked.files)
        if checked.is_final:
            record = {"schema": SCHEMA, "digest": digest, "files": list(files)}
            files[RECORD] = (json.dumps(record, indent=1) + "\n").encode()
        if self.report is not None and checked.page is not None:
            page = {PAGE_FILE: checked.page}
            _replace(self.report / SUBMISSIONS / checked.name, page)
        _replace(self.place(checked.name), files)

    def taken_up(self, name: str, digest: str) -> Verdict | None:
        """The verdict of an earlier run on the same files by the same rules; None where there is none."""
        place = self.place(name)
        try:
            record = json.loads((place / RECORD).read_text(encoding="utf-8"))
            if record["schema"] != SCHEMA or record["digest"] != digest:
                return None
            if not all((place / file).is_file() for file in record["files"]):
                return None
            text = (place / "verdict.json").read_text(encoding="utf-8")
            verdict = from_json(text)
        except (OSError, ValueError, KeyError, TypeError):
            return None
        if self.report is not None:
            page = self.report / SUBMISSIONS / name / PAGE_FILE
            if not page.is_file():
                return None
        return verdict

    def write(self, name: str, text: str) -> None:
        """Writes a file about the whole class."""
        write_text(self.out / name, text)


def _replace(place: Path, files: dict[str, bytes]) -> None:
    """Puts a folder with these files in the place of another."""
    new = place.with_name(f".{place.name}.new")
    old = place.with_name(f".{place.name}.old")
    for rest in (new, old):
        shutil.rmtree(rest, ignore_errors=True)
    new.mkdir(parents=True)
    for name, data in files.items():
        (new / name).write_bytes(data)
    if place.exists():
        place.rename(old)
    new.rename(place)
    shutil.rmtree(old, ignore_errors=True)


def suite_version() -> str:
    """The version, and a hash of every source of the reference and of the harness."""
    digest = hashlib.sha256()
    for folder in SUITE:
        for path in sorted(folder.rglob("*")):
            if path.suffix in (".py", ".html", ".css", ".js"):
                digest.update(path.relative_to(folder).as_posix().encode())
                digest.update(path.read_bytes())
    return f"{__version__} {digest.hexdigest()}"
