"""Both pages in Debian's Firefox, headless, from a folder: maps, a drag by the mouse, a verdict by a worker.

    ../.venv/bin/python tests/look_in_firefox.py

Speaks with Firefox by its Marionette protocol, so it needs no driver. Ends with status 1 if anything is not as it
should be.
"""

from __future__ import annotations

import json
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from pages_in_browser import GOLDEN, build_pages

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
HASHES = """const { lab, hash } = occgridPage;
return lab.poses.map((_, i) => { lab.goTo(i + 1); return hash(); });"""
# where a place of the world is in the window
PIXEL = """const [x, y] = arguments;
const { lab, figures } = occgridPage;
const { originX, originY, resolution } = lab.world.settings;
const { canvas } = figures.world.view;
canvas.scrollIntoView({ behavior: "instant" });
const box = canvas.getBoundingClientRect();
const at = figures.world.view.at((x - originX) / resolution, (y - originY) / resolution);
return [box.left + canvas.clientLeft + at.x, box.top + canvas.clientTop + at.y].map(Math.round);"""
FRAMES = """const [done] = arguments;
requestAnimationFrame(() => requestAnimationFrame(done));"""
# in a script of the page's own: what the driver runs has another window
COUNT_WORKERS = """const script = document.createElement("script");
script.textContent = `const Plain = Worker;
window.answers = 0;
window.Worker = class extends Plain {
  constructor(address) {
    super(address);
    this.addEventListener("message", () => { document.body.dataset.answers = ++answers; });
  }
};`;
document.body.append(script);"""
VERDICT = """const { dataset, innerText } = document.querySelector("#verdict");
return [dataset.status ?? "working", innerText, Number(document.body.dataset.answers ?? 0)];"""


class Firefox:
    """One session."""

    def __init__(self, port: int) -> None:
        self.connection = socket.create_connection(("127.0.0.1", port), 60)
        self.file = self.connection.makefile("rb")
        self.number = 0
        self.read()
        self.call("WebDriver:NewSession")

    def read(self) -> Any:
        length = b""
        while (byte := self.file.read(1)) != b":":
            length += byte
        return json.loads(self.file.read(int(length)))

    def call(self, command: str, **parameters: object) -> Any:
        self.number += 1
        message = json.dumps([0, self.number, command, parameters]).encode()
        self.connection.sendall(b"%d:%b" % (len(message), message))
        _, _, error, result = self.read()
        if error:
            raise RuntimeError(f"{command}: {error}")
        if isinstance(result, dict) and result.keys() == {"value"}:
            return result["value"]
        return result

    def open(self, page: Path, address: str = "") -> None:
        self.call("WebDriver:Navigate", url=page.as_uri() + address)

    def run(self, script: str, *arguments: object) -> Any:
        return self.call(
            "WebDriver:ExecuteScript", script=script, args=arguments
        )

    def frames(self) -> None:
        self.call("WebDriver:ExecuteAsyncScript", script=FRAMES, args=[])

    def drag(self, start: list[int], end: list[int]) -> None:
        """By the mouse, in ten moves."""
        moves: list[dict[str, object]] = []
        for i in range(11):
            x, y = (
                a + (b - a) * i // 10 for a, b in zip(start, end, strict=True)
            )
            moves.append({"type": "pointerMove", "x": x, "y": y})
            if i == 0:
                moves.append({"type": "pointerDown", "button": 0})
        moves.append({"type": "pointerUp", "button": 0})
        mouse = {"type": "pointer", "id": "mouse", "actions": moves}
        self.call("WebDriver:PerformActions", actions=[mouse])

    def choose(self, field: str, file: Path) -> None:
        element = self.call(
            "WebDriver:FindElement", using="css selector", value=field
        )
        (name,) = element.values()
        self.call("WebDriver:ElementSendKeys", id=name, text=str(file))


