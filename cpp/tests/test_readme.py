"""The examples of README.md run as they are printed, and print what it says."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from building import PORT, arguments, must, run

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n", re.MULTILINE | re.DOTALL)


def main() -> None:
    options = arguments()
    blocks = BLOCK.findall((PORT / "README.md").read_text(encoding="utf-8"))
    program = next(text for kind, text in blocks if kind == "cpp")
    project = next(text for kind, text in blocks if kind == "cmake")
    printed = next(text for kind, text in blocks if kind == "text")
    by_hand = next(
        text for kind, text in blocks if kind == "sh" and "-loccgrid" in text
    )
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        prefix = folder / "prefix"
        must(["cmake", "--install", options.build, "--prefix", prefix])
        (folder / "maps.cpp").write_text(program)
        (folder / "CMakeLists.txt").write_text(project)
        must(
            [
                "cmake",
                "-S",
                folder,
                "-B",
                folder / "build",
                f"-DCMAKE_CXX_COMPILER={options.compiler}",
                f"-DCMAKE_PREFIX_PATH={prefix}",
            ]
        )
        must(["cmake", "--build", folder / "build"])
        compiled = by_hand.replace("PREFIX", str(prefix))
        compiled = compiled.replace("g++", options.compiler)
        must(["sh", "-ec", compiled], folder)
        for one in (folder / "build" / "maps", folder / "maps"):
            # from the repository's root, as README.md says
            status, text = run([one], PORT.parent)
            drawn = PORT.parent / "lesson-difference.pgm"
            made = drawn.is_file() and drawn.read_bytes()[:3] == b"P2\n"
            drawn.unlink(missing_ok=True)
            if status != 0 or text != printed or not made:
                raise SystemExit(
                    f"FAILED: {one} ended with {status}:\n{text}"
                    f"instead of\n{printed}"
                )
        print("ok: the example, by CMake and by hand")


if __name__ == "__main__":
    main()
