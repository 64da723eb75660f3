"""Both pages as people treat them who do not know them: files beside the place for them, fingers, odd grids."""

from __future__ import annotations

from pathlib import Path

import pytest
from pages_in_browser import GOLDEN, ROOT, Open, drop_file
from playwright.sync_api import Page
from test_play import HASH, words

LAST = "occgridPage.lab.goTo(occgridPage.lab.count)"

DROP_EMPTY = """([selector, sizes]) => {
  const dataTransfer = new DataTransfer();
  for (const size of sizes)
    dataTransfer.items.add(new File([new Uint8Array(size)], "some.log"));
  const event = new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true });
  document.querySelector(selector).dispatchEvent(event);
  return event.defaultPrevented;
}"""


def scenario(
    folder: Path, width: int, height: int, walls: int = 1, name: str = "odd"
) -> Path:
    path = folder / f"{name}.log"
    path.write_text(
        f"PARAM occgrid_width {width}\nPARAM occgrid_height {height}\n"
        "PARAM occgrid_resolution 0.1\nPARAM occgrid_origin_x 0\n"
        "PARAM occgrid_origin_y 0\nPARAM occgrid_max_range 3\n"
        + "".join(f"WALL 2 {i} 2 {i + 0.5}\n" for i in range(walls))
        + "POSE 1 0.5 0\n"
    )
    return path


def test_a_file_dropped_beside_its_place_is_taken(open_page: Open) -> None:
    """The browser would open it in place of the page. What became of it is seen."""
    page = open_page("play", "#noise=free")
    drop_file(page, "h1", ROOT / "scenarios" / "outside.log")
    page.locator("#file-words", has_text="outside.log: ").wait_for()
    page.evaluate(LAST)
    last = (GOLDEN / "outside.noise-free.sha256").read_text().split()[-1]
    assert page.evaluate(HASH) == last
    page = open_page("check")
    drop_file(page, "h1", GOLDEN / "lesson.noise-free.pgm")
    page.locator("#verdict[data-status=identical]").wait_for()


@pytest.mark.parametrize(
    ("sizes", "why"),
    [
        ([3, 4], "2 files: cannot be read. This page takes one file"),
        ([50_000_001], "some.log: cannot be read. It has 51 MB"),
        ([0], "some.log:0: no scan"),
    ],
)
def test_what_cannot_be_taken_is_said(
    open_page: Open, sizes: list[int], why: str
) -> None:
    page = open_page("play")
    assert page.evaluate(DROP_EMPTY, ["h2", sizes])
    page.locator("#file-words", has_text=why).wait_for()


def test_two_files_at_once_are_not_checked(open_page: Open) -> None:
    page = open_page("check")
    page.evaluate(DROP_EMPTY, ["main", [3, 4]])
    page.locator("#verdict", has_text="one file at a time").wait_for()


@pytest.mark.parametrize(
    ("width", "height", "why"),
    [
        (5000, 5000, "too many for this page"),
        (1, 41, "too long a strip"),
        (41, 1, "too long a strip"),
    ],
)
def test_grids_that_a_page_cannot_show(
    open_page: Open, tmp_path: Path, width: int, height: int, why: str
) -> None:
    page = open_page("play")
    drop_file(page, "#drop", scenario(tmp_path, width, height))
    page.locator("#file-words", has_text=why).wait_for()
    assert page.evaluate("occgridPage.lab.name") == "lesson"


@pytest.mark.parametrize("size", [(1, 1), (30, 900), (900, 30)])
def test_a_picture_fits_the_window(
    open_page: Open, tmp_path: Path, size: tuple[int, int]
) -> None:
    page = open_page("play")
    drop_file(page, "#drop", scenario(tmp_path, *size))
    page.locator("#file-words", has_text="1 scan, ").wait_for()
    words(page, "map-words")
    for name in ("world-view", "map-view", "right-view"):
        box = page.locator(f"#{name}").bounding_box()
        assert box is not None
        assert 8 <= box["height"] <= 851
        assert 8 <= box["width"] <= 600
        assert (box["width"] - 2) / (box["height"] - 2) == pytest.approx(
            size[0] / size[1], rel=0.2
        )


