"""How long a frame of play.html takes while something is dragged, and while it plays.

    ../.venv/bin/python tests/measure_drag.py [SECONDS]     0: the script alone

In a headless Chromium, which draws by software. For each kind: frames a second; how many frames the map is behind
what is dragged; milliseconds of script in a frame, by the clock; and milliseconds a frame by the browser's own
counters, which other programs disturb less: script, with the mapping between frames, style and layout, and all that
its main thread does, painting included. Other threads put the picture together and are not counted. A frame is late
that comes more than 25 ms after the one before.
"""

from __future__ import annotations

import itertools
import math
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from pages_in_browser import ARGUMENTS, CHROMIUM, build_pages
from playwright.sync_api import CDPSession, Page, sync_playwright

FRAMES = """() => {
  window.frameTimes = [];
  const note = (now) => { frameTimes.push(now); requestAnimationFrame(note); };
  requestAnimationFrame(note);
}"""
# the page's drawing, figure by figure; and how many frames later the map of a run is seen than its world
FIGURES = """() => {
  const { figures, lab, stage } = occgridPage;
  window.figureTimes = {};
  window.frameScripts = [];
  window.behind = [];
  const timed = (name, figure, method) => {
    const draw = figure[method];
    figureTimes[name] = 0;
    figure[method] = (...given) => {
      const start = performance.now();
      const answer = draw.apply(figure, given);
      figureTimes[name] += performance.now() - start;
      return answer;
    };
  };
  for (const [name, figure] of Object.entries(figures)) timed(name, figure, "render");
  timed("mapping", lab, "mapOn");
  const moments = [];
  let shown = null;
  const { frame } = stage;
  stage.frame = () => {
    const start = performance.now();
    frame.call(stage);
    frameScripts.push(performance.now() - start);
    const count = frameTimes.length;
    const last = moments[moments.length - 1];
    if (!last || !lab.isNow(last.moment)) moments.push({ moment: lab.moment, count });
    if (lab.mapped === shown) return;
    shown = lab.mapped;
    const same = (one) => Object.keys(shown).every((key) => one.moment[key] === shown[key]);
    const seen = moments.find(same);
    if (seen) behind.push(count - seen.count);
  };
}"""


# The script of a frame by itself, over and over; with the whole map in each frame, or as much of it as a frame does.
SCRIPT = """([kind, scan, whole, times]) => {
  const { lab, stage } = occgridPage;
  lab.goTo(scan);
  const { x, y, theta } = lab.poses[scan - 1];
  const { walls } = lab.world;
  const Pose = lab.poses[0].constructor, Segment = walls[0].constructor;
  const acts = {
    robot: (i) => { lab.free = new Pose(x + Math.cos(i / 9), y + Math.sin(i / 9), theta); },
    wall: (i) => {
      const { x0, y0, x1, y1 } = walls[5];
      const up = Math.round(20 * Math.sin(i / 9)) / 20;
      lab.setWalls([...walls.slice(0, 5), new Segment(x0, y0 + up, x1, y1 + up)]);
    },
    slider: (i) => lab.set({ maxRange: 10 + 5 * Math.sin(i / 9) }),
  };
  const taken = [];
  for (let i = 0; i < times; i++) {
    const start = performance.now();
    acts[kind](i);
    if (whole) lab.mapOn(Infinity);
    stage.frame();
    taken.push(performance.now() - start);
  }
  return taken.sort((a, b) => a - b);
}"""


class Counters:
    """The browser's counters, in seconds, and the painting on the main thread from its trace."""

    def __init__(self, page: Page) -> None:
        self.session: CDPSession = page.context.new_cdp_session(page)
        self.session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def read(self) -> dict[str, float]:
        answer = self.session.send("Performance.getMetrics")
        return {one["name"]: one["value"] for one in answer["metrics"]}


def places(page: Page) -> Callable[[float, float], tuple[float, float]]:
    """The pixel of a place of the lesson's world, metres."""
    box = page.locator("#world-view").bounding_box()
    assert box is not None
    left, top = box["x"] + 1, box["y"] + 1
    pad = page.evaluate("occgridPage.lab.pad")
    scale = (box["width"] - 2) / (220 + pad["left"] + pad["right"])

    def pixel(x: float, y: float) -> tuple[float, float]:
        column, row = (x + 11.0) * 10.0, (9.0 - y) * 10.0
        return (
            left + (pad["left"] + column) * scale,
            top + (pad["top"] + row) * scale,
        )

    return pixel


def drag(page: Page, seconds: float, x: float, y: float) -> None:
    """From a place in the world around a circle, as fast as a mouse reports."""
    pixel = places(page)
    page.mouse.move(*pixel(x, y))
    page.mouse.down()
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0.0:
        turn = 2.0 * math.pi * left
        page.mouse.move(
            *pixel(x + 1.5 * math.cos(turn), y + 1.5 * math.sin(turn))
        )
        time.sleep(0.004)
    page.mouse.up()


