"""check.html fed with right maps, with every mistake that it knows, and with some that it does not."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from harness_parts import (
    MISTAKES,
    READING,
    SCENARIOS,
    Mapper,
    World,
    arithmetic,
    full_check,
    misread_world,
    seed_of,
    with_mistakes,
    world,
)
from pages_in_browser import GOLDEN, ROOT, Open, drop_file
from playwright.sync_api import Page
from test_accessible import violations

Pixels = npt.NDArray[np.int64]

NUMPY = arithmetic.Arithmetic(np.sin, np.cos, np.exp, np.log)


JUDGED = """name => {
  const verdict = document.querySelector("#verdict");
  const { status } = verdict.dataset;
  const isThis = document.querySelector("#checked").textContent.startsWith(`${name}, `);
  return isThis && status && status !== "working" && [status, verdict.innerText];
}"""


def write_pgm(path: Path, pixels: Pixels) -> Path:
    height, width = pixels.shape
    rows = "\n".join(" ".join(map(str, row)) for row in pixels.tolist())
    path.write_text(f"P2\n{width} {height}\n255\n{rows}\n")
    return path


def read_pgm(path: Path) -> Pixels:
    words = path.read_text().split()
    width, height = int(words[1]), int(words[2])
    return np.array(words[4:], dtype=np.int64).reshape(height, width)


def open_check(
    open_page: Open,
    scenario: str = "lesson",
    seed: int | None = None,
    first: str = "",
) -> Page:
    page = open_page("check", first=first)
    page.locator("#scenario").select_option(scenario)
    if seed is not None:
        page.locator("#seeded").check()
        page.locator("#seed").fill(str(seed))
        page.locator("#seed").press("Tab")
    return page


def verdict(page: Page, file: Path) -> tuple[str, str]:
    """Its status, and all its words."""
    box = page.locator("#verdict")
    box.evaluate("e => { e.dataset.status = 'working'; }")
    page.set_input_files("#file", file)
    # by its name: the file before it may still be on its way
    found = page.wait_for_function(JUDGED, arg=file.name, timeout=600_000)
    status, words = found.json_value()
    return status, words


@pytest.mark.parametrize(
    "name", ["lesson", "asymmetric", "outside", "flaser", "no-return-ignore"]
)
def test_right_maps_are_identical(open_page: Open, name: str) -> None:
    page = open_check(open_page, name)
    status, words = verdict(page, GOLDEN / f"{name}.noise-free.pgm")
    assert (status, words.splitlines()[0]) == ("identical", "identical")
    # with noise, it is another map
    page.locator("#seeded").check()
    golden = GOLDEN / f"{name}.seed-0.pgm"
    assert verdict(page, golden)[0] == "identical"


def test_log_odds_are_compared_in_every_bit(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_check(open_page, "asymmetric", 0)
    values = Mapper(world("asymmetric"), 0).draw().log_odds
    file = tmp_path / "a.logodds"

    def write() -> None:
        height, width = values.shape
        rows = "\n".join(" ".join(map(repr, r)) for r in values.tolist())
        file.write_text(f"# logodds {width} {height}\n{rows}\n")

    write()
    assert verdict(page, file)[0] == "identical"
    gy, gx = np.argwhere(values != 0.0)[7].tolist()
    right = float(values[gy, gx])
    values[gy, gx] = np.nextafter(right, 100.0)
    write()
    status, words = verdict(page, file)
    assert status == "differs"
    assert "differs in 1 cell of" in words
    assert "last bits" in words
    readout = page.locator("#readout").inner_text()
    assert (
        f"cell gx={gx} gy={gy}: your log-odds is {float(values[gy, gx])!r}"
        in readout
    )
    assert f"the right one {right!r}" in readout


def test_every_mistake_that_the_page_knows_is_named(
    open_page: Open, tmp_path: Path
) -> None:
    """On the first scenario that shows it; with noise, which some of them are about."""
    left = [name for name in MISTAKES if name not in READING]
    for scenario in SCENARIOS:
        seed = seed_of(scenario)
        page = open_check(open_page, scenario, seed)
        drawn_world = world(scenario)
        right = Mapper(drawn_world, seed).draw().pixels
        unseen = []
        for name in left:
            mistake = MISTAKES[name]
            pixels = mistake(drawn_world, seed).draw().pixels
            file = write_pgm(tmp_path / "a.pgm", pixels)
            if np.array_equal(pixels, right):
                unseen.append(name)
                continue
            status, words = verdict(page, file)
            if status in ("halves", "edges"):
                # rounding explains it as well, and the page says no more
                assert full_check(scenario, pixels, seed) == status, name
                unseen.append(name)
            else:
                assert f"\u2022 {mistake.title}. " in words, (name, words)
        left = unseen
    # last bits explain it wherever it shows, so it is never named
    assert left == ["pixel-half-even"]


@pytest.mark.parametrize(
    "mistake", ["hit-also-free", "truncation", "rows-and-columns-swapped"]
)
def test_a_mistake_in_the_lesson(
    open_page: Open, tmp_path: Path, mistake: str
) -> None:
    page = open_check(open_page)
    pixels = MISTAKES[mistake](world("lesson"), None).draw().pixels
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    right = read_pgm(GOLDEN / "lesson.noise-free.pgm")
    count = int(np.count_nonzero(pixels != right))
    assert status == "differs"
    assert f"differs in {count:,} cells of 39,600" in words
    assert f"\u2022 {MISTAKES[mistake].title}. " in words
    # both values, under the mouse and by the buttons
    found = set()
    for _ in range(min(count, 12)):
        readout = page.locator("#readout").inner_text()
        match = re.match(
            r"cell gx=(\d+) gy=(\d+): your pixel is (\d+), the right one (\d+)\.",
            readout,
        )
        assert match, readout
        gx, gy, mine, other = map(int, match.groups())
        assert (pixels[179 - gy, gx], right[179 - gy, gx]) == (mine, other)
        assert mine != other
        found.add((gx, gy))
        page.locator("#next").click()
        page.evaluate(
            "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))"
        )
    assert len(found) == min(count, 12)
    page.locator("#right-view").hover()
    page.evaluate(
        "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))"
    )
    assert "cell gx=1" in page.locator("#readout").inner_text()


# Both at once, which the page does not try.
TWO_MISTAKES = with_mistakes("hit-also-free", "off-by-one")


def unknown_pictures() -> Iterator[tuple[str, Pixels]]:
    """Pictures of mistakes that the page does not know, with their scenarios."""
    yield "asymmetric", TWO_MISTAKES(world("asymmetric"), None).draw().pixels
    for mistake, scenario in {
        "odometry-for-pose": "odometry",
        "robot-pose-for-laser": "odometry",
        "flaser-step-n-minus-1": "flaser",
        "flaser-step-n": "flaser",
    }.items():
        misread = misread_world(mistake, scenario)
        yield scenario, Mapper(misread, None).draw().pixels
    # with the noise of a seed that nobody has told the page
    yield "asymmetric", Mapper(world("asymmetric"), 9).draw().pixels


def test_what_the_page_does_not_know_gets_no_name(
    open_page: Open, tmp_path: Path
) -> None:
    for scenario, pixels in unknown_pictures():
        page = open_check(open_page, scenario)
        status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
        assert status == "differs", scenario
        assert "None of the mistakes that this page knows" in words, scenario
        assert "\u2022" not in words


class Linspace(Mapper):
    """A right program whose bearings and ends are computed in another order."""

    def bearings(self) -> npt.NDArray[np.float64]:
        return np.linspace(-np.pi / 2, np.pi / 2, self.settings.beams)


@pytest.mark.parametrize("kind", [Mapper, Linspace])
@pytest.mark.parametrize("numbers", [arithmetic.PLATFORM, NUMPY])
def test_a_right_program_with_its_own_sine_differs_at_edges_only(
    open_page: Open,
    tmp_path: Path,
    kind: type[Mapper],
    numbers: arithmetic.Arithmetic,
) -> None:
    page = open_check(open_page)
    pixels = kind(world("lesson"), None, numbers).draw().pixels
    right = read_pgm(GOLDEN / "lesson.noise-free.pgm")
    count = int(np.count_nonzero(pixels != right))
    assert count > 0, "the own sine shows nowhere: the test needs another"
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "edges"
    assert f"differs in {count} cells, only at cell edges" in words
    assert re.search(r"scan \d+, beam \d+", words)
    # one wrong pixel more, where no beam is open: no such claim
    gy, gx = np.argwhere(right == 255)[5000].tolist()
    pixels[gy, gx] = 254
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "differs"
    assert "edges" not in words


def test_no_more_is_claimed_than_the_full_check_claims(
    open_page: Open, tmp_path: Path
) -> None:
    """Pictures near the right one, by hand: the page's `edges` and `halves` are the full check's too."""
    page = open_check(open_page)
    right = read_pgm(GOLDEN / "lesson.noise-free.pgm")
    own = Mapper(world("lesson"), None, NUMPY).draw().pixels
    edge = np.argwhere(own != right)
    walls = np.argwhere(right == 0)
    pictures = []
    for i in range(4):
        picture = own.copy()
        y, x = edge[i % len(edge)]
        picture[y, x] = right[y, x]  # half of what rounding did taken back
        pictures.append(picture)
    for i in (3, 200, 400):
        picture = right.copy()
        y, x = walls[i]
        picture[y, x] = 64
        pictures.append(picture)
    picture = right.copy()
    picture[right == 179] = 178  # exactly halfway
    pictures.append(picture)
    seen = set()
    for picture in pictures:
        status, _ = verdict(page, write_pgm(tmp_path / "a.pgm", picture))
        full = full_check("lesson", picture)
        seen.add(status)
        if status in ("edges", "halves", "identical"):
            assert full in ("edges", "halves", "identical"), status
    assert {"halves", "differs"} <= seen


# Browsers where no worker starts: it is refused, or it fails.
NO_WORKER = {
    "refused": """window.Worker = class {
  constructor() { throw new DOMException("not here", "SecurityError"); }
};""",
    "failing": """window.Worker = class extends EventTarget {
  constructor() { super(); setTimeout(() => this.dispatchEvent(new Event("error"))); }
  postMessage() {}
  terminate() {}
};""",
}


COUNTED = """window.verdicts = window.failures = 0;
window.Worker = class extends Worker {
  constructor(address) {
    super(address);
    this.addEventListener("message", ({ data }) => { verdicts += data.done; });
    this.addEventListener("error", () => { failures += 1; });
  }
};"""


def some_pictures() -> Iterator[tuple[str, Pixels]]:
    """A right one, one by a known mistake, two that nobody knows, one by another sine; with their scenarios."""
    name = "asymmetric"
    right = Mapper(world(name), None).draw().pixels
    yield name, right
    yield name, MISTAKES["hit-also-free"](world(name), None).draw().pixels
    yield name, TWO_MISTAKES(world(name), None).draw().pixels
    yield name, right[:, 1:]
    yield "lesson", Mapper(world("lesson"), None, NUMPY).draw().pixels


@pytest.mark.parametrize("why", NO_WORKER)
def test_without_a_worker_the_verdict_is_the_same(
    open_page: Open, tmp_path: Path, why: str
) -> None:
    page = open_check(open_page, first=COUNTED)
    other = open_check(open_page, first=NO_WORKER[why])
    statuses: list[str] = []
    for scenario, pixels in some_pictures():
        file = write_pgm(tmp_path / f"{len(statuses)}.pgm", pixels)
        for one in (page, other):
            one.locator("#scenario").select_option(scenario)
        status, words = verdict(page, file)
        # a worker that fails would leave its work to the page, too
        assert page.evaluate("verdicts > 0 && failures === 0")
        assert verdict(other, file) == (status, words)
        statuses.append(status)
        assert page.locator("#working").is_hidden()
        assert other.locator("#working").is_hidden()
    assert statuses == ["identical", "differs", "differs", "size", "edges"]
    assert page.workers == other.workers == []


NEVER_DONE = """window.Worker = class extends Worker {
  addEventListener(type, listener) {
    super.addEventListener(type, (event) => { if (!event.data?.done) listener(event); });
  }
};"""


def test_what_is_known_is_shown_at_once_and_the_search_can_be_stopped(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_check(open_page, "asymmetric", first=NEVER_DONE)
    pixels = MISTAKES["hit-also-free"](world("asymmetric"), None).draw().pixels
    page.set_input_files("#file", write_pgm(tmp_path / "a.pgm", pixels))
    page.locator("#verdict", has_text="differs in ").wait_for()
    page.locator("#next").click()
    shown = page.locator("#readout").inner_text()
    doing = page.locator("#doing")
    assert doing.inner_text() == "Trying known mistakes …"
    assert doing.get_attribute("role") == "status"
    page.wait_for_function("document.querySelector('#progress').value === 1")
    assert page.locator("#verdict").get_attribute("data-status") == "working"
    assert violations(page) == []
    page.locator("#stop").press("Enter")
    box = page.locator("#verdict[data-status=differs]")
    assert "You stopped the search for known mistakes." in box.inner_text()
    assert page.evaluate("document.activeElement.id") == "verdict-title"
    assert page.locator("#working").is_hidden()
    # the cell that was looked at stays
    assert page.locator("#readout").inner_text() == shown
    assert page.workers == []


SYMMETRIES = {
    "flipped upside down": lambda p: p[::-1],
    "mirrored left to right": lambda p: p[:, ::-1],
    "turned by 180 degrees": lambda p: p[::-1, ::-1],
    "transposed (rows and columns exchanged)": lambda p: p[::-1, ::-1].T,
    "transposed as a picture": lambda p: p.T,
    "turned by 90 degrees to the left": lambda p: np.rot90(p),
    "turned by 90 degrees to the right": lambda p: np.rot90(p, -1),
}


@pytest.mark.parametrize("symmetry", SYMMETRIES)
def test_flipped_and_turned(
    open_page: Open, tmp_path: Path, symmetry: str
) -> None:
    page = open_check(open_page, "asymmetric")
    right = read_pgm(GOLDEN / "asymmetric.noise-free.pgm")
    turned = np.ascontiguousarray(SYMMETRIES[symmetry](right))
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", turned))
    assert status == "turned"
    assert f"Your map is exactly the right one, {symmetry}" in words


def test_wrong_size_and_missing_scans(open_page: Open, tmp_path: Path) -> None:
    page = open_check(open_page, "asymmetric")
    right = read_pgm(GOLDEN / "asymmetric.noise-free.pgm")
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", right[:, 1:]))
    assert status == "size"
    assert "60 x 37 cells, the right one 61 x 37" in words
    drawn_world = world("asymmetric")
    some = World(
        drawn_world.settings, drawn_world.walls, list(drawn_world.scans)[:-2]
    )
    pixels = Mapper(some, None).draw().pixels
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "differs"
    assert "the last 2 scans are missing" in words


def test_a_map_of_the_other_mode_is_recognised(open_page: Open) -> None:
    page = open_check(open_page, "asymmetric")
    status, words = verdict(page, GOLDEN / "asymmetric.seed-0.pgm")
    assert status == "differs"
    assert "exactly the right map with the noise of seed 0." in words
    assert (
        page.locator("#checked").inner_text()
        == "asymmetric.seed-0.pgm, compared with asymmetric without noise."
    )
    page.locator("#seeded").check()
    status, words = verdict(page, GOLDEN / "asymmetric.noise-free.pgm")
    assert status == "differs"
    assert "exactly the right map without noise." in words
    page.locator("#seed").fill("5")
    page.locator("#seed").press("Tab")
    status, words = verdict(page, GOLDEN / "asymmetric.seed-0.pgm")
    assert status == "differs"
    assert "exactly the right map" not in words


def test_where_the_trouble_begins(open_page: Open, tmp_path: Path) -> None:
    """A program that turns wrong at scan 60 of the lesson."""
    page = open_check(open_page)
    drawn_world = world("lesson")
    scans = list(drawn_world.scans)
    swapped = World(
        drawn_world.settings, drawn_world.walls, scans[:60] + scans[:60]
    )
    pixels = Mapper(swapped, None).draw().pixels
    status, words = verdict(page, write_pgm(tmp_path / "a.pgm", pixels))
    assert status == "differs"
    settled = re.search(r"wrong by scan (\d+) at the latest", words)
    assert settled, words
    # a cell that differs has its final value since then in the right map
    at = int(settled[1])
    right = read_pgm(GOLDEN / "lesson.noise-free.pgm")
    some = World(drawn_world.settings, drawn_world.walls, scans[:at])
    then = Mapper(some, None).draw().pixels
    assert ((then == right) & (pixels != right)).any()


def test_any_picture_is_read(open_page: Open, tmp_path: Path) -> None:
    page = open_check(open_page, "asymmetric")
    right = read_pgm(GOLDEN / "asymmetric.noise-free.pgm")
    raw = tmp_path / "raw.pgm"
    raw.write_bytes(
        b"P5 # by hand\n61 37\n255\n" + right.astype(np.uint8).tobytes()
    )
    assert verdict(page, raw)[0] == "identical"
    raw.write_bytes(
        b"P5\n61\n37 65535\n" + (right * 257).astype(">u2").tobytes()
    )
    assert verdict(page, raw)[0] == "identical"
    for content, reason in {
        b"P2\n61 37\n255\n1 2 3\n": "ends before pixel 4 of 2257",
        b"P2\n61 37\n255\n300": "A pixel is 300, above 255",
        b"P2\n0 37\n255\n": "no map",
        b"GIF89a": "neither a PGM picture",
        b"": "neither a PGM picture",
        b"# logodds 2\n": "not '# logodds WIDTH HEIGHT'",
        b"# logodds 2 1\n1 x\n": "Line 2: 'x' is not a number",
    }.items():
        raw.write_bytes(content)
        status, words = verdict(page, raw)
        assert (status, reason in words) == ("unreadable", True), words
        assert page.locator("#figures").is_hidden()


def test_a_file_can_be_dropped_and_its_differences_gone_through(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_check(open_page, "asymmetric")
    right = read_pgm(GOLDEN / "asymmetric.noise-free.pgm")
    wrong = right.copy()
    places = [(3, 7), (10, 60), (36, 0)]  # row from the top, column
    for row, column in places:
        wrong[row, column] = (wrong[row, column] + 77) % 256
    drop_file(page, "#drop", write_pgm(tmp_path / "a.pgm", wrong))
    page.locator("#verdict[data-status=differs]").wait_for()

    def shown() -> str:
        page.evaluate(
            "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))"
        )
        return page.locator("#readout").inner_text()

    # from the smallest y on, round to the first again, and back
    cells = [f"cell gx={x} gy={36 - y}:" for y, x in reversed(places)]
    assert shown().startswith(cells[0])
    for cell in (*cells[1:], cells[0]):
        page.locator("#next").click()
        assert shown().startswith(cell)
    page.locator("#previous").click()
    assert shown().startswith(cells[2])
    picture = "document.querySelector('#found-view').toDataURL()"
    coloured = page.evaluate(picture)
    page.locator("#colour").uncheck()
    shown()
    assert page.evaluate(picture) != coloured
    # another scenario: the same file is looked at again
    page.locator("#scenario").select_option("one-beam")
    page.locator("#verdict[data-status=size]").wait_for()


def test_scenarios_can_be_taken_home(open_page: Open, tmp_path: Path) -> None:
    page = open_check(open_page, "octants")
    with page.expect_download() as download:
        page.locator("#save-scenario").click()
    assert download.value.suggested_filename == "octants.log"
    download.value.save_as(tmp_path / "octants.log")
    assert (tmp_path / "octants.log").read_bytes() == (
        ROOT / "scenarios" / "octants.log"
    ).read_bytes()
