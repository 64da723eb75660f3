"""Other projects use the library: installed, as a subfolder, and fetched.

The project has warnings of its own kind in it, a float made of a double, which the port's flags would not let pass.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from building import PORT, arguments, must

PROGRAM = """
#include <occgrid/fast.hpp>
#include <occgrid/lesson.hpp>
#include <occgrid/map_writer.hpp>

#include <iostream>

int main() {
  float f = 0.1;  // -Wconversion -Werror would end the build here
  const auto grid =
      occgrid::map_scenario_fast(occgrid::lesson_scenario(), std::nullopt, 2);
  occgrid::map_pgm(grid, std::cout);
  return f > 1.0f;
}
"""

PROJECT = """
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES CXX)
{use}
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE occgrid::occgrid)
"""

INSTALLED = "find_package(occgrid 1 REQUIRED)"
SUBFOLDER = f'add_subdirectory("{PORT}" occgrid)'
FETCHED = f"""
include(FetchContent)
FetchContent_Declare(occgrid SOURCE_DIR "{PORT}")
FetchContent_MakeAvailable(occgrid)
"""


def build(folder: Path, use: str, settings: list[str]) -> Path:
    """The consumer's build folder."""
    folder.mkdir()
    (folder / "consumer.cpp").write_text(PROGRAM)
    (folder / "CMakeLists.txt").write_text(PROJECT.format(use=use))
    must(["cmake", "-S", folder, "-B", folder / "build", *settings])
    must(["cmake", "--build", folder / "build", "--target", "consumer"])
    return folder / "build"


def expect(holds: bool, what: str) -> None:
    print(f"{'ok' if holds else 'FAILED'}: {what}", flush=True)
    if not holds:
        raise SystemExit(1)


def main() -> None:
    options = arguments()
    settings = [f"-DCMAKE_CXX_COMPILER={options.compiler}"]
    lesson = must([options.build / "occgrid", "--noise-free"])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        prefix = folder / "prefix"
        must(["cmake", "--build", options.build, "--target", "occgrid"])
        must(["cmake", "--install", options.build, "--prefix", prefix])
        expect((prefix / "bin" / "occgrid").is_file(), "the program is there")
        headers = {path.name for path in prefix.glob("include/occgrid/*")}
        own = {path.name for path in PORT.glob("include/occgrid/*.hpp")}
        expect(headers == own, "the headers lie under occgrid/, and no others")

        found = build(
            folder / "installed",
            INSTALLED,
            [*settings, f"-DCMAKE_PREFIX_PATH={prefix}"],
        )
        expect(must([found / "consumer"]) == lesson, "installed")

        # the flags of the port are not the consumer's
        command = (found / "CMakeFiles/consumer.dir/flags.make").read_text()
        expect(
            "-Werror" not in command and "-Wconversion" not in command,
            "no warnings are inherited",
        )

        for name, use in (("subfolder", SUBFOLDER), ("fetched", FETCHED)):
            found = build(folder / name, use, settings)
            expect(must([found / "consumer"]) == lesson, name)
            targets = must(["cmake", "--build", found, "--target", "help"])
            expect(
                "occgrid_tests" not in targets and "probe" not in targets,
                f"{name}: no tests",
            )


if __name__ == "__main__":
    main()