def drag_robot(page: Page, seconds: float) -> None:
    pose = page.evaluate(
        "occgridPage.lab.scans[occgridPage.lab.scan - 1].pose"
    )
    drag(page, seconds, pose["x"], pose["y"])


def drag_wall(page: Page, seconds: float) -> None:
    page.locator("[data-tool=wall]").click()
    drag(page, seconds, -5.0, 2.0)


def drag_slider(page: Page, seconds: float) -> None:
    slider = page.locator("#max_range")
    slider.scroll_into_view_if_needed()
    box = slider.bounding_box()
    assert box is not None
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] / 3, y)
    page.mouse.down()
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0.0:
        part = 0.4 + 0.3 * math.sin(6.0 * left)
        page.mouse.move(box["x"] + part * box["width"], y)
        time.sleep(0.004)
    page.mouse.up()


def play(page: Page, seconds: float) -> None:
    page.locator("#speed").select_option("scan 60")
    page.locator("#play").click()
    time.sleep(min(seconds, 1.5))


KINDS: dict[str, tuple[Callable[[Page, float], None], int]] = {
    "robot, scan 24": (drag_robot, 24),
    "robot, scan 110": (drag_robot, 110),
    "wall, scan 24": (drag_wall, 24),
    "wall, scan 120": (drag_wall, 120),
    "slider, scan 24": (drag_slider, 24),
    "slider, scan 120": (drag_slider, 120),
    "playing, 60 scans a second": (play, 1),
}


SCRIPTS = [
    ("robot", 24),
    ("robot", 110),
    ("wall", 24),
    ("wall", 120),
    ("slider", 24),
    ("slider", 120),
]


def measure(page: Page, kind: str, seconds: float) -> str:
    act, scan = KINDS[kind]
    page.evaluate(f"location.hash = '#scan={scan}'")
    page.wait_for_timeout(500)
    act(page, 0.5)  # warm
    page.reload()
    page.wait_for_timeout(500)
    page.evaluate(FRAMES)
    page.evaluate(FIGURES)
    counters = Counters(page)
    before = counters.read()
    act(page, seconds)
    after = counters.read()
    taken = {name: after[name] - before[name] for name in after}
    times = page.evaluate("frameTimes")
    each = page.evaluate("figureTimes")
    scripts = sorted(page.evaluate("frameScripts"))
    behind = sorted(page.evaluate("behind"))
    frames = len(times)
    late = sum(b - a > 25.0 for a, b in itertools.pairwise(times))
    per = 1000.0 / frames
    figures = ", ".join(
        f"{name} {value / frames:.2f}"
        for name, value in each.items()
        if value / frames >= 0.05
    )
    lag = (
        f"map behind by {behind[len(behind) // 2]} frames, at most {behind[-1]}"
        if behind
        else "no map"
    )
    return (
        f"{kind:27} {frames / taken['Timestamp']:5.1f} frames/s, {late} late,"
        f" {len(behind) / taken['Timestamp']:5.1f} maps/s, {lag}; load {os.getloadavg()[0]:.1f};\n"
        f"    script of a frame: least {scripts[0]:.1f}, median {scripts[len(scripts) // 2]:.1f} ms;"
        f" ms a frame by the counters: script {taken['ScriptDuration'] * per:5.2f},"
        f" style and layout {(taken['LayoutDuration'] + taken['RecalcStyleDuration']) * per:5.2f},"
        f" all of the main thread {taken['TaskDuration'] * per:5.2f}\n    ms a frame: {figures}"
    )


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 3.0
    if CHROMIUM is None:
        raise SystemExit("chromium is missing: apt-get install chromium")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        build_pages(Path(folder))
        browser = driver.chromium.launch(
            executable_path=CHROMIUM, args=ARGUMENTS
        )
        print(f"Chromium {browser.version}")
        for kind, scan in SCRIPTS:
            page = browser.new_page(viewport={"width": 1280, "height": 1000})
            page.goto((Path(folder) / "play.html").as_uri())
            counters = Counters(page)
            for whole in (True, False):
                page.evaluate(SCRIPT, [kind, scan, whole, 100])  # warm
                before = counters.read()["TaskDuration"]
                taken = page.evaluate(SCRIPT, [kind, scan, whole, 300])
                spent = counters.read()["TaskDuration"] - before
                print(
                    f"script alone, {kind}, scan {scan}, {'whole map' if whole else 'as dragged'}:"
                    f" ms a frame {1000.0 * spent / len(taken):.1f} of the processor;"
                    f" by the clock least {taken[0]:.1f}, quarter {taken[len(taken) // 4]:.1f},"
                    f" median {taken[len(taken) // 2]:.1f}",
                    flush=True,
                )
            page.close()
        for kind in KINDS if seconds > 0.0 else ():
            page = browser.new_page(viewport={"width": 1280, "height": 1000})
            page.goto((Path(folder) / "play.html").as_uri())
            print(measure(page, kind, seconds), flush=True)
            page.close()
        browser.close()


if __name__ == "__main__":
    main()
