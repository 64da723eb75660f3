"""play.html in a real browser: what it shows are the numbers of the other ports."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from pages_in_browser import (
    GOLDEN,
    ROOT,
    Open,
    drop_file,
    hash_of,
    log_odds_of,
    python_map,
)
from playwright.sync_api import Page

HASH = "occgridPage.hash()"


def golden(mode: str) -> list[str]:
    lines = (GOLDEN / f"lesson.{mode}.sha256").read_text().splitlines()
    return [line.split()[2] for line in lines]


def set_value(page: Page, name: str, value: object) -> None:
    """Moves a slider or fills a field, with the event that a hand makes."""
    page.locator(f"#{name}").evaluate(
        "(e, v) => { e.value = v;"
        " for (const n of ['input', 'change'])"
        " e.dispatchEvent(new Event(n, {bubbles: true})); }",
        str(value),
    )


def saved_scenario(page: Page, folder: Path) -> str:
    page.locator("details").nth(1).evaluate("e => { e.open = true; }")
    with page.expect_download() as download:
        page.locator("#download").click()
    path = folder / "saved.log"
    download.value.save_as(path)
    return path.read_text(encoding="ascii")


def words(page: Page, name: str) -> str:
    """A text, after the frames that map and draw what was done last."""
    page.evaluate(
        "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))"
    )
    page.wait_for_function("!occgridPage.busy()")
    return page.locator(f"#{name}").inner_text()


@pytest.mark.parametrize("mode", ["noise-free", "seed-0"])
def test_every_scan_has_the_golden_hash(open_page: Open, mode: str) -> None:
    page = open_page("play", "#noise=free" if mode == "noise-free" else "")
    found = page.evaluate(
        """() => { const { lab, hash } = occgridPage; const found = [];
        for (let s = 1; s <= lab.scans.length; s++) { lab.goTo(s); found.push(hash()); }
        return found; }"""
    )
    assert found == golden(mode)


def test_the_hash_is_printed_and_scans_can_be_gone_back(
    open_page: Open,
) -> None:
    page = open_page("play", "#scan=80")
    expected = golden("seed-0")
    for scan in (80, 44, 45):
        set_value(page, "scan", scan)
        page.locator("#hash", has_text=f"scan {scan},").wait_for()
        assert expected[scan - 1] in page.locator("#hash").inner_text()


def test_beam_by_beam_is_the_scan(open_page: Open) -> None:
    page = open_page("play", "#scan=2&beam=178")
    for beam in (179, 180, 181):
        page.locator("#beam-on").click()
        assert words(page, "beam-text") == f"beam {beam} of 181"
    assert page.evaluate(HASH) == golden("seed-0")[1]
    page.locator("#beam-on").click()
    assert words(page, "scan-text") == "scan 3 of 120"
    page.locator("#beam-back").click()
    page.locator("#beam-back").click()
    assert words(page, "beam-text") == "beam 180 of 181"
    assert page.evaluate(HASH) != golden("seed-0")[1]
    page.locator("#scan-on").click()
    assert page.evaluate(HASH) == golden("seed-0")[1]
    page.locator("#scan-back").click()
    assert page.evaluate(HASH) == golden("seed-0")[0]


def test_playing_ends_with_the_whole_map(open_page: Open) -> None:
    page = open_page("play", "#scan=100&noise=free")
    page.locator("#speed").select_option("scan 60")
    page.locator("#play").click()
    page.wait_for_function("occgridPage.lab.atEnd && !occgridPage.lab.playing")
    assert page.evaluate(HASH) == golden("noise-free")[-1]
    page.locator("#play").click()
    page.locator("#play").click()
    assert page.evaluate("occgridPage.lab.playing") is False


def hover(page: Page, canvas: str, gx: float, gy: float) -> None:
    """Put the mouse on a place of a grid of 220 x 180 cells, with some of the world around it."""
    view = page.locator(canvas)
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    pad = page.evaluate("occgridPage.lab.pad")
    # the border is one pixel
    scale = (box["width"] - 2) / (pad["left"] + 220 + pad["right"])
    page.mouse.move(
        box["x"] + 1 + (pad["left"] + gx) * scale,
        box["y"] + 1 + (pad["top"] + 180 - gy) * scale,
    )


def test_the_cell_under_the_mouse_is_that_of_the_files(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play", "#noise=free&scan=120")
    scenario = saved_scenario(page, tmp_path)
    log_odds = python_map(scenario, tmp_path, "--noise-free")
    pixels = (tmp_path / "scenario.pgm").read_text().split()[4:]
    for gx, gy in [
        (109, 90),
        (10, 95),
        (0, 0),
        (60, 110),
        (219, 179),
        (25, 60),
    ]:
        hover(page, "#map-view", gx + 0.5, gy + 0.5)
        said = words(page, "map-words")
        found = re.match(
            r"cell gx=(\d+) gy=(\d+), .*: log-odds (\S+), P\(occupied\) (\S+), pixel (\d+)\.",
            said,
        )
        assert found, said
        value = log_odds[gy, gx]
        assert (int(found[1]), int(found[2])) == (gx, gy)
        assert float(found[3]) == value
        assert float(found[4]) == pytest.approx(
            1 / (1 + np.exp(-value)), abs=5e-7
        )
        assert found[5] == pixels[(179 - gy) * 220 + gx]
        page.mouse.down()
        page.mouse.up()
        assert f"Log-odds {found[3]}, " in words(page, "cell-words")


# each control, moved once
MOVES = {
    "p_occ": 0.9,
    "p_free": 0.12,
    "p0": 0.35,
    "l_min": -3.5,
    "l_max": 2.25,
    "resolution": 0.25,
    "max_range": 4.5,
    "noise_std": 0.11,
    "seed": 4294967295,
}


@pytest.mark.parametrize("control", MOVES)
def test_a_control_does_what_the_parameter_does(
    open_page: Open, tmp_path: Path, control: str
) -> None:
    page = open_page("play", "#scan=120")
    set_value(page, control, MOVES[control])
    scenario = saved_scenario(page, tmp_path)
    seed = "0"
    if control == "seed":
        seed = str(MOVES[control])
    else:
        assert f"PARAM occgrid_{control} {MOVES[control]}\n" in scenario
        shown = words(page, f"{control}-value").replace("\u2212", "-")
        assert shown.split()[0] == str(MOVES[control])
    expected = python_map(scenario, tmp_path, "--seed", seed)
    found = page.evaluate(HASH)
    assert found == hash_of(expected)
    assert found != golden("seed-0")[-1]


@pytest.mark.parametrize(
    ("preset", "p_occ", "p_free"), [("weak", 0.6, 0.4), ("strong", 0.9, 0.1)]
)
def test_problem_5(
    open_page: Open, tmp_path: Path, preset: str, p_occ: float, p_free: float
) -> None:
    page = open_page("play", "#scan=120")
    page.locator(f"[data-preset={preset}]").click()
    scenario = saved_scenario(page, tmp_path)
    assert f"PARAM occgrid_p_occ {p_occ}\n" in scenario
    assert f"PARAM occgrid_p_free {p_free}\n" in scenario
    assert page.evaluate(HASH) == hash_of(python_map(scenario, tmp_path))
    page.locator("[data-preset=lesson]").click()
    assert page.evaluate(HASH) == golden("seed-0")[-1]


def test_noise_and_no_return(open_page: Open, tmp_path: Path) -> None:
    page = open_page("play", "#scan=120&max_range=6")
    page.locator("#no-return").select_option("ignore")
    scenario = saved_scenario(page, tmp_path)
    assert "PARAM occgrid_no_return ignore\n" in scenario
    assert page.evaluate(HASH) == hash_of(python_map(scenario, tmp_path))
    page.locator("#noise-free").check()
    expected = python_map(scenario, tmp_path, "--noise-free")
    assert page.evaluate(HASH) == hash_of(expected)


def test_what_is_not_possible_is_said(open_page: Open) -> None:
    page = open_page("play", "#l_min=-0.25")
    set_value(page, "p0", 0.1)
    assert "Not possible" in words(page, "settings-words")
    assert page.evaluate("occgridPage.lab.world.settings.p0") == 0.5
    set_value(page, "p0", 0.5)
    assert words(page, "settings-words") == ""


def drag(
    page: Page, start: tuple[float, float], to: tuple[float, float]
) -> None:
    """From one place of the world to another, metres."""
    for i, (x, y) in enumerate((start, to)):
        hover(page, "#world-view", (x + 11) * 10, (y + 9) * 10)
        if i == 0:
            page.mouse.down()
    page.mouse.up()


def test_walls_drawn_moved_typed_and_removed(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play", "#scan=120&noise=free")

    def compare() -> str:
        scenario = saved_scenario(page, tmp_path)
        expected = python_map(scenario, tmp_path, "--noise-free")
        assert page.evaluate(HASH) == hash_of(expected)
        return scenario

    assert compare().count("WALL") == 6
    page.locator("[data-tool=draw]").click()
    drag(page, (-5.0, -3.0), (-2.0, -4.0))
    assert "WALL -5 -3 -2 -4\n" in compare()
    page.locator("[data-tool=wall]").click()
    drag(page, (-2.0, -4.0), (-1.0, -5.0))
    assert "WALL -5 -3 -1 -5\n" in compare()
    drag(page, (-3.0, -4.0), (-3.0, -3.0))
    assert "WALL -5 -2 -1 -4\n" in compare()
    field = page.get_by_label("x0 of wall 5")
    field.fill("1.5")
    field.press("Tab")
    assert "WALL 1.5 -6 0 6\n" in compare()
    page.get_by_label("Remove wall 6").click()
    assert "WALL -8 2 -2 2\n" not in compare()


def test_a_wall_is_added_a_file_dropped_and_the_lesson_restored(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play", "#scan=120&noise=free")
    scenario = saved_scenario(page, tmp_path)
    page.locator("#add-wall").click()
    added = saved_scenario(page, tmp_path)
    assert added == scenario.replace("\nPOSE", "\nWALL -1 0 1 0\nPOSE", 1), (
        added
    )
    expected = python_map(added, tmp_path, "--noise-free")
    assert page.evaluate(HASH) == hash_of(expected)
    drop_file(page, "#drop", ROOT / "scenarios" / "outside.log")
    page.locator("#file-words", has_text="outside.log: ").wait_for()
    page.evaluate("occgridPage.lab.goTo(occgridPage.lab.scans.length)")
    last = (GOLDEN / "outside.noise-free.sha256").read_text().split()[-1]
    assert page.evaluate(HASH) == last
    page.locator("#restore").click()
    page.evaluate("occgridPage.lab.goTo(120)")
    assert page.evaluate(HASH) == golden("noise-free")[-1]


@pytest.mark.parametrize(
    ("box", "canvas"),
    [("show-changes", "map-view"), ("show-differences", "wrong-view")],
)
def test_marks_can_be_switched_off(
    open_page: Open, box: str, canvas: str
) -> None:
    """Without them a picture is grey but for its frames and the robot."""
    page = open_page("play", "#scan=30&mistake=hit-also-free")

    def coloured() -> int:
        words(page, "map-words")
        count = page.locator(f"#{canvas}").evaluate(
            "e => { const { width, height } = e;"
            " const { data } = e.getContext('2d').getImageData(0, 0, width, height);"
            " let n = 0; for (let i = 0; i < data.length; i += 4)"
            " n += data[i] !== data[i + 1] || data[i] !== data[i + 2]; return n; }"
        )
        return int(count)

    marked = coloured()
    page.locator(f"#{box}").uncheck()
    assert coloured() < marked / 4
    page.locator(f"#{box}").check()
    assert coloured() == marked


def test_the_cell_and_what_if_follow_when_a_slider_rests(
    open_page: Open,
) -> None:
    """They wait while it moves."""
    page = open_page("play", "#scan=120&cell=99,111&mistake=hit-also-free")
    before = words(page, "cell-words"), words(page, "difference-words")
    for control, value in (("l_min", -7), ("l_min", -6), ("p_occ", 0.9)):
        set_value(page, control, value)
    # the values come to rest one after the other
    page.wait_for_function(
        "old => { const said = document.querySelector('#cell-words').innerText;"
        " const now = occgridPage.lab.maps().now[111 * 220 + 99];"
        " return said !== old[0] && said.includes(`Log-odds ${now}, `)"
        " && document.querySelector('#difference-words').innerText !== old[1]; }",
        arg=list(before),
    )


def test_the_map_says_that_it_is_behind(open_page: Open) -> None:
    """The world follows at once; the map is then that of now, and says no more."""
    page = open_page("play", "#scan=120&noise=free")
    before = words(page, "map-words")
    page.wait_for_function("document.querySelector('#map-late').hidden")
    late = page.evaluate(
        """() => {
        const { lab, stage } = occgridPage;
        const said = (id) => document.getElementById(id).innerText;
        let time = performance.now();
        performance.now = () => (time += 10); // every look at the clock ends a slice
        lab.set({ maxRange: 5 });
        stage.frame();
        delete performance.now;
        return { behind: !document.querySelector('#map-late').hidden,
          busy: document.querySelector('#cell').getAttribute('aria-busy'),
          world: said('world-words'), map: said('map-words') };
        }"""
    )
    assert late["behind"] is True
    assert late["busy"] == "true"
    assert late["world"].endswith("within 5 m.")
    assert late["map"] == before
    after = words(page, "map-words")
    page.wait_for_function("document.querySelector('#map-late').hidden")
    value = page.evaluate("occgridPage.lab.maps().now[90 * 220 + 109]")
    assert after != before
    assert f"log-odds {value:g}, " in after
    assert page.locator("#cell").get_attribute("aria-busy") == "false"
    assert f"Log-odds {value:g}, " in words(page, "cell-words")


def test_what_is_out_of_sight_is_drawn_when_it_comes_into_sight(
    open_page: Open,
) -> None:
    page = open_page("play", "#scan=1&noise=free&mistake=hit-also-free")
    page.evaluate("scrollTo(0, 0)")
    page.locator("#speed").select_option("scan 5")
    page.wait_for_function("!occgridPage.busy()")
    page.locator("#play").click()
    page.wait_for_function("occgridPage.lab.scan > 4")
    said = "document.querySelector('#difference-words').innerText"
    assert page.evaluate(said).endswith(" after 1 scan, 1 in their log-odds.")
    page.locator("#what-if").scroll_into_view_if_needed()
    page.wait_for_function(
        f"/ after [2-9][0-9]* scans,/.test({said}) && occgridPage.lab.playing"
    )


def test_the_robot_is_dragged_turned_and_put_back(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play", "#scan=30&noise=free")
    scenario = saved_scenario(page, tmp_path)
    before = page.evaluate(HASH)
    pose = page.evaluate("occgridPage.lab.scans[29].pose")
    drag(page, (pose["x"], pose["y"]), (4.0, -3.0))
    free = page.evaluate("occgridPage.lab.free")
    assert free["x"] == pytest.approx(4.0, abs=0.05)
    assert free["y"] == pytest.approx(-3.0, abs=0.05)
    assert free["theta"] == pose["theta"]
    page.locator("#world-view").focus()
    for key in ("e", "E", "Shift+ArrowUp", "ArrowLeft"):
        page.keyboard.press(key)
    free = page.evaluate("occgridPage.lab.free")
    # the map is that of 30 scans and one from where the robot stands now
    lines = scenario.splitlines()
    poses = [line for line in lines if line.startswith("POSE")]
    parts = [line for line in lines if not line.startswith("POSE")]
    parts += [
        *poses[:30],
        f"POSE {free['x']!r} {free['y']!r} {free['theta']!r}",
    ]
    expected = python_map("\n".join(parts) + "\n", tmp_path, "--noise-free")
    assert page.evaluate(HASH) == hash_of(expected) != before
    page.keyboard.press("Escape")
    assert page.evaluate("occgridPage.lab.free") is None
    assert page.evaluate(HASH) == before


def test_a_line_step_by_step(open_page: Open) -> None:
    page = open_page("play", "#line=2,1,13,6")
    current = page.locator("#listing [aria-current]")
    seen = []
    e2_seen = 0
    for _ in range(200):
        line = current.inner_text().strip()
        seen.append(line)
        variables = page.locator("#variables").inner_text().split("\n")
        values = dict(v.split(" = ") for v in variables if v)
        if line.startswith("const e2"):
            e2_seen += 1
            assert int(values["e2"]) == 2 * int(values["err"])
        if not page.locator("#line-on").is_enabled():
            break
        page.locator("#line-on").press("Enter")
        page.evaluate("new Promise(r => requestAnimationFrame(r))")
    assert seen[0] == "const dx = Math.abs(gx1 - gx0);"
    assert seen[-1] == "return cells;"
    assert e2_seen == 11
    assert seen.count("cells.push({ gx, gy });") == 11
    assert "12 cells. 12 of them" in words(page, "line-words")
    page.locator("#line-start").click()
    page.locator("#cell-on").click()
    assert words(page, "line-happened") == "the first cell is (2, 1)"
    page.locator("#gx1").fill("2")
    page.locator("#gx1").press("Tab")
    assert "to (2, 6), 6 cells" in words(page, "line-words")
    page.locator("#line-of-beam").click()
    assert words(page, "line-words").startswith("Beam 181 of scan 24")


def test_the_cells_updates_are_those_of_the_map(open_page: Open) -> None:
    page = open_page("play", "#cell=99,111&scan=120")
    said = words(page, "cell-words")
    log_odds = page.evaluate(
        "occgridPage.lab.maps().now[111 * 220 + 99].toString()"
    )
    assert f"Log-odds {log_odds}, " in said
    rows = page.locator("#updates tbody tr")
    count = int(re.search(r"of (\d+) so far", said)[1])  # type: ignore[index]
    assert rows.count() == count > 20
    # a click goes there: the map has the row's value from this beam on
    row = rows.nth(10)
    value = row.locator("td").nth(2).inner_text().replace("\u2212", "-")
    scan, beam = row.locator("button").inner_text().split(", ")
    row.locator("button").click()
    assert words(page, "scan-text") == f"scan {scan} of 120"
    assert words(page, "beam-text") == f"beam {beam} of 181"
    there = page.evaluate("occgridPage.lab.maps().now[111 * 220 + 99]")
    assert there == pytest.approx(float(value), abs=5e-5)
    page.locator("#beam-back").click()
    earlier = page.evaluate("occgridPage.lab.maps().now[111 * 220 + 99]")
    assert earlier != there or abs(there) == 8


def test_addresses_open_a_state_and_follow_it(open_page: Open) -> None:
    page = open_page(
        "play",
        "#scan=45&beam=90&seed=7&p_occ=0.8&mistake=hit-also-free&cell=12,34",
    )
    lab = page.evaluate(
        "(({scan, beam, seed, cell, mistakes, world}) =>"
        " [scan, beam, seed, cell, [...mistakes], world.settings.pOcc])(occgridPage.lab)"
    )
    assert lab == [45, 90, 7, {"gx": 12, "gy": 34}, ["hit-also-free"], 0.8]
    page.locator("#beam-on").click()
    page.wait_for_function("location.hash.includes('beam=91')")
    assert "cell=12,34" in page.url
    page.evaluate("location.hash = '#line=0,0,7,3&step=9'")
    page.wait_for_function("occgridPage.lab.step === 9")
    # the page scrolls smoothly, from the next frame on
    page.wait_for_function(
        "Math.abs(document.querySelector('#line').getBoundingClientRect().top) < 500"
    )


def test_a_log_without_our_parameters_gets_a_grid(
    open_page: Open, tmp_path: Path
) -> None:
    page = open_page("play", "#noise=free")
    page.locator("details").nth(1).evaluate("e => { e.open = true; }")
    beams = " ".join(["4.0"] * 180)
    log = "".join(
        f"FLASER 180 {beams} {x} 1.5 0.25 {x} 1.5 0.25 0 host 0\n"
        for x in (0, 0.5, 1)
    )
    (tmp_path / "real.log").write_text("# a log\nPARAM other 1\n" + log)
    page.set_input_files("#file", tmp_path / "real.log")
    page.locator("#file-words", has_text="3 scans").wait_for()
    set_value(page, "scan", 3)
    scenario = saved_scenario(page, tmp_path)
    log_odds = python_map(scenario, tmp_path, "--noise-free")
    assert page.evaluate(HASH) == hash_of(log_odds)
    assert np.unique(log_odds).size > 3
    (tmp_path / "bad.log").write_text("WALL 1 2 3\n")
    page.set_input_files("#file", tmp_path / "bad.log")
    page.locator("#file-words", has_text="bad.log:1: WALL takes 4").wait_for()
    (tmp_path / "none.log").write_text(scenario.split("FLASER")[0])
    page.set_input_files("#file", tmp_path / "none.log")
    page.locator("#file-words", has_text=": no scan").wait_for()
    assert page.evaluate(HASH) == hash_of(log_odds)


def test_keys_choose_a_cell(open_page: Open) -> None:
    page = open_page("play")
    page.locator("#map-view").focus()
    for key in ("ArrowRight", "ArrowUp", "Shift+ArrowLeft", "Enter"):
        page.keyboard.press(key)
    assert "cell gx=100 gy=91," in words(page, "map-words")
    assert words(page, "cell-words").startswith("Cell gx=100 gy=91:")


def test_a_finger_chooses_a_cell_and_moves_the_robot(
    open_page: Open,
) -> None:
    page = open_page(
        "play",
        "#scan=30&noise=free",
        viewport={"width": 390, "height": 800},
        has_touch=True,
        is_mobile=True,
    )
    view = page.locator("#map-view")
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + 40)
    left = page.evaluate("occgridPage.lab.pad.left")
    assert f"Cell gx={(220 + left) // 2 - left} " in words(page, "cell-words")
    assert page.evaluate("document.documentElement.scrollWidth") == 390


def test_the_robot_is_seen_and_dragged_outside_the_grid(
    open_page: Open, tmp_path: Path
) -> None:
    """The pictures show as much of the world as the path needs."""
    page = open_page("play", "#scan=60&noise=free")
    assert page.evaluate("occgridPage.lab.pad") == {
        "left": 15,
        "right": 0,
        "bottom": 0,
        "top": 0,
    }
    pose = page.evaluate("occgridPage.lab.scans[59].pose")
    assert pose["x"] < -11.9
    drag(page, (pose["x"], pose["y"]), (pose["x"] + 1.0, pose["y"]))
    free = page.evaluate("occgridPage.lab.free")
    assert free["x"] == pytest.approx(pose["x"] + 1.0, abs=0.05)


def test_keys_of_the_world_play_and_step(open_page: Open) -> None:
    page = open_page("play", "#scan=2&beam=179&noise=free")
    page.locator("#world-view").focus()
    page.keyboard.press(".")
    page.keyboard.press(".")
    assert page.evaluate(HASH) == golden("noise-free")[1]
    page.keyboard.press(",")
    assert words(page, "beam-text") == "beam 180 of 181"
    page.keyboard.press("Space")
    page.wait_for_function("occgridPage.lab.scan > 3")
    page.keyboard.press("Space")
    assert page.evaluate("occgridPage.lab.playing") is False


def test_reduced_motion_plays_slowly(open_page: Open) -> None:
    page = open_page("play", reduced_motion="reduce")
    assert page.locator("#speed").input_value() == "scan 1"


def test_the_files_are_small_and_alone(pages: Path) -> None:
    for name in ("play", "check"):
        text = (pages / f"{name}.html").read_text(encoding="utf-8")
        assert len(text.encode()) < 500_000
        assert not re.search(r"(src|href)\s*=\s*[\"']?(?!#)[a-z./]", text)
        assert "https://" not in text


def test_log_odds_files_are_read_as_they_are(tmp_path: Path) -> None:
    """The helper of these tests."""
    (tmp_path / "a.logodds").write_text("# logodds 2 1\n0.1 -8\n")
    assert log_odds_of(tmp_path / "a.logodds").tolist() == [[0.1, -8.0]]