@contextmanager
def firefox() -> Iterator[Firefox]:
    if FIREFOX is None:
        raise SystemExit("firefox is missing: apt-get install firefox-esr")
    with tempfile.TemporaryDirectory() as folder:
        profile = Path(folder)
        (profile / "user.js").write_text('user_pref("marionette.port", 0);\n')
        process = subprocess.Popen(
            [FIREFOX, "--headless", "--marionette", "--profile", folder],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            port = profile / "MarionetteActivePort"
            end = time.monotonic() + 120.0
            while not (port.is_file() and port.read_text().strip()):
                if time.monotonic() > end or process.poll() is not None:
                    raise SystemExit("Firefox did not start")
                time.sleep(0.2)
            yield Firefox(int(port.read_text()))
        finally:
            process.terminate()
            process.wait()


failed = False


def report(what: str, right: bool) -> None:
    global failed
    failed = failed or not right
    print(f"{'right' if right else 'WRONG'}: {what}", flush=True)


def maps(browser: Firefox, pages: Path) -> None:
    for mode, address in {
        "noise-free": "noise=free",
        "seed-0": "seed=0",
    }.items():
        lines = (GOLDEN / f"lesson.{mode}.sha256").read_text().splitlines()
        browser.open(pages / "play.html", f"#{address}")
        browser.call("WebDriver:Refresh")
        right = sum(
            found == line.split()[2]
            for found, line in zip(browser.run(HASHES), lines, strict=True)
        )
        report(
            f"{right} of {len(lines)} maps of the lesson, {mode}",
            right == len(lines),
        )


def robot(browser: Firefox, pages: Path) -> None:
    """The robot, its handle, and a wall."""
    browser.open(pages / "play.html", "#scan=30&noise=free")
    browser.call("WebDriver:Refresh")
    browser.frames()
    before = browser.run("return occgridPage.hash()")
    pose = browser.run("return occgridPage.lab.poses[29]")
    browser.drag(
        browser.run(PIXEL, pose["x"], pose["y"]), browser.run(PIXEL, 4, -3)
    )
    browser.frames()
    free = browser.run("return occgridPage.lab.free")
    said = browser.run(
        "return document.querySelector('#world-words').innerText"
    )
    after = browser.run("return occgridPage.hash()")
    near = free and abs(free["x"] - 4) < 0.1 and abs(free["y"] + 3) < 0.1
    report(f"the robot dragged to (4, -3): {free}", bool(near))
    report(f"the page says: {said[:60]}", "stands at x 4.0" in said)
    report("another map", after != before)
    browser.run(
        "occgridPage.lab.free = null; document.querySelector('[data-tool=wall]').click();"
    )
    browser.drag(browser.run(PIXEL, -5, 2), browser.run(PIXEL, -5, 3))
    walls = browser.run("return occgridPage.lab.world.walls")
    # a mouse moves in whole pixels, of 4 cm here, and a wall by 5 cm
    y0, y1 = walls[5]["y0"], walls[5]["y1"]
    report(f"a wall dragged: {walls[5]}", y0 == y1 and abs(y1 - 3.0) < 0.06)


def verdicts(browser: Firefox, pages: Path) -> None:
    for name, status, words in (
        ("lesson.noise-free.pgm", "identical", "All 39,600 pixels"),
        ("lesson.seed-0.pgm", "differs", "with the noise of seed 0"),
    ):
        browser.open(pages / "check.html")
        browser.run(COUNT_WORKERS)
        browser.choose("#file", GOLDEN / name)
        end = time.monotonic() + 120.0
        found, said, answers = "working", "", 0
        while found == "working" and time.monotonic() < end:
            time.sleep(0.2)
            found, said, answers = browser.run(VERDICT)
        report(f"{name}: {found}", found == status and words in said)
        report(f"{answers} messages of a worker", answers > 0)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder, firefox() as browser:
        pages = Path(folder)
        build_pages(pages)
        browser.call("WebDriver:SetWindowRect", width=1280, height=1000)
        print(browser.run("return navigator.userAgent"))
        maps(browser, pages)
        robot(browser, pages)
        verdicts(browser, pages)
    sys.exit(failed)


if __name__ == "__main__":
    main()