def test_of_many_walls_some_are_listed(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play")
    drop_file(page, "#drop", scenario(tmp_path, 30, 30, walls=1500))
    page.locator("#file-words", has_text="1,500 walls").wait_for()
    assert words(page, "more-walls") == "and 1,300 more walls"
    assert page.locator("#walls tbody tr").count() == 200


def test_names_beside_the_curve_are_apart(open_page: Open) -> None:
    page = open_page("play", "#l_max=0.25&l_min=-20&cell=60,110&scan=120")
    words(page, "cell-words")
    boxes = page.locator("#curve text").evaluate_all(
        "all => all.map((e) => [e.textContent, e.getBBox()])"
        ".map(([t, b]) => [t, b.x, b.y, b.width, b.height])"
    )
    names = [name for name, *_ in boxes]
    assert {"l_max", "l_min", "prior", "0.25"} <= set(names)
    for i, (one, x, y, w, h) in enumerate(boxes):
        for other, x2, y2, w2, h2 in boxes[:i]:
            # a line of text is less high than its box
            apart = (
                x + w <= x2
                or x2 + w2 <= x
                or y + 0.8 * h <= y2
                or y2 + 0.8 * h2 <= y
            )
            assert apart, (one, other)


POINTER = """([type, id, x, y]) => {
  const canvas = document.querySelector("#world-view");
  canvas.setPointerCapture = () => {};
  canvas.dispatchEvent(new PointerEvent(type, { pointerId: id, clientX: x, clientY: y, button: 0 }));
}"""


def on_canvas(page: Page, x: float, y: float) -> tuple[float, float]:
    """A place of the lesson's world in the window."""
    box = page.locator("#world-view").bounding_box()
    assert box is not None
    left = page.evaluate("occgridPage.lab.pad.left")
    scale = (box["width"] - 2) / (left + 220)
    return (
        box["x"] + 1 + (left + (x + 11) * 10) * scale,
        box["y"] + 1 + (180 - (y + 9) * 10) * scale,
    )


def test_a_second_finger_does_not_move_the_robot(open_page: Open) -> None:
    page = open_page("play", "#scan=30")
    page.locator("#world-view").scroll_into_view_if_needed()
    pose = page.evaluate("occgridPage.lab.poses[29]")

    def point(kind: str, pointer: int, x: float, y: float) -> None:
        page.evaluate(POINTER, [kind, pointer, *on_canvas(page, x, y)])

    point("pointerdown", 1, pose["x"], pose["y"])
    point("pointermove", 1, 3, -2)
    point("pointerdown", 2, 3, -2)
    point("pointermove", 2, -8, 5)
    point("pointerup", 2, -8, 5)
    point("pointermove", 1, 4, -3)
    free = page.evaluate("occgridPage.lab.free")
    assert free["x"] == pytest.approx(4, abs=0.1)
    assert free["y"] == pytest.approx(-3, abs=0.1)


def test_a_drag_that_the_browser_takes_away_draws_no_wall(
    open_page: Open,
) -> None:
    page = open_page("play", "#scan=30")
    page.locator("[data-tool=draw]").click()
    page.locator("#world-view").scroll_into_view_if_needed()
    for end, walls in (("pointercancel", 6), ("pointerup", 7)):
        for kind, x in (("pointerdown", 2), ("pointermove", 5), (end, 5)):
            page.evaluate(POINTER, [kind, 1, *on_canvas(page, x, -3)])
        assert page.evaluate("occgridPage.lab.world.walls.length") == walls


def test_a_finger_reads_out_cells(open_page: Open) -> None:
    """A tap moves no pointer."""
    phone = {
        "viewport": {"width": 390, "height": 800},
        "has_touch": True,
        "is_mobile": True,
    }
    page = open_page("check", **phone)
    page.locator("#scenario").select_option("asymmetric")
    page.set_input_files("#file", GOLDEN / "asymmetric.seed-0.pgm")
    page.locator("#verdict[data-status=differs]").wait_for()
    page.locator("#right-view").tap(position={"x": 180, "y": 110})
    page.locator("#readout", has_text="cell gx=30 gy=18:").wait_for()
    page = open_page("play", "#mistake=no-clamp", **phone)
    page.locator("#wrong-view").tap(position={"x": 181, "y": 148})
    page.locator("#wrong-words", has_text="cell gx=110 gy=89:").wait_for()


def test_a_mistake_that_a_link_asks_for_can_be_switched_off(
    open_page: Open,
) -> None:
    page = open_page("play", "#mistake=picture-inverted")
    assert "cells differ in the picture" in words(page, "difference-words")
    page.locator("[data-mistake=picture-inverted]").uncheck()
    assert words(page, "difference-words") == "No mistake is switched on."


def test_the_chooser_of_files_stands_in_the_middle(open_page: Open) -> None:
    for name in ("play", "check"):
        page = open_page(name, viewport={"width": 390, "height": 800})
        page.evaluate(
            "document.querySelectorAll('details').forEach(d => { d.open = true; })"
        )
        place = page.locator("#drop").bounding_box()
        chooser = page.locator("#file").bounding_box()
        assert place and chooser
        assert chooser["width"] < 150  # it is no wider than its button
        words_left = page.locator("#drop label").evaluate(
            "e => { const r = document.createRange(); r.selectNode(e.firstChild);"
            " return r.getBoundingClientRect().left; }"
        )
        left = min(words_left, chooser["x"])
        right = chooser["x"] + chooser["width"]
        middle = place["x"] + place["width"] / 2
        assert (left + right) / 2 == pytest.approx(middle, abs=6)


KINDS = {
    b"": "The file is empty, neither",
    "P2\n1 1\n255\n0\n".encode("utf-16"): "UTF-16, as PowerShell",
    b"\x89PNG\r\n\x1a\n": "This is a PNG picture, neither",
    b"P6 1 1 255\nabc": "PPM picture",
    bytes(range(256)): "This is neither",
}


def test_a_file_that_is_no_map_is_told_by_its_kind(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("check")
    for i, (content, said) in enumerate(KINDS.items()):
        (tmp_path / f"{i}.pgm").write_bytes(content)
        page.set_input_files("#file", tmp_path / f"{i}.pgm")
        page.locator("#checked", has_text=f"{i}.pgm, ").wait_for()
        page.locator("#verdict[data-status=unreadable]").wait_for()
        assert said in page.locator("#verdict").inner_text()


def test_another_maximum_is_said(open_page: Open, tmp_path: Path) -> None:
    page = open_page("check")
    page.locator("#scenario").select_option("two-cells")
    for top, is_said in ((100, True), (65535, True), (255, False)):
        file = tmp_path / f"{top}.pgm"
        file.write_text(f"P2\n2 1\n{top}\n0 {top}\n")
        page.set_input_files("#file", file)
        page.locator("#checked", has_text=f"{top}.pgm, ").wait_for()
        said = page.locator("#checked").inner_text()
        assert (f"maximum is {top}, not 255" in said) == is_said


def test_keys_in_a_picture_are_read_out(open_page: Open) -> None:
    """The description of what has the focus is not read again when it changes."""
    page = open_page("play", "#scan=30&mistake=no-clamp")
    for name, key, said in (
        ("map", "ArrowRight", "cell gx=110 gy=90, "),
        ("world", "ArrowRight", "The robot stands at x "),
        ("wrong", "ArrowUp", "cell gx=110 gy=91: "),
    ):
        page.locator(f"#{name}-view").focus()
        page.keyboard.press(key)
        page.wait_for_function(
            "said => document.querySelector('#announce').textContent.startsWith(said)",
            arg=said,
        )


def test_paper_is_white(open_page: Open) -> None:
    page = open_page("play", color_scheme="dark")
    ink = "getComputedStyle(document.body).color"
    assert page.evaluate(ink) == "rgb(230, 233, 236)"
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate(ink) == "rgb(28, 36, 48)"
