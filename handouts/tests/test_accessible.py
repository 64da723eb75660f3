"""What readers with a screen reader, a keyboard or bad eyes meet: the pages by axe-core, the PDFs by veraPDF."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from built_handouts import REQUIRE_ALL, WIDTHS, Handouts, needs
from occgrid_handouts.project import ROOT

pytestmark = pytest.mark.long

AXE = ROOT / "web" / "node_modules" / "axe-core" / "axe.min.js"
VERAPDF = ROOT / "build" / "verapdf"
RUN = "axe.run({ resultTypes: ['violations'] })"


def installed(path: Path, how: str) -> Path:
    """A tool's file; without it the test is skipped, or fails where none may be."""
    if not path.is_file():
        reason = f"{path.relative_to(ROOT)} is missing: {how}"
        pytest.fail(reason) if REQUIRE_ALL else pytest.skip(reason)
    return path


def violations(page: Page) -> list[str]:
    """What axe-core finds in a page."""
    axe = installed(AXE, "npm ci in web/")
    page.evaluate(axe.read_text(encoding="utf-8"))
    return [
        f"{one['id']}: {node['html'][:200]} {node['failureSummary']}"
        for one in page.evaluate(RUN)["violations"]
        for node in one["nodes"]
    ]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", WIDTHS)
def test_axe_finds_nothing(
    handouts: Handouts, browser: Browser, width: int, scheme: str
) -> None:
    found = {}
    for name in handouts.pages():
        page = browser.new_page(
            viewport={"width": width, "height": 900},
            color_scheme=scheme,  # type: ignore[arg-type]
        )
        page.goto((handouts.folder / name).as_uri())
        found[name] = violations(page)
        page.close()
    assert found == {name: [] for name in found}


def test_axe_would_find_something(
    handouts: Handouts, browser: Browser
) -> None:
    page = browser.new_page()
    page.goto((handouts.folder / "student/index.html").as_uri())
    page.evaluate(
        "document.querySelector('h1').innerHTML = '<img src=\"data:,\">'"
    )
    assert any("image-alt" in one for one in violations(page))
    page.close()


def verapdf(*files: Path) -> dict[str, list[str]]:
    """The rules of PDF/UA-1 that each file breaks."""
    java = needs("openjdk-17-jdk-headless", "java")
    jars = sorted(VERAPDF.glob("greenfield-apps-*.jar"))
    jar = installed(
        jars[-1] if jars else VERAPDF / "greenfield-apps.jar",
        "make test-long fetches it",
    )
    program = "org.verapdf.apps.GreenfieldCliWrapper"
    options = ["--flavour", "ua1", "--format", "json"]
    done = subprocess.run(
        [java, "-cp", str(jar), program, *options, *map(str, files)],
        capture_output=True,
        text=True,
    )
    report = json.loads(done.stdout)["report"]
    broken = {}
    for job in report["jobs"]:
        (result,) = job["validationResult"]
        broken[job["itemDetails"]["name"]] = [
            f"{rule['clause']}-{rule['testNumber']}: {rule['description']}"
            for rule in result["details"]["ruleSummaries"]
        ]
        assert result["compliant"] == (not broken[job["itemDetails"]["name"]])
    return broken


def test_pdfs_keep_to_pdf_ua(handouts: Handouts) -> None:
    files = handouts.pdfs()
    assert verapdf(*files) == {str(path): [] for path in files}


def test_pdf_that_breaks_the_standard_is_noticed(
    handouts: Handouts, tmp_path: Path
) -> None:
    """Without its language, of which the standard says that it must be there."""
    content = handouts.pdfs()[0].read_bytes()
    assert content.count(b"/Lang") > 0
    path = tmp_path / "broken.pdf"
    path.write_bytes(content.replace(b"/Lang", b"/Lung"))
    (broken,) = verapdf(path).values()
    assert any("language" in rule for rule in broken)
